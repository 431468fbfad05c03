package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.Sampling;
import dev.eventchain.llm.handoff.CommandModel;
import dev.eventchain.llm.handoff.HandoffModel;
import dev.eventchain.llm.recording.RecordedFirst;
import dev.eventchain.llm.recording.RecordingFolder;
import dev.eventchain.llm.recording.RecordingModel;
import dev.eventchain.llm.recording.ReplayModel;
import dev.eventchain.llm.recording.SampledModel;
import dev.eventchain.llm.service.ModelService;
import dev.eventchain.llm.service.ServiceModel;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Optional;

/** Opens the language models that a configuration names. */
public final class ChatModels {
  private static final String HANDOFF = "handoff:";
  private static final String COMMAND = "command:";
  private static final String WAYS =
      "Use replay, auto, live, SERVICE/MODEL, handoff:FOLDER or command:PROGRAM.";

  private final ModelAccess access;
  private final RecordingFolder recordings;

  private ChatModels(ModelAccess access) {
    this.access = access;
    this.recordings = new RecordingFolder(access.recordings());
  }

  /**
   * Opens a model for one run. Recordings and hand-off count the identical requests of a run, so
   * each run opens its models anew, once or once per task. Thread-safe.
   *
   * @param models the models {@code SERVICE/NAME}, each a fallback for the unreachable one before;
   *     a name alone stands for a model that a person asks. The names are part of the recording
   *     keys
   * @throws DiagnosticException INPUT if the source or a model's name is invalid
   */
  public static ChatModel open(ModelAccess access, List<String> models) {
    ChatModels opening = new ChatModels(access);
    Optional<String> forAll = opening.modelForAll();
    List<FallbackModel.Named> opened =
        forAll.map(List::of).orElse(models).stream().map(opening::open).toList();
    return opened.size() == 1
        ? opened.get(0).model()
        : new FallbackModel(opened, access.findings());
  }

  /** Opens one model with the usual services, as {@link #open(ModelAccess, List)}. */
  public static ChatModel open(String source, String model, Path recordings, boolean record) {
    return open(ModelAccess.of(source, recordings, record), List.of(model));
  }

  /**
   * Opens a model for one of several runs that send the same requests but need different answers.
   * {@code replay}, {@code auto} and hand-off use the project's recordings: run n takes the n-th
   * answer to a request. New answers are recorded separately for each run, and reused when the run
   * is repeated.
   *
   * @param access the access with the recording folder of this run
   * @param common the project's recordings
   * @param run the number of the run, from 0
   * @throws DiagnosticException INPUT if the source or the model's name is invalid
   */
  public static ChatModel openRun(ModelAccess access, String model, Path common, int run) {
    ChatModels opening = new ChatModels(access);
    ModelName name = modelName(model);
    return opening.inShape(name, opening.openRun(name, new RecordingFolder(common), run));
  }

  private ChatModel openRun(ModelName name, RecordingFolder shared, int run) {
    String source = access.source();
    if (source.equals("replay")) {
      return new SampledModel(name, shared, run, SampledModel.nothingElse(name, shared, run));
    }
    if (source.startsWith(COMMAND) || source.equals("live")) {
      ChatModel asking = source.equals("live") ? lazily(name) : program(name);
      return recorded(new RecordedFirst(name, recordings, asking), name);
    }
    return new SampledModel(name, shared, run, open(name));
  }

  /** Returns the model that the source names for all tasks, if it does. */
  private Optional<String> modelForAll() {
    int slash = access.source().indexOf('/');
    return slash > 0 && access.services().service(access.source().substring(0, slash)).isPresent()
        ? Optional.of(access.source())
        : Optional.empty();
  }

  private FallbackModel.Named open(String model) {
    ModelName name = modelName(model);
    return new FallbackModel.Named(name.toString(), inShape(name, open(name)));
  }

  /** Gives a request the schema and the sampling of the model before keys are computed. */
  private ChatModel inShape(ModelName name, ChatModel opened) {
    AnswerSchema.Shape shape = shape(name);
    Optional<Sampling> sampling =
        access.services().service(name.provider()).map(ModelService::sampling);
    return request -> opened.chat(sampling.map(request::sampled).orElse(request).in(shape));
  }

  /**
   * Returns the shape of the model's schemas, independent of the source of its answers, so that
   * replay finds recordings of any source. A model without a service gets the shape for hand-off.
   */
  private AnswerSchema.Shape shape(ModelName name) {
    return access
        .services()
        .service(name.provider())
        .map(service -> service.wire().shape())
        .orElse(AnswerSchema.Shape.TOLD);
  }

  private ChatModel open(ModelName name) {
    String source = access.source();
    if (source.equals("replay")) {
      return new ReplayModel(name, recordings);
    }
    if (source.equals("live") || modelForAll().isPresent()) {
      return recorded(service(name), name);
    }
    if (source.equals("auto")) {
      return recorded(new RecordedFirst(name, recordings, lazily(name)), name);
    }
    if (source.startsWith(HANDOFF) && source.length() > HANDOFF.length()) {
      Path folder = folder(source.substring(HANDOFF.length()));
      return recorded(new HandoffModel(name, folder, recordings), name);
    }
    if (source.startsWith(COMMAND)) {
      return recorded(program(name), name);
    }
    throw noWay(source);
  }

  private static DiagnosticException noWay(String source) {
    return input(
        LlmRules.PROVIDER_UNKNOWN,
        "'" + source + "' is not a way to get answers from models.",
        WAYS);
  }

  private ChatModel program(ModelName name) {
    List<String> command = CommandModel.split(access.source().substring(COMMAND.length()));
    if (command.isEmpty()) {
      throw noWay(access.source());
    }
    ChatModel program = new CommandModel(name, command, access.services().commandDeadline());
    return new MeteredModel(program, name, access);
  }

  /** Looks the service up on the first call only: with recordings none is needed. */
  private ChatModel lazily(ModelName name) {
    return request -> service(name).chat(request);
  }

  private ChatModel recorded(ChatModel model, ModelName name) {
    return access.record() ? new RecordingModel(model, name, recordings, Clock.systemUTC()) : model;
  }

  private ChatModel service(ModelName name) {
    ModelService service =
        access
            .services()
            .service(name.provider())
            .orElseThrow(
                () ->
                    input(
                        LlmRules.SERVICE_UNKNOWN,
                        "The model '" + name + "' names no service that can be asked.",
                        "Write it as SERVICE/MODEL in eventchain.yaml; services are "
                            + String.join(", ", access.services().names())
                            + "."));
    ChatModel model = new ServiceModel(service, name, access.environment(), access.progress());
    return new MeteredModel(model, name, access);
  }

  private static ModelName modelName(String text) {
    try {
      return ModelName.parse(text);
    } catch (IllegalArgumentException e) {
      throw input(LlmRules.MODEL_NAME, e.getMessage(), "Write it as SERVICE/NAME.");
    }
  }

  private static Path folder(String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw input(LlmRules.HANDOFF_FOLDER, "'" + text + "' is not a folder: " + e.getReason(), "");
    }
  }

  private static DiagnosticException input(Rule rule, String message, String hint) {
    return new DiagnosticException(
        Reason.INPUT, List.of(Diagnostic.of(rule, message, SourceLocation.NONE).withHint(hint)));
  }
}
