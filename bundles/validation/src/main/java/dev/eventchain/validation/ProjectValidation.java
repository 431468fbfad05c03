package dev.eventchain.validation;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What {@code eventchain validate DIR} finds about the chain of a project. */
public final class ProjectValidation {

  private ProjectValidation() {}

  /**
   * Checks the chain of a project as its files say it now: the model against its metamodel, the
   * standard constraints, the project's own and the generated ones; the contracts with the vehicle;
   * the use of existing components; the requirements that it names; and whether a constraint stands
   * for each design rule. Whether the results of earlier runs are up to date only a run knows.
   *
   * <p>Nothing is thrown for what is wrong with a file: it is a finding at that file, and as long
   * as there is such a finding, the chain is not checked. Without a model there is {@code
   * project.model.missing}.
   *
   * @param output the folder of the project's results, which need not be there
   * @param timeLimit the processor time that a constraint, or the patterns of a data type, may take
   * @return the findings before any are suppressed; the coverage is {@link Coverage#NONE} if the
   *     chain was not checked, and then there is a finding that says why
   */
  public static Validation validate(ProjectFolder folder, Path output, Duration timeLimit) {
    Attempts attempts = new Attempts();
    Optional<ProjectSettings> settings = attempts.of(() -> ProjectSettings.read(folder));
    Optional<Path> file = folder.model(output);
    Optional<ChainModel> model =
        file.flatMap(each -> attempts.of(() -> ChainModel.read(folder, output, each, timeLimit)));
    Optional<ChainChecks> checks = attempts.of(() -> ChainChecks.of(folder, output, timeLimit));
    Optional<List<String>> files = attempts.of(() -> Constraints.names(folder, output));
    List<Diagnostic> found = new ArrayList<>(attempts.problems());
    if (file.isEmpty()) {
      found.add(missing(folder, output));
    }
    if (!found.isEmpty()) {
      return new Validation(Coverage.NONE, found);
    }
    ChainModel chain = located(model.orElseThrow(), folder, output, settings.orElseThrow());
    ChainChecks.Outcome outcome = checks.orElseThrow().check(chain);
    List<String> read = new ArrayList<>(List.of(SourceLocation.of(file.get()).file()));
    read.addAll(files.orElseThrow());
    return new Validation(outcome.coverage(read), outcome.diagnostics());
  }

  /** The chain with its elements where they come from: a description, unless people edit it. */
  private static ChainModel located(
      ChainModel model, ProjectFolder folder, Path output, ProjectSettings settings) {
    Path description = output.resolve(ProjectFolder.DESCRIPTION);
    return folder.editedModel().isPresent()
        ? model
        : model.describedBy(
            description,
            () ->
                ChainModel.ofDescription(
                    description,
                    settings,
                    ProjectFolder.readRules(folder.requirements()),
                    folder.readSoftwareBase()));
  }

  private static Diagnostic missing(ProjectFolder folder, Path output) {
    return Diagnostic.info(
            "project.model.missing",
            "The project has no model of its chain yet, so its chain was not checked.",
            SourceLocation.of(folder.configurationFile()))
        .withHint("Write model/chain.xmi, or run '" + folder.command(output, "--to model") + "'.");
  }
}
