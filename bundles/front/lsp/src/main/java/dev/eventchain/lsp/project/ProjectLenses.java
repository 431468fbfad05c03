package dev.eventchain.lsp.project;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.Command;

/** Lenses above a scenario and above a chain: how to run it, and its last verdict. */
public final class ProjectLenses {

  /** The editor's own command that simulates: of a project's folder, and a scenario's name. */
  public static final String SIMULATE = "eventchain.simulate";

  private static final Pattern NAME = Pattern.compile("(?m)^name: *[\"']?([\\w-]+)");

  private final Workspace workspace;
  private final OpenTexts texts;

  /** The lenses of the projects of a session. */
  public ProjectLenses(Workspace workspace, OpenTexts texts) {
    this.workspace = workspace;
    this.texts = texts;
  }

  /** Returns what is shown in a file; nothing for files of other kinds. */
  public List<CodeLens> of(Path file) {
    Optional<ProjectFolder> project = ProjectFolder.around(file);
    String text = workspace.text(file).map(SourceText::text).orElse("");
    if (project.isEmpty()) {
      return List.of();
    } else if (isChain(project.get(), file)) {
      return lenses(project.get(), Optional.empty(), TextRange.at(new TextLines(text).position(0)));
    }
    Matcher name = NAME.matcher(text);
    boolean isScenario =
        ProjectSchemas.kind(project.get().folder(), file, text)
            .filter(kind -> kind == ProjectSchemas.Kind.SCENARIO)
            .isPresent();
    return isScenario && name.find()
        ? lenses(
            project.get(),
            Optional.of(name.group(1)),
            Positions.shifted(
                new TextLines(text).range(name.start(), name.end()), texts.mark(file)))
        : List.of();
  }

  private static boolean isChain(ProjectFolder project, Path file) {
    Path output = project.defaultOutput();
    return file.equals(output.resolve(ProjectFolder.DESCRIPTION))
        || project.model(output).filter(file::equals).isPresent();
  }

  private List<CodeLens> lenses(ProjectFolder project, Optional<String> scenario, TextRange at) {
    List<Object> arguments = new ArrayList<>(List.of(project.folder().toString()));
    scenario.ifPresent(arguments::add);
    String title = scenario.isPresent() ? "Simulate this scenario" : "Simulate all scenarios";
    List<CodeLens> lenses = new ArrayList<>();
    lenses.add(lens(at, new Command(title, SIMULATE, arguments)));
    LastVerdict.of(project, texts)
        .flatMap(verdict -> scenario.map(verdict::of).orElseGet(verdict::ofAll))
        .ifPresent(words -> lenses.add(lens(at, new Command(words, ""))));
    return lenses;
  }

  private static CodeLens lens(TextRange at, Command command) {
    return new CodeLens(Positions.of(at), command, null);
  }
}
