package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The models and the documents of rules that projects are about; each project is read once. */
final class ProjectParts {

  /** The project around each folder. */
  private final Map<Path, Optional<Path>> projects = new HashMap<>();

  private final Map<Path, Set<Path>> parts = new HashMap<>();

  /** Returns whether a file is the model, or a document of rules, that its project is about. */
  boolean contains(Path file) {
    return projects
        .computeIfAbsent(
            file.getParent(), folder -> ProjectFolder.around(file).map(ProjectFolder::folder))
        .filter(folder -> of(folder).contains(file))
        .isPresent();
  }

  private Set<Path> of(Path folder) {
    return parts.computeIfAbsent(
        folder,
        key ->
            read(new ProjectFolder(folder))
                .map(each -> each.toAbsolutePath().normalize())
                .collect(Collectors.toSet()));
  }

  private static Stream<Path> read(ProjectFolder project) {
    Path output = project.defaultOutput();
    return Stream.concat(project.model(output).stream(), rules(project, output).stream());
  }

  /** Returns a project's documents of rules; if one cannot be read, without their imports. */
  private static List<Path> rules(ProjectFolder project, Path output) {
    try {
      return project.constraintFiles(output);
    } catch (DiagnosticException e) {
      // The check of the project says why.
      return List.of(project.constraintsFile(), output.resolve(ProjectFolder.GENERATED));
    }
  }
}
