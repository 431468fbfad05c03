package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestKey;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The folder {@code recordings/} with one folder per task. */
public final class RecordingFolder {
  private final Path folder;

  public RecordingFolder(Path folder) {
    this.folder = folder;
  }

  Path file(String task, ModelName model, RequestKey key) {
    return folder.resolve(task).resolve(model.inFileName() + "-" + key.abbreviated() + ".json");
  }

  /** Returns the recorded answer to the n-th identical request of a run, counted from 0. */
  public Optional<ChatResponse> sample(String task, ModelName model, RequestKey key, int number) {
    return find(task, model, key)
        .filter(recording -> number < recording.samples().size())
        .map(recording -> recording.samples().get(number).response());
  }

  Optional<Recording> find(String task, ModelName model, RequestKey key) {
    Path file = file(task, model, key);
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    Recording recording = RecordingReader.read(file);
    if (!recording.key().equals(key)) {
      throw new DiagnosticException(
          Reason.INPUT,
          List.of(
              Diagnostic.of(
                      RecordingRules.RECORDING_KEY,
                      "The file's name belongs to a different request than the one it contains.",
                      SourceLocation.of(file))
                  .withHint("Delete the file and record it again.")));
    }
    return Optional.of(recording);
  }

  /** Returns the recordings of a task, sorted by name. */
  List<Path> files(String task) {
    Path tasks = folder.resolve(task);
    if (!Files.isDirectory(tasks)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(tasks)) {
      return files.filter(file -> file.toString().endsWith(".json")).sorted().toList();
    } catch (IOException e) {
      throw FileRules.refusal("The folder of recordings", tasks, e);
    }
  }

  /** Stores an answer as sample {@code index} of its request. */
  void put(String task, ModelName model, ObjectNode request, int index, Recording.Sample sample) {
    RequestKey key = RequestKey.of(request);
    Recording recording = find(task, model, key).orElseGet(() -> Recording.of(request));
    Path file = file(task, model, key);
    try {
      RecordingWriter.write(file, recording.with(index, sample));
    } catch (IOException e) {
      throw new DiagnosticException(
          Reason.INPUT,
          List.of(
              Diagnostic.of(
                      RecordingRules.RECORDING_UNWRITABLE,
                      "The recording cannot be written: " + SourceText.reason(e) + ".",
                      SourceLocation.of(file))
                  .withHint("Make the folder writable, or run without --record.")));
    }
  }
}
