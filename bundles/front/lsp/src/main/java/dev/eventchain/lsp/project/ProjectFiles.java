package dev.eventchain.lsp.project;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.UnsavedTexts;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The files of a project that may name its requirements, with the texts that are open. */
final class ProjectFiles {

  private static final Set<String> ENDINGS = Set.of("yaml", "yml", "md", "json", "xmi", "ocl");

  private static final int DEEPEST = 6;

  private final Workspace workspace;
  private final OpenTexts texts;
  private final ProjectFolder folder;

  ProjectFiles(Workspace workspace, OpenTexts texts, ProjectFolder folder) {
    this.workspace = workspace;
    this.texts = texts;
    this.folder = folder;
  }

  /** Returns the requirements as they are written now; none if they cannot be read. */
  List<WrittenRequirement> requirements() {
    try {
      return UnsavedTexts.during(
          texts.overlay(),
          () -> folder.hasRequirements() ? folder.readRequirements().items() : List.of());
    } catch (DiagnosticException e) {
      return List.of(); // a finding says why
    }
  }

  /** Returns where a requirement is written. */
  Optional<FileRange> place(WrittenRequirement requirement) {
    SourceLocation location = requirement.location();
    Path file = Path.of(location.file());
    return uses(requirement.id(), List.of(file)).stream()
        .filter(each -> each.range().start().line() + 1 == location.line())
        .findFirst();
  }

  /** Returns all places at which the project names something, in the order of the files. */
  List<FileRange> uses(String id) {
    return uses(id, files());
  }

  private List<FileRange> uses(String id, List<Path> files) {
    Pattern word = Pattern.compile("(?<![\\w.-])" + Pattern.quote(id) + "(?![\\w-])");
    List<FileRange> found = new ArrayList<>();
    for (Path file : files) {
      Optional<String> text = workspace.text(file).map(SourceText::text);
      if (text.isPresent() && text.get().contains(id)) {
        TextLines lines = new TextLines(text.get());
        Matcher matcher = word.matcher(text.get());
        while (matcher.find()) {
          found.add(new FileRange(file, lines.range(matcher.start(), matcher.end())));
        }
      }
    }
    return found;
  }

  private List<Path> files() {
    Path output = folder.defaultOutput();
    try (Stream<Path> all = Files.walk(folder.folder(), DEEPEST)) {
      return all.filter(file -> !file.startsWith(output) && isText(file)).sorted().toList();
    } catch (IOException e) {
      return List.of(); // the folder is gone meanwhile
    }
  }

  private static boolean isText(Path file) {
    String name = file.getFileName().toString();
    return ENDINGS.contains(name.substring(name.lastIndexOf('.') + 1)) && Files.isRegularFile(file);
  }

  /** Returns whether requirements are kept in a file of ours, which may be changed. */
  boolean owns(WrittenRequirement requirement) {
    return Path.of(requirement.location().file()).endsWith("requirements.md");
  }

  /** Returns a file of the project as people name it. */
  String name(Path file) {
    return folder.folder().relativize(file).toString();
  }
}
