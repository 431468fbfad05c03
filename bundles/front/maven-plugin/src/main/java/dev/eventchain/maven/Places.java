package dev.eventchain.maven;

import java.io.File;
import java.nio.file.Path;
import java.util.List;

/** Maven's files as people and reports name them. */
final class Places {

  private Places() {}

  /**
   * The file by its path from the folder that Maven was started in, where that is above it: reports
   * then say the same on every machine. Otherwise by its whole path.
   */
  static Path shown(File file) {
    Path whole = file.toPath().toAbsolutePath().normalize();
    Path start = Path.of("").toAbsolutePath();
    return whole.startsWith(start) ? start.relativize(whole) : whole;
  }

  /** As above, for each. */
  static List<Path> shown(List<File> files) {
    return files.stream().map(Places::shown).toList();
  }
}
