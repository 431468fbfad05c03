package dev.eventchain.lsp.check;

import dev.eventchain.check.CheckRules;
import dev.eventchain.check.ProjectValidation;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Pipeline;
import dev.eventchain.pipeline.Today;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.SuppressionFile;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** A project: what {@code eventchain validate DIR} checks, without asking a language model. */
record ProjectUnit(Path folder, Duration timeLimit) implements CheckUnit.OfProject {

  private static final String NO_MODEL = "project.stage.missing";

  @Override
  public List<Diagnostic> check() {
    Project project = Project.open(folder);
    Path output = project.defaultOutput();
    // Results of a run that count as soon as they are there; changes of others mean nothing.
    List.of(ProjectFolder.MODEL, ProjectFolder.DESCRIPTION, ProjectFolder.GENERATED)
        .forEach(each -> FileReads.note(output.resolve(each)));
    List<Diagnostic> found =
        new ArrayList<>(Pipeline.run(project, options(project), Progress.NONE).diagnostics());
    if (project.model(output).isEmpty()) {
      // The command line would have it designed; an editor says that it is not there yet.
      found.removeIf(each -> each.id().equals(NO_MODEL));
      Set<Diagnostic> all = new LinkedHashSet<>();
      ProjectValidation.validate(project, output, timeLimit).diagnostics().stream()
          .filter(each -> each.is(CheckRules.PROJECT_MODEL_MISSING))
          .forEach(all::add);
      all.addAll(found);
      return List.copyOf(all);
    }
    return found;
  }

  private RunOptions options(Project project) {
    return RunOptions.of(project.defaultOutput())
        .with(Stages.only(Stage.VALIDATE))
        .accepting(suppressions(project))
        .within(timeLimit);
  }

  private static Suppressions suppressions(Project project) {
    return project
        .suppressions()
        .map(
            file -> SuppressionFile.read(file, Today.of(System.getenv(), Clock.systemUTC()).date()))
        .orElse(Suppressions.NONE);
  }
}
