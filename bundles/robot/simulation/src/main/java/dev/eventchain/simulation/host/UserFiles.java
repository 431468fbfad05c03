package dev.eventchain.simulation.host;

import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;

/** Names of the user's files, which the process of the nodes knows by absolute paths. */
public record UserFiles(Path packageFolder) {

  /** Returns the folder of the generated package. */
  public SourceLocation folder() {
    return SourceLocation.of(packageFolder);
  }

  /** Returns a file relative to the folder as the user named it; unchanged if it is elsewhere. */
  String name(String file) {
    Path absolute = packageFolder.toAbsolutePath().normalize();
    if (file.isEmpty() || !Path.of(file).normalize().startsWith(absolute)) {
      return file;
    }
    Path relative = absolute.relativize(Path.of(file).normalize());
    return SourceLocation.of(packageFolder.resolve(relative)).file();
  }
}
