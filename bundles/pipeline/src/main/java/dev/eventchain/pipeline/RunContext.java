package dev.eventchain.pipeline;

import dev.eventchain.agents.AgentContext;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.ChatModel;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.m2t.OutputFolder;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.metamodel.LoadedModel;
import dev.eventchain.metamodel.Origins;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.modeler.SoftwareBase;
import dev.eventchain.python.PythonEnvironment;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What the stages of a run share: the project, the output folder, and the Python environment. */
final class RunContext {

  private final Project project;
  private final RunOptions options;
  private final OutputFolder output;
  private final Progress progress;
  private final List<Diagnostic> findings = new ArrayList<>();
  private PythonEnvironment python;
  private Requirements requirements;
  private SoftwareBase softwareBase;
  private MessageCatalog messages;

  /**
   * A chain and where its elements stand.
   *
   * @param origins where in the model's file each element stands
   */
  record LoadedChain(EventChain chain, Origins origins) {}

  RunContext(Project project, RunOptions options, OutputFolder output, Progress progress) {
    this.project = project;
    this.options = options;
    this.output = output;
    this.progress = progress;
  }

  Project project() {
    return project;
  }

  RunOptions options() {
    return options;
  }

  OutputFolder output() {
    return output;
  }

  Progress progress() {
    return progress;
  }

  /** A file of the output folder. */
  Path file(String name) {
    return options.output().resolve(name);
  }

  /**
   * A file that an earlier stage makes.
   *
   * @throws DiagnosticException INPUT if it is not there
   */
  Path required(String name, Stage maker) {
    Path file = file(name);
    if (!Files.isRegularFile(file)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(
                  "project.stage.missing",
                  "The stage '" + maker.id() + "' has not written " + name + " yet.",
                  SourceLocation.of(file))
              .withHint("Run 'eventchain run " + project.folder() + " --to " + maker.id() + "'."));
    }
    return file;
  }

  /** The chain's model: the one that people edit, if there is one, else the generated one. */
  Path model() {
    return project.editedModel().orElseGet(() -> required("chain.xmi", Stage.MODEL));
  }

  /**
   * Reads a chain's model.
   *
   * @throws DiagnosticException INPUT if it cannot be read, or is no event chain
   */
  LoadedChain loadChain(Path model) {
    Path root = model.startsWith(options.output()) ? options.output() : project.folder();
    LoadedModel loaded = new XmiStore(root).load(model);
    if (loaded.resource().getContents().get(0) instanceof EventChain chain) {
      return new LoadedChain(chain, loaded.origins());
    }
    throw new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error(
            "project.model", "The model's root is no EventChain.", SourceLocation.of(model)));
  }

  /** The folders that files of a run are in, inner ones first. */
  List<Path> baseFolders() {
    return List.of(options.output(), project.folder());
  }

  /** The functional requirements. */
  Requirements requirements() {
    if (requirements == null) {
      requirements = checked(Requirements.read(SourceText.read(project.requirements())));
    }
    return requirements;
  }

  /** The design rules; none where the project has no such file. */
  Optional<Requirements> designRules() {
    return Files.exists(project.designRules())
        ? Optional.of(checked(Requirements.read(SourceText.read(project.designRules()))))
        : Optional.empty();
  }

  private static Requirements checked(Requirements read) {
    refuseErrors(read.diagnostics());
    return read;
  }

  /** What exists already. */
  SoftwareBase softwareBase() {
    if (softwareBase == null) {
      softwareBase = SoftwareBase.read(project.softwareBase());
      refuseErrors(softwareBase.diagnostics());
    }
    return softwareBase;
  }

  /** The message definitions, the standard ones and the project's own, all of them sound. */
  MessageCatalog messages() {
    if (messages == null) {
      messages = MessageCatalog.of(project.messageFolders());
      refuseErrors(messages.diagnostics());
    }
    return messages;
  }

  /**
   * Goes on unless one of the findings is an error.
   *
   * @throws DiagnosticException INPUT with the findings
   */
  private static void refuseErrors(List<Diagnostic> diagnostics) {
    if (Diagnostic.anyError(diagnostics)) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, diagnostics);
    }
  }

  /** What an agent works with. */
  AgentContext agent(Stage stage) {
    Configuration configuration = project.configuration();
    ChatModel model =
        ChatModels.open(
            options.llm().orElse(configuration.llm()),
            configuration.model(stage),
            project.recordings(),
            options.record());
    return new AgentContext(
        model, configuration.repairs(), message -> progress.step(stage, message));
  }

  /** Writes a file; what comes of it is a finding of the stage that runs. */
  void write(String name, byte[] content) {
    OutputFolder.OnEdit onEdit =
        options.overwrite() ? OutputFolder.OnEdit.OVERWRITE : OutputFolder.OnEdit.KEEP;
    output.write(name, content, onEdit).finding().ifPresent(findings::add);
  }

  /** As {@link #write(String, byte[])}, in UTF-8. */
  void write(String name, String content) {
    write(name, content.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Writes a result of the run. A person's version in its place would pass for the result: it is
   * replaced, and that is said.
   */
  void writeResult(String name, byte[] content) {
    output.write(name, content, OutputFolder.OnEdit.OVERWRITE).finding().ifPresent(findings::add);
  }

  /** Adds a finding to the stage that runs. */
  void find(Diagnostic finding) {
    findings.add(finding);
  }

  /** The findings since the last call. */
  List<Diagnostic> takeFindings() {
    List<Diagnostic> taken = List.copyOf(findings);
    findings.clear();
    return taken;
  }

  /** The project's Python environment, made if need be. */
  PythonEnvironment python(Stage stage) {
    if (python == null) {
      python = PythonEnvironment.ensure(message -> progress.step(stage, message));
    }
    return python;
  }
}
