package dev.eventchain.mcp.project;

import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Rules about what a client may not write: results, and files in which a person decides. What a
 * file is follows from the project that holds it, whatever folder a client calls the project.
 */
public final class Protection {

  /** Files that make a folder a project, or silence its findings, wherever they are. */
  private static final Set<String> ANYWHERE =
      Set.of(ProjectLayout.CONFIGURATION, ProjectLayout.SUPPRESSIONS);

  /** Files of a project in which a person decides what is tried, and what is accepted. */
  private static final Set<String> DECISIONS =
      Set.of(ProjectLayout.MUTANTS, ProjectLayout.ACCEPTED);

  /** Whatever would decide about a project that is started around it. */
  private static final List<String> BEFORE_PROJECTS =
      List.of(
          ProjectLayout.OUTPUT,
          ProjectLayout.RECORDINGS,
          ProjectLayout.SUPPRESSIONS,
          ProjectLayout.MUTANTS,
          ProjectLayout.ACCEPTED);

  /** Names that no file of a template, and no folder of one, has; {@code *} for any characters. */
  private static final List<String> NOT_GENERATED =
      List.of(
          ProjectLayout.CONFIGURATION,
          ProjectLayout.SUPPRESSIONS,
          ProjectLayout.MUTANTS,
          ProjectLayout.ACCEPTED,
          ProjectLayout.RECORDINGS,
          ".*");

  /** Files that say what is right. */
  private static final Pattern JUDGES =
      Pattern.compile(
          "(?:scenarios|tests|requirements)/.*|requirements\\..*|constraints\\.ocl"
              + "|faults\\.yaml|design-rules\\.md|bench\\.yaml");

  private Protection() {}

  /**
   * Returns the name of a file in its project.
   *
   * @param project the folder that the client calls the project, which has to be one
   * @param named the file as the client names it
   * @throws dev.eventchain.diagnostics.DiagnosticException if the client may not change it
   */
  static String requireChangeable(Boundary boundary, Path project, Path file, String named) {
    if (!file.startsWith(project) || file.equals(project)) {
      throw refusal(named, "It is no file of the project.");
    }
    requirePlain(boundary, file, named);
    for (Path part : boundary.root().relativize(file.getParent())) {
      if (part.toString().equals(ProjectLayout.OUTPUT)) {
        throw refusal(named, "It is a result; a run writes it.");
      }
      if (part.toString().equals(ProjectLayout.RECORDINGS)) {
        throw decided(named);
      }
    }
    if (!isProject(project)) {
      throw refusal(named, "The folder '" + boundary.nameOf(project) + "' is no project.");
    }
    if (!projectAround(boundary, file.getParent()).equals(Optional.of(project))) {
      throw refusal(named, "It is a file of another project, inside this one.");
    }
    String name = project.relativize(file).toString();
    if (ANYWHERE.contains(file.getFileName().toString()) || DECISIONS.contains(name)) {
      throw decided(named);
    }
    return name;
  }

  /** Returns whether a file of a project says what is right. */
  static boolean judges(String name) {
    return JUDGES.matcher(name).matches();
  }

  /** Returns the names that no file of a template, and no folder of one, may have. */
  public static List<String> notGenerated() {
    return NOT_GENERATED;
  }

  /**
   * Fails if no project may be started in a folder: it is hidden, part of another project, or holds
   * what would decide about the project, which a template may have written.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if so
   */
  public static void requireStartable(Boundary boundary, Path folder) {
    String named = boundary.nameOf(folder);
    requirePlain(boundary, folder, named);
    if (!folder.equals(boundary.root())) {
      requireOutsideProjects(boundary, folder, folder.getParent(), named);
    }
    for (String name : isProject(folder) ? List.<String>of() : BEFORE_PROJECTS) {
      if (Files.exists(folder.resolve(name), LinkOption.NOFOLLOW_LINKS)) {
        throw refusal(named, "It holds '" + name + "' already; a person starts a project there.");
      }
    }
  }

  /**
   * Fails if a template may not write into a folder: it is hidden, part of a project, or holds one.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if so
   */
  public static void requireOutput(Boundary boundary, Path folder) {
    String named = boundary.nameOf(folder);
    requirePlain(boundary, folder, named);
    requireOutsideProjects(boundary, folder, folder, named);
    if (folder.equals(boundary.root()) || holdsProject(folder)) {
      throw refusal(named, "Text goes into a folder of its own, which holds no project.");
    }
  }

  private static void requireOutsideProjects(
      Boundary boundary, Path folder, Path from, String named) {
    Optional<Path> project = projectAround(boundary, from);
    if (project.isPresent()) {
      Path results = project.get().resolve(ProjectLayout.OUTPUT);
      if (!folder.startsWith(results) || folder.equals(results)) {
        throw refusal(named, "It is part of a project, and not a folder in its 'out'.");
      }
    }
  }

  /** Fails if a path has a hidden part, or a symbolic link, which gives a file a second name. */
  private static void requirePlain(Boundary boundary, Path path, String named) {
    Path whole = boundary.root();
    for (Path part : boundary.root().relativize(path)) {
      whole = whole.resolve(part);
      if (part.toString().startsWith(".")) {
        throw refusal(named, "A hidden file is not changed.");
      }
      if (Files.isSymbolicLink(whole)) {
        throw refusal(named, "It is a symbolic link, or behind one.");
      }
    }
  }

  /** Returns the nearest project that a folder is or is part of. */
  private static Optional<Path> projectAround(Boundary boundary, Path folder) {
    for (Path above = folder; above.startsWith(boundary.root()); above = above.getParent()) {
      if (isProject(above)) {
        return Optional.of(above);
      }
    }
    return Optional.empty();
  }

  private static boolean isProject(Path folder) {
    return Files.exists(new ProjectFolder(folder).configurationFile(), LinkOption.NOFOLLOW_LINKS);
  }

  private static boolean holdsProject(Path folder) {
    if (!Files.isDirectory(folder)) {
      return false;
    }
    try (Stream<Path> files = Files.walk(folder)) {
      return files.anyMatch(file -> file.endsWith(ProjectLayout.CONFIGURATION));
    } catch (IOException | UncheckedIOException e) {
      throw refusal(folder.getFileName().toString(), "It cannot be read whole.");
    }
  }

  private static RuntimeException decided(String file) {
    return refusal(file, "A person decides what stands there.");
  }

  private static RuntimeException refusal(String file, String message) {
    return McpRules.refusal(
        McpRules.PROTECTED,
        file,
        message,
        "Settings, suppressions, accepted findings and recordings are changed by people, outside"
            + " this server.");
  }
}
