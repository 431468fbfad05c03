package dev.eventchain.pipeline.stage;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.Signal;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputRules;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.SimulationOptions;
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
import java.util.function.Function;

/** The shared context of a run's stages: project, output folder and Python environment. */
public final class RunContext {

  /** Marker file: the generated package is for copying, not for a colcon build of the project. */
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
   * Creates the context of a new run.
   *
   * @param sample the sample, if this is the run of an evaluation
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

  /** Returns a file of the output folder. */
  public Path file(String name) {
    return options.output().resolve(name);
  }

  /**
   * Returns a file that an earlier stage writes.
   *
   * @throws DiagnosticException INPUT if it does not exist
   */
  public Path required(String name, Stage maker) {
    Path file = file(name);
    if (!Files.isRegularFile(file)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  StageRules.STAGE_MISSING,
                  "The stage '" + maker.id() + "' has not written " + name + " yet.",
                  SourceLocation.of(file))
              .withHint("Run '" + command("--to " + maker.id()) + "'."));
    }
    return file;
  }

  /** Returns the chain's model: the edited one, if there is one, else the generated one. */
  public Path model() {
    return project.editedModel().orElseGet(() -> required(ProjectFolder.MODEL, Stage.MODEL));
  }

  /** Returns the command that runs this project into this output folder. */
  public String command(String more) {
    return project.command(options.output(), more);
  }

  /** Returns the snapshots of files, one for each of their states. */
  Snapshots snapshots() {
    return snapshots;
  }

  /**
   * Returns the project's chain according to its current files.
   *
   * @throws DiagnosticException INPUT if there is no model, it cannot be read, or is not an event
   *     chain
   */
  public ChainSnapshot chain() {
    return ChainSnapshot.of(this);
  }

  /**
   * Returns a chain's model.
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

  /** Returns the folders of a run's files, inner ones first. */
  public List<Path> baseFolders() {
    return List.of(options.output(), project.folder());
  }

  /** Returns the functional requirements. */
  public Requirements requirements() {
    return snapshots.of("requirements", project.requirementFiles(), project::readRequirements);
  }

  /**
   * Returns the functional requirements; empty if the project has none. Their files do not count as
   * read: a stage that uses them adds their texts to its fingerprint.
   */
  public List<WrittenRequirement> writtenRequirements() {
    return project.hasRequirements()
        ? FileReads.unrecorded(() -> requirements().items())
        : List.of();
  }

  /** Returns the design rules; empty if the project has no such file. */
  public Optional<Requirements> designRules() {
    return project.designRules().map(this::readRules);
  }

  private Requirements readRules(Path file) {
    return snapshots.of("rules " + file, List.of(file), () -> ProjectFolder.readRules(file));
  }

  /** Returns the existing software components. */
  public SoftwareBase softwareBase() {
    return snapshots.of("software base", project.softwareBaseFiles(), project::readSoftwareBase);
  }

  /** Returns the connections between world and chain. */
  public Bench bench() {
    List<Path> files = new ArrayList<>(project.softwareBaseFiles());
    project.bench().ifPresent(files::add);
    return snapshots.of("bench", files, this::readBench);
  }

  private Bench readBench() {
    return Bench.read(project.bench(), softwareBase().signals().orElse(List.of()), messages());
  }

  /**
   * Returns what reads other texts of the project's bench, whose formulas can read outputs of the
   * chain: with signals, messages and chain as they are now, on any thread.
   */
  public Function<SourceText, Bench> benches() {
    List<Signal> signals = softwareBase().signals().orElse(List.of());
    MessageCatalog messages = messages();
    EventChain chain = chain().chain();
    return text -> Bench.parse(text, signals, messages).withOutputsOf(chain);
  }

  /** Returns the valid message definitions: standard ones and the project's own. */
  public MessageCatalog messages() {
    return snapshots.of("messages", project.messageFiles(), project::readMessages);
  }

  /** Returns the use of language models in this run. */
  public ModelWork models() {
    return models;
  }

  /** Writes a file; resulting findings go to the current stage. */
  public void write(String name, byte[] content) {
    OutputFolder.Written written = output.write(name, content, options.onEdit());
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
   * Writes a result of the run. A person's version would pass for the result, so it is replaced and
   * reported.
   */
  public void writeResult(String name, byte[] content) {
    findAboutResult(output.write(name, content, OutputFolder.OnEdit.OVERWRITE).finding());
  }

  /** Removes a result of an earlier run. */
  public void remove(String name) {
    findAboutResult(output.remove(name));
  }

  /**
   * Adds a finding about a result; without records of outputs, only errors, because an edit is
   * unlikely.
   */
  private void findAboutResult(Optional<Diagnostic> finding) {
    finding
        .filter(each -> output.hasRecords() || each.severity() == Severity.ERROR)
        .ifPresent(findings::add);
  }

  /**
   * Reports once that the output folder has lost its records of written files.
   *
   * @param restored true if the records of the stages replace them
   */
  public void findLostRecords(boolean restored) {
    boolean used = Files.exists(file(IGNORE));
    recordsAreLost = used && !output.hasRecords() && !restored;
    if (output.damage().isPresent()) {
      find(output.damage().get());
    } else if (restored || recordsAreLost) {
      find(
          Diagnostic.of(
                  OutputRules.OUTPUT_RECORDS_DAMAGED,
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
        Diagnostic.of(
                OutputRules.EVENTCHAIN_FILE_EDITED,
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

  /** Stores the path of a recording, for the result of the run. */
  public void recorded(Path recording) {
    recordings.add(recording);
  }

  /** Returns the recordings of this run. */
  public List<Path> recordings() {
    return List.copyOf(recordings);
  }

  /** Returns whether there is an error that is not suppressed. */
  public boolean anyErrorCounts(List<Diagnostic> found) {
    return Diagnostic.anyError(options.suppressions().part(found).remaining());
  }

  /** Adds a finding to the current stage. */
  public void find(Diagnostic finding) {
    findings.add(finding);
  }

  /** Returns the findings since the last call. */
  public List<Diagnostic> takeFindings() {
    keptStrangers().ifPresent(findings::add);
    List<Diagnostic> taken = List.copyOf(findings);
    findings.clear();
    return taken;
  }

  /** Returns the project's Python environment, created on demand. */
  public PythonEnvironment python(Stage stage) {
    if (python == null) {
      Consumer<String> said = message -> progress.step(stage, message);
      python =
          options.simulation().driver() == SimulationOptions.Driver.LOCKSTEP
              ? PythonEnvironment.ensure(said)
              : PythonEnvironment.ensureWithCycloneDds(said);
    }
    return python;
  }
}
