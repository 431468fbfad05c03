package dev.eventchain.maven;

import java.io.File;
import java.nio.file.Path;
import java.util.List;

/** Paths of Maven's files for people and reports. */
final class Places {

  private Places() {}

  /**
   * Returns the file relative to the folder that Maven was started in, if it is below: reports are
   * then the same on every machine. Otherwise returns the full path.
   */
  static Path shown(File file) {
    Path whole = file.toPath().toAbsolutePath().normalize();
    Path start = Path.of("").toAbsolutePath();
    return whole.startsWith(start) ? start.relativize(whole) : whole;
  }

  /** As above, for several files. */
  static List<Path> shown(List<File> files) {
    return files.stream().map(Places::shown).toList();
  }
}
