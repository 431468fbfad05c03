package dev.eventchain.check;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.project.ProjectFileNames;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What {@code eventchain validate DIR} finds about the chain of a project. One that is kept reads
 * rules, messages, software base and requirements again only when one of their files has changed:
 * an editor validates on each save, and mostly it is the chain that was saved. For one thread at a
 * time.
 */
public final class ProjectValidation {

  private final ProjectFolder folder;
  private final Path output;
  private final Duration timeLimit;

  /** What the files of the checks were when they were read last, and the checks. */
  private String state = "";

  private Optional<ChainChecks> kept = Optional.empty();

  /**
   * Reads nothing yet.
   *
   * @param output the folder of the project's results, which need not be there
   * @param timeLimit the processor time that a constraint, or the patterns of a data type, may take
   */
  public ProjectValidation(ProjectFolder folder, Path output, Duration timeLimit) {
    this.folder = folder;
    this.output = output;
    this.timeLimit = timeLimit;
  }

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
   * @return the findings before any are suppressed; the coverage is {@link Coverage#NONE} if the
   *     chain was not checked, and then there is a finding that says why
   */
  public Validation validate() {
    Attempts attempts = new Attempts();
    Optional<ProjectSettings> settings = attempts.of(() -> ProjectSettings.read(folder));
    Optional<Path> file = folder.model(output);
    Optional<ChainModel> model =
        file.flatMap(each -> attempts.of(() -> ChainModel.read(folder, output, each, timeLimit)));
    Optional<ChainChecks> checks = attempts.of(this::checks);
    Optional<List<String>> files = attempts.of(() -> folder.constraintNames(output));
    List<Diagnostic> found = new ArrayList<>(attempts.problems());
    if (file.isEmpty()) {
      found.add(missing());
    }
    if (!found.isEmpty()) {
      return new Validation(Coverage.NONE, found);
    }
    ChainModel chain = located(model.orElseThrow(), settings.orElseThrow());
    ChainChecks.Outcome outcome = checks.orElseThrow().check(chain);
    List<String> read = new ArrayList<>(List.of(SourceLocation.of(file.get()).file()));
    read.addAll(files.orElseThrow());
    return new Validation(outcome.coverage(read), outcome.diagnostics());
  }

  /** As {@link #validate()}, once. */
  public static Validation validate(ProjectFolder folder, Path output, Duration timeLimit) {
    return new ProjectValidation(folder, output, timeLimit).validate();
  }

  private ChainChecks checks() {
    String now = stateOfFiles();
    if (kept.isEmpty() || !now.equals(state)) {
      kept = Optional.empty(); // whatever happens now, the old ones are no longer true
      kept = Optional.of(ChainChecks.of(folder, output, timeLimit));
      state = now;
    }
    return kept.get();
  }

  /** The content of what the checks are made of, and which files there are besides. */
  private String stateOfFiles() {
    List<Path> files = new ArrayList<>(folder.constraintFiles(output));
    files.add(folder.designRulesFile());
    files.add(folder.requirements());
    files.addAll(folder.softwareBaseFiles());
    files.addAll(folder.messageFiles());
    Sha256 digest = new Sha256();
    for (Path file : files) {
      boolean there = Files.isRegularFile(file);
      digest.add(file + (there ? "\n" : " is not there\n"));
      if (there) {
        digest.add(new Sha256().add(bytes(file)).hex());
      }
    }
    if (Files.isDirectory(folder.softwareBase())) {
      ProjectFolder.below(folder.softwareBase()).forEach(file -> digest.add(file + "\n"));
    }
    digest.add(ProjectFileNames.unreadConstraints(folder, output).toString());
    return digest.hex();
  }

  private static byte[] bytes(Path file) {
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw ProjectFolder.unreadable(file, e);
    }
  }

  /** The chain with its elements where they come from: a description, unless people edit it. */
  private ChainModel located(ChainModel model, ProjectSettings settings) {
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

  private Diagnostic missing() {
    return Diagnostic.info(
            "project.model.missing",
            "The project has no model of its chain yet, so its chain was not checked.",
            SourceLocation.of(folder.configurationFile()))
        .withHint("Write model/chain.xmi, or run '" + folder.command(output, "--to model") + "'.");
  }
}
