package dev.eventchain.xmi;

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

  /** What makes a folder a project, of Eclipse or of what builds without it. */
  private static final List<String> PROJECT_FILES =
      List.of(".project", "META-INF/MANIFEST.MF", "pom.xml", "build.gradle");

  /**
   * What a reference means.
   *
   * @param project the project that it was found in without being told where projects are; a
   *     reference may lead into it, though nobody gave its folder
   */
  record Target(Path file, Optional<Path> project) {}

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
        .orElseGet(() -> otherHint(reference));
  }

  private static String otherHint(String reference) {
    String target = reference.replaceFirst("#.*", "");
    return target.matches("(?!file:)[A-Za-z][A-Za-z0-9+.-]+:.*")
        ? "Say which file that is: --map " + target + "=FILE"
        : "Refer to files in the project's folder by a relative path.";
  }

  /**
   * The file that a reference means, without its fragment.
   *
   * @param base the file that holds the reference
   * @return empty if the reference is one as any other
   */
  Optional<Target> fileOf(Path base, String reference) {
    Optional<String> prefix =
        map.keySet().stream()
            .filter(reference::startsWith)
            .max(Comparator.comparingInt(String::length));
    try {
      return prefix.isPresent()
          ? Optional.of(mapped(prefix.get(), reference))
          : inWorkspace(base, reference);
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private Target mapped(String prefix, String reference) {
    Path file = below(map.get(prefix), reference.substring(prefix.length()));
    return new Target(file, Optional.empty());
  }

  /** What a beginning stands for may be a file, which the whole reference names then. */
  private static Path below(Path folder, String path) {
    String relative = URI.decode(path);
    return folder.resolve(relative.replaceFirst("^/+", "")).toAbsolutePath().normalize();
  }

  /**
   * The project is a folder next to the file, or one of the folders that it is in, or next to one
   * of these.
   */
  private static Optional<Target> inWorkspace(Path base, String reference) {
    Optional<String> prefix = PLATFORM.stream().filter(reference::startsWith).findFirst();
    if (prefix.isEmpty()) {
      return Optional.empty();
    }
    String path = reference.substring(prefix.get().length());
    String project = URI.decode(path.replaceFirst("/.*", ""));
    for (Path up = base.getParent(); up != null; up = up.getParent()) {
      Path workspace = up.endsWith(project) ? up.resolveSibling("") : up;
      for (Path folder : List.of(workspace, up)) {
        Path file = below(folder, path);
        if (Files.exists(file)) {
          return Optional.of(new Target(file, projectIn(folder, project)));
        }
      }
    }
    return Optional.empty();
  }

  /** The folder of a project; empty if nothing in it says that it is one. */
  private static Optional<Path> projectIn(Path workspace, String name) {
    Path folder = workspace.resolve(name);
    boolean simple = !name.isEmpty() && !name.equals(".") && !name.equals("..");
    return simple && PROJECT_FILES.stream().anyMatch(file -> Files.exists(folder.resolve(file)))
        ? Optional.of(folder)
        : Optional.empty();
  }
}
