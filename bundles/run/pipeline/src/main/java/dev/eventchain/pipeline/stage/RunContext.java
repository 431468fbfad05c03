package dev.eventchain.pipeline.stage;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.bench.Bench;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** What the stages of a run share: the project, the output folder, and the Python environment. */
public final class RunContext {

  /** The generated package is for people to copy, not for a colcon build of the project. */
  public static final String IGNORE = "COLCON_IGNORE";

  private final Project project;
  private final RunOptions options;
  private final OutputFolder output;
  private final Progress progress;
  private final List<Diagnostic> findings = new ArrayList<>();
  private PythonEnvironment python;
  private final Snapshots snapshots = new Snapshots(this);
  private final List<Path> recordings = new ArrayList<>();
  private final List<String> strangers = new ArrayList<>();
  private final ModelWork models;
  private boolean recordsAreLost;

  /**
   * A run that has not begun.
   *
   * @param sample the run of an evaluation that this is, if it is one
   */
  public RunContext(
      Project project,
      RunOptions options,
      OutputFolder output,
      Progress progress,
      Optional<Sample> sample) {
    this.project = project;
    this.options = options;
    this.output = output;
    this.progress = progress;
    this.models = new ModelWork(this, sample);
  }

  public Project project() {
    return project;
  }

  public RunOptions options() {
    return options;
  }

  public OutputFolder output() {
    return output;
  }

  public Progress progress() {
    return progress;
  }

  /** A file of the output folder. */
  public Path file(String name) {
    return options.output().resolve(name);
  }

  /**
   * A file that an earlier stage makes.
   *
   * @throws DiagnosticException INPUT if it is not there
   */
  public Path required(String name, Stage maker) {
    Path file = file(name);
    if (!Files.isRegularFile(file)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(
                  "project.stage.missing",
                  "The stage '" + maker.id() + "' has not written " + name + " yet.",
                  SourceLocation.of(file))
              .withHint("Run '" + command("--to " + maker.id()) + "'."));
    }
    return file;
  }

  /** The chain's model: the one that people edit, if there is one, else the generated one. */
  public Path model() {
    return project.editedModel().orElseGet(() -> required(ProjectFolder.MODEL, Stage.MODEL));
  }

  /** The command that runs this project into this output folder. */
  public String command(String more) {
    return project.command(options.output(), more);
  }

  /** What was read of files, once for each state of them. */
  Snapshots snapshots() {
    return snapshots;
  }

  /**
   * The project's chain as its files say it now.
   *
   * @throws DiagnosticException INPUT if there is no model, it cannot be read, or is not an event
   *     chain
   */
  public ChainSnapshot chain() {
    return ChainSnapshot.of(this);
  }

  /**
   * A chain's model.
   *
   * @throws DiagnosticException INPUT if it cannot be read, or is not an event chain
   */
  public ChainModel loadChain(Path model) {
    return snapshots.of("model " + model, List.of(model), () -> readModel(model));
  }

  private ChainModel readModel(Path model) {
    progress.read(model);
    return ChainModel.read(project, options.output(), model, options.timeLimit());
  }

  /** The folders that files of a run are in, inner ones first. */
  public List<Path> baseFolders() {
    return List.of(options.output(), project.folder());
  }

  /** The functional requirements. */
  public Requirements requirements() {
    return readRules(project.requirements());
  }

  /** The functional requirements; none where the project has written none. */
  public List<WrittenRequirement> writtenRequirements() {
    return ProjectFolder.isAbsent(project.requirements()) ? List.of() : requirements().items();
  }

  /** The design rules; none where the project has no such file. */
  public Optional<Requirements> designRules() {
    return project.designRules().map(this::readRules);
  }

  private Requirements readRules(Path file) {
    return snapshots.of("rules " + file, List.of(file), () -> ProjectFolder.readRules(file));
  }

  /** What exists already. */
  public SoftwareBase softwareBase() {
    return snapshots.of("software base", project.softwareBaseFiles(), project::readSoftwareBase);
  }

  /** How the world and the chain are connected. */
  public Bench bench() {
    List<Path> files = new ArrayList<>(project.softwareBaseFiles());
    project.bench().ifPresent(files::add);
    return snapshots.of("bench", files, this::readBench);
  }

  private Bench readBench() {
    return Bench.read(
        project.bench(),
        softwareBase().signals().orElse(List.of()),
        MessageCatalog.of(project.messageFolders()));
  }

  /** The message definitions, the standard ones and the project's own, all of them sound. */
  public MessageCatalog messages() {
    return snapshots.of("messages", project.messageFiles(), project::readMessages);
  }

  /** What the run has to do with language models. */
  public ModelWork models() {
    return models;
  }

  /** Writes a file; what comes of it is a finding of the stage that runs. */
  public void write(String name, byte[] content) {
    OutputFolder.OnEdit onEdit =
        options.overwrite() ? OutputFolder.OnEdit.OVERWRITE : OutputFolder.OnEdit.KEEP;
    OutputFolder.Written written = output.write(name, content, onEdit);
    if (recordsAreLost && written.outcome() == OutputFolder.Outcome.KEPT) {
      strangers.add(name);
    } else {
      written.finding().ifPresent(findings::add);
    }
  }

  /** As {@link #write(String, byte[])}, in UTF-8. */
  public void write(String name, String content) {
    write(name, content.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Writes a result of the run. A person's version in its place would pass for the result: it is
   * replaced, and that is said.
   */
  public void writeResult(String name, byte[] content) {
    findAboutResult(output.write(name, content, OutputFolder.OnEdit.OVERWRITE).finding());
  }

  /** Removes a result of an earlier run. */
  public void remove(String name) {
    findAboutResult(output.remove(name));
  }

  /** Where nobody knows whether a person edited a result, it is likely that nobody did. */
  private void findAboutResult(Optional<Diagnostic> finding) {
    finding
        .filter(each -> output.hasRecords() || each.severity() == Severity.ERROR)
        .ifPresent(findings::add);
  }

  /**
   * Says once that the output folder has lost its records of what it wrote.
   *
   * @param restored whether what the stages remember replaces them
   */
  public void findLostRecords(boolean restored) {
    boolean used = Files.exists(file(IGNORE));
    recordsAreLost = used && !output.hasRecords() && !restored;
    if (output.damage().isPresent()) {
      find(output.damage().get());
    } else if (restored || recordsAreLost) {
      find(
          Diagnostic.warning(
                  "output.records.damaged",
                  "The records of the files written earlier are gone.",
                  SourceLocation.of(options.output()))
              .withHint(
                  restored
                      ? "What the stages recorded about their files is used instead."
                      : "Files that differ count as edited by hand; delete them to have them"
                          + " written again."));
    }
  }

  private Optional<Diagnostic> keptStrangers() {
    if (strangers.isEmpty()) {
      return Optional.empty();
    }
    String first = strangers.get(0);
    String more = strangers.size() == 1 ? "" : ", and " + (strangers.size() - 1) + " more";
    Diagnostic kept =
        Diagnostic.warning(
                "eventchain.file.edited",
                "Kept, because there is no record of whether it was edited by hand: '"
                    + first
                    + "'"
                    + more
                    + ", which would be written otherwise.",
                SourceLocation.of(file(first)))
            .withHint("Run '" + command("--overwrite") + "' to have them written again.");
    strangers.clear();
    return Optional.of(kept);
  }

  /** Remembers a recording, to name it when the run ends. */
  public void recorded(Path recording) {
    recordings.add(recording);
  }

  /** The recordings of this run. */
  public List<Path> recordings() {
    return List.copyOf(recordings);
  }

  /** Adds a finding to the stage that runs. */
  public void find(Diagnostic finding) {
    findings.add(finding);
  }

  /** The findings since the last call. */
  public List<Diagnostic> takeFindings() {
    keptStrangers().ifPresent(findings::add);
    List<Diagnostic> taken = List.copyOf(findings);
    findings.clear();
    return taken;
  }

  /** The project's Python environment, made if need be. */
  public PythonEnvironment python(Stage stage) {
    if (python == null) {
      Consumer<String> said = message -> progress.step(stage, message);
      python =
          options.driver() == RunOptions.Driver.LOCKSTEP
              ? PythonEnvironment.ensure(said)
              : PythonEnvironment.ensureWithCycloneDds(said);
    }
    return python;
  }
}
