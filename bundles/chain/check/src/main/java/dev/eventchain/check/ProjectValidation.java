package dev.eventchain.check;

import dev.eventchain.diagnostics.ContentHash;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.Requirement;
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
 * Validation of the chain of a project, as by {@code eventchain validate DIR}. An instance reads
 * rules, messages, software base and requirements again only if one of their files has changed,
 * because editors validate on each save. For one thread at a time.
 */
public final class ProjectValidation {

  private final ProjectFolder folder;
  private final Path output;
  private final Duration timeLimit;

  /** Digest of the files of the checks when last read. */
  private String state = "";

  private Optional<ChainChecks> kept = Optional.empty();

  /**
   * Creates a validation without reading files.
   *
   * @param output the folder of the project's results, which may be absent
   * @param timeLimit the processor time that a constraint, or the patterns of a data type, may take
   */
  public ProjectValidation(ProjectFolder folder, Path output, Duration timeLimit) {
    this.folder = folder;
    this.output = output;
    this.timeLimit = timeLimit;
  }

  /**
   * Checks the chain in the current files of a project: the metamodel; the standard, own and
   * generated constraints; the contracts with the vehicle; the use of existing components; the
   * requirements; and that a constraint implements each design rule. It does not check whether
   * results of earlier runs are up to date.
   *
   * <p>Errors in a file are not thrown but reported as findings at that file; with any of them, the
   * chain is not checked. A missing model is reported as {@code project.model.missing}.
   *
   * @return the findings before suppression; the coverage is {@link Coverage#NONE}, and a finding
   *     gives the reason, if the chain was not checked
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
    List<Diagnostic> all = new ArrayList<>(outcome.diagnostics());
    List<String> named = chain.chain().getRequirements().stream().map(Requirement::getId).toList();
    folder.missingRequirements(named).ifPresent(all::add);
    return new Validation(outcome.coverage(read), all);
  }

  /** As {@link #validate()}, for a single validation. */
  public static Validation validate(ProjectFolder folder, Path output, Duration timeLimit) {
    return new ProjectValidation(folder, output, timeLimit).validate();
  }

  private ChainChecks checks() {
    String now = stateOfFiles();
    if (kept.isEmpty() || !now.equals(state)) {
      kept = Optional.empty(); // the old checks are invalid, even if this fails
      kept = Optional.of(ChainChecks.of(folder, output, timeLimit));
      state = now;
    }
    return kept.get();
  }

  /**
   * Returns a digest of the content of the files behind the checks, and of the names of other
   * relevant files.
   */
  private String stateOfFiles() {
    List<Path> files = new ArrayList<>(folder.constraintFiles(output));
    files.add(folder.configurationFile());
    files.add(folder.designRulesFile());
    files.addAll(folder.requirementFiles());
    files.addAll(folder.softwareBaseFiles());
    files.add(folder.questionsFile());
    files.addAll(folder.messageFiles());
    Sha256 digest = new Sha256();
    for (Path file : files) {
      boolean there = Files.isRegularFile(file);
      digest.add(file + (there ? "\n" : " is not there\n"));
      if (there) {
        digest.add(ContentHash.hex(bytes(file)));
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
      throw FileRules.refusal("The file", file, e);
    }
  }

  /**
   * Returns the chain with elements located in their source: the description, unless the model is
   * edited.
   */
  private ChainModel located(ChainModel model, ProjectSettings settings) {
    Path description = output.resolve(ProjectFolder.DESCRIPTION);
    return folder.editedModel().isPresent()
        ? model
        : model.describedBy(
            description,
            () ->
                ChainModel.ofDescription(
                    description, settings, folder.readRequirements(), folder.readSoftwareBase()));
  }

  private Diagnostic missing() {
    return Diagnostic.of(
            CheckRules.PROJECT_MODEL_MISSING,
            "The project has no model of its chain yet, so its chain was not checked.",
            SourceLocation.of(folder.configurationFile()))
        .withHint("Write model/chain.xmi, or run '" + folder.command(output, "--to model") + "'.");
  }
}
