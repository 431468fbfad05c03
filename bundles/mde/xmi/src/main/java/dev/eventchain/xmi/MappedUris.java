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
 * Maps URIs with agreed prefixes to files: {@code platform:/resource/PROJECT/PATH} names a file in
 * an Eclipse workspace, wherever that is.
 */
final class MappedUris {

  private static final List<String> PLATFORM = List.of("platform:/resource/", "platform:/plugin/");

  /** The files that mark a folder as a project of Eclipse or of another build tool. */
  private static final List<String> PROJECT_FILES =
      List.of(".project", "META-INF/MANIFEST.MF", "pom.xml", "build.gradle");

  /**
   * The target of a reference.
   *
   * @param project the project that it was found in without a mapping; references may lead into it
   *     although its folder was not given
   */
  record Target(Path file, Optional<Path> project) {}

  private final Map<String, Path> map;

  /** Creates a mapping; the longest matching prefix wins. */
  MappedUris(Map<String, Path> map) {
    this.map = map;
  }

  /** Returns whether a reference names a file by an Eclipse project. */
  static boolean isPlatform(String reference) {
    return PLATFORM.stream().anyMatch(reference::startsWith);
  }

  /** Returns the hint for a reference that is not followed. */
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
        : "Refer to files below the folders of the given files by a relative path, name a folder"
            + " that holds both (--root DIR), or give that file to the command, too, a metamodel by"
            + " --metamodel.";
  }

  /**
   * Returns the file of a reference, without its fragment.
   *
   * @param base the file that holds the reference
   * @return empty if the reference has no mapped prefix
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

  /** Resolves a path below a folder; a prefix may also stand for a file. */
  private static Path below(Path folder, String path) {
    String relative = URI.decode(path);
    return folder.resolve(relative.replaceFirst("^/+", "")).toAbsolutePath().normalize();
  }

  /**
   * Finds a file by its project: a folder next to the file, one that contains it, or one next to
   * these.
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

  /** Returns the folder of a project; empty if no file in it marks it as one. */
  private static Optional<Path> projectIn(Path workspace, String name) {
    Path folder = workspace.resolve(name);
    boolean simple = !name.isEmpty() && !name.equals(".") && !name.equals("..");
    return simple && PROJECT_FILES.stream().anyMatch(file -> Files.exists(folder.resolve(file)))
        ? Optional.of(folder)
        : Optional.empty();
  }
}
