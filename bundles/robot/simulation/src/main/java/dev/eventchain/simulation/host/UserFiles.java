package dev.eventchain.simulation.host;

import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;

/**
 * Names of the user's files: the process that runs the nodes knows them by their absolute paths.
 */
public record UserFiles(Path packageFolder) {

  /** The folder of the generated package. */
  public SourceLocation folder() {
    return SourceLocation.of(packageFolder);
  }

  /** A file as the user named its folder; unchanged if it is somewhere else. */
  String name(String file) {
    Path absolute = packageFolder.toAbsolutePath().normalize();
    if (file.isEmpty() || !Path.of(file).normalize().startsWith(absolute)) {
      return file;
    }
    Path relative = absolute.relativize(Path.of(file).normalize());
    return SourceLocation.of(packageFolder.resolve(relative)).file();
  }
}
