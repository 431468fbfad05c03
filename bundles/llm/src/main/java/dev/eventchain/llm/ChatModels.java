package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;

/** Opens the language models that a configuration names. */
public final class ChatModels {
  private static final String HANDOFF = "handoff:";

  private ChatModels() {}

  /**
   * Opens a model for one run. Recordings and hand-off count the identical requests of a run, so a
   * run opens a model once, or once for each task, and a new run opens it anew. Safe for threads.
   *
   * @param specification how answers are got: {@code replay} takes them from the recordings, {@code
   *     handoff:FOLDER} asks a person through files in that folder for what is not recorded
   * @param model which model is asked, as {@code PROVIDER/NAME}; a name alone stands for a model
   *     that a person asks. It is part of what identifies a recording
   * @param recordings the folder of the recordings, {@code TASK/NAME-KEY.json} in the format {@code
   *     llm-recording/1}
   * @param record whether answers are recorded; replaying records nothing
   * @throws DiagnosticException INPUT when the specification or the model's name is none
   */
  public static ChatModel open(
      String specification, String model, Path recordings, boolean record) {
    ModelName name = modelName(model);
    RecordingFolder folder = new RecordingFolder(recordings);
    if (specification.equals("replay")) {
      return new ReplayModel(name, folder);
    }
    if (specification.startsWith(HANDOFF) && specification.length() > HANDOFF.length()) {
      ChatModel person =
          new HandoffModel(name, folder(specification.substring(HANDOFF.length())), folder);
      return record ? new RecordingModel(person, name, folder, Clock.systemUTC()) : person;
    }
    throw input(
        "llm.provider.unknown",
        "'" + specification + "' is no provider of language models.",
        "Use replay or handoff:FOLDER.");
  }

  private static ModelName modelName(String text) {
    try {
      return ModelName.parse(text);
    } catch (IllegalArgumentException e) {
      throw input("llm.model.name", e.getMessage(), "Write it as PROVIDER/NAME.");
    }
  }

  private static Path folder(String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw input("llm.handoff.folder", "'" + text + "' is no folder: " + e.getReason(), "");
    }
  }

  private static DiagnosticException input(String id, String message, String hint) {
    return new DiagnosticException(
        Reason.INPUT, List.of(Diagnostic.error(id, message, SourceLocation.NONE).withHint(hint)));
  }
}
