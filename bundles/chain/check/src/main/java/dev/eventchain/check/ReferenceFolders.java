package dev.eventchain.check;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Where references between files of models may lead, besides the folders of the named files.
 *
 * @param roots folders, such as that of a workspace or a repository
 * @param map the folders by the reference prefixes that they replace, such as {@code
 *     platform:/resource/}
 */
public record ReferenceFolders(List<Path> roots, Map<String, Path> map) {

  /** Nowhere else. */
  public static final ReferenceFolders NONE = new ReferenceFolders(List.of(), Map.of());

  public ReferenceFolders {
    roots = List.copyOf(roots);
    map = Map.copyOf(map);
  }

  /** Returns the folders of files and then these. */
  public List<Path> after(Collection<Path> files) {
    return Stream.concat(files.stream().map(file -> file.resolveSibling("")), roots.stream())
        .distinct()
        .toList();
  }
}
