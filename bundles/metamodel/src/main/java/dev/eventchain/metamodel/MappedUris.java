package dev.eventchain.metamodel;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.common.util.URI;

/**
 * Which files references mean that begin as people agreed that they do: {@code
 * platform:/resource/PROJECT/PATH} names a file in a workspace of Eclipse, wherever that lies.
 */
final class MappedUris {

  private static final List<String> PLATFORM = List.of("platform:/resource/", "platform:/plugin/");

  private final Map<String, Path> map;

  /** The longest beginning wins. */
  MappedUris(Map<String, Path> map) {
    this.map = map;
  }

  /** What to do about a reference that is not followed. */
  static String hint(String reference) {
    return PLATFORM.stream()
        .filter(reference::startsWith)
        .findFirst()
        .map(prefix -> "Say where such files are: --map " + prefix + "=FOLDER/")
        .orElse("Refer to files in the project's folder by a relative path.");
  }

  /**
   * The file that a reference means, without its fragment.
   *
   * @param base the file that holds the reference
   * @return empty if the reference is one as any other
   */
  Optional<Path> fileOf(Path base, String reference) {
    Optional<String> prefix =
        map.keySet().stream()
            .filter(reference::startsWith)
            .max(Comparator.comparingInt(String::length));
    try {
      return prefix.isPresent()
          ? Optional.of(below(map.get(prefix.get()), reference.substring(prefix.get().length())))
          : inWorkspace(base, reference);
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private static Path below(Path folder, String path) {
    String relative = URI.decode(path);
    return folder.resolve(relative.replaceFirst("^/+", "")).toAbsolutePath().normalize();
  }

  /** The project is a folder beside the file, or beside or among the folders that it is in. */
  private static Optional<Path> inWorkspace(Path base, String reference) {
    Optional<String> prefix = PLATFORM.stream().filter(reference::startsWith).findFirst();
    if (prefix.isEmpty()) {
      return Optional.empty();
    }
    String path = reference.substring(prefix.get().length());
    String project = URI.decode(path.replaceFirst("/.*", ""));
    for (Path up = base.getParent(); up != null; up = up.getParent()) {
      if (up.endsWith(project) && Files.exists(below(up.resolveSibling(""), path))) {
        return Optional.of(below(up.resolveSibling(""), path));
      }
      if (Files.exists(below(up, path))) {
        return Optional.of(below(up, path));
      }
    }
    return Optional.empty();
  }
}
