package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The files that a scenario may lead to: those below a root.
 *
 * @param root the folder that nothing outside of is read
 * @param folder the folder that paths are relative to
 */
record Folder(Path root, Path folder) {

  /**
   * Returns the file or folder of a path, which may have {@code \} between its parts.
   *
   * @throws DiagnosticException (FINDINGS) if it is outside the root, also through a link
   */
  Path find(String written, SourceLocation place) {
    try {
      Path found = folder.resolve(written.strip().replace('\\', '/')).normalize();
      if (isInside(found)) {
        return found;
      }
    } catch (InvalidPathException e) {
      throw Findings.refused(DocumentRules.PATH, "`" + written + "` is not a path.", place, "");
    }
    throw Findings.refused(
        DocumentRules.PATH,
        "`" + written + "` leads out of `" + SourceLocation.of(root).file() + "`.",
        place,
        "Copy what it leads to into that folder, or name a root that has both.");
  }

  /**
   * Returns a file likewise, if its name says that it may be a scenario or a road map: of others
   * nothing is read, not even for a finding.
   */
  Path file(String written, SourceLocation place) {
    Path found = find(written, place);
    if (!isReadable(found)) {
      throw Findings.refused(
          DocumentRules.PATH,
          "`" + written + "` is not named as a scenario or a road map.",
          place,
          "Its name has to end in .xosc, .xodr or .xml.");
    }
    return found;
  }

  /** Returns whether a name is that of a scenario or a road map. */
  static boolean isReadable(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).matches(".*\\.(xosc|xodr|xml)");
  }

  private boolean isInside(Path found) {
    Path top = real(root);
    Path existing = found.toAbsolutePath().normalize();
    while (existing.getParent() != null && Files.notExists(existing)) {
      existing = existing.getParent();
    }
    return found.toAbsolutePath().normalize().startsWith(root.toAbsolutePath().normalize())
        && (real(existing).startsWith(top) || Files.notExists(root));
  }

  private static Path real(Path path) {
    try {
      return path.toRealPath();
    } catch (IOException e) {
      return path.toAbsolutePath().normalize();
    }
  }
}
