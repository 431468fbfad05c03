package dev.eventchain.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Folders to which references between files of models may lead, besides those of the named files.
 *
 * @param roots folders, such as that of a workspace or a repository
 * @param map the folders by the reference prefixes that they replace, such as {@code
 *     platform:/resource/}
 */
public record ReferenceFolders(List<Path> roots, Map<String, Path> map) {

  /** Nowhere else. */
  public static final ReferenceFolders NONE = new ReferenceFolders(List.of(), Map.of());

  /**
   * Checks that the roots are folders.
   *
   * @throws DiagnosticException INPUT for the first that is none
   */
  public ReferenceFolders {
    roots = List.copyOf(roots);
    for (Path root : roots) {
      if (!Files.isDirectory(root)) {
        throw new DiagnosticException(
            DiagnosticException.Reason.INPUT,
            Diagnostic.of(FileRules.MISSING, "There is no such folder.", SourceLocation.of(root)));
      }
    }
    map = Collections.unmodifiableMap(new LinkedHashMap<>(map));
  }

  /** Returns the folders of files and then these. */
  public List<Path> after(Collection<Path> files) {
    return Stream.concat(files.stream().map(file -> file.resolveSibling("")), roots.stream())
        .distinct()
        .toList();
  }
}
