package dev.eventchain.llm.handoff;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import dev.eventchain.llm.recording.AtomicFile;
import dev.eventchain.llm.recording.CallCounter;
import dev.eventchain.llm.recording.RecordingFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Asks a person for what is not recorded: writes each prompt to {@code TASK-NN.prompt.md} and
 * continues once {@code TASK-NN.answer.md} is there. A prompt is known by its key, so an answer is
 * only ever taken for the prompt that it was given to, in whatever order prompts come; a changed
 * prompt gets a new number, and nothing that lies in the folder is overwritten. The n-th equal
 * prompt of a run is counted over recorded answers, too, so that no answer serves twice.
 */
public final class HandoffModel implements ChatModel {
  private final ModelName model;
  private final Path folder;
  private final RecordingFolder recordings;
  private final CallCounter calls = new CallCounter();

  /**
   * A model that a person answers for.
   *
   * @param folder where prompts and answers are exchanged
   * @param recordings answers that there are already
   */
  public HandoffModel(ModelName model, Path folder, RecordingFolder recordings) {
    this.model = model;
    this.folder = folder;
    this.recordings = recordings;
  }

  @Override
  public synchronized ChatResponse chat(ChatRequest request) {
    RequestKey key = RequestKey.of(RequestJson.of(model, request));
    int earlier = calls.next(request.task() + " " + key.value());
    Optional<ChatResponse> recorded = recordings.sample(request.task(), model, key, earlier);
    return recorded.isPresent() ? recorded.get() : ask(request, key, earlier);
  }

  private ChatResponse ask(ChatRequest request, RequestKey key, int earlier) {
    String name = name(request.task(), key, earlier);
    Path prompt = promptFile(name);
    Path answer = answerFile(name);
    try {
      AtomicFile.write(prompt, HandoffPrompt.text(name, key, request));
    } catch (IOException e) {
      throw unwritable(prompt, e);
    }
    if (!Files.exists(answer)) {
      throw waiting(prompt, answer);
    }
    String text = SourceText.read(answer).text();
    if (text.isBlank()) {
      throw waiting(prompt, answer);
    }
    return HandoffAnswer.parse(text, model.name());
  }

  /** The name under which a prompt lies in the folder already, or the next one that is free. */
  private String name(String task, RequestKey key, int earlier) {
    int same = 0;
    int number = 1;
    while (Files.exists(promptFile(name(task, number)))
        || Files.exists(answerFile(name(task, number)))) {
      String name = name(task, number);
      if (HandoffPrompt.keyOf(promptFile(name)).equals(Optional.of(key.value()))
          && same++ == earlier) {
        return name;
      }
      number++;
    }
    return name(task, number);
  }

  private static String name(String task, int number) {
    return "%s-%02d".formatted(task, number);
  }

  private Path promptFile(String name) {
    return folder.resolve(name + ".prompt.md");
  }

  private Path answerFile(String name) {
    return folder.resolve(name + ".answer.md");
  }

  private static DiagnosticException waiting(Path prompt, Path answer) {
    return new DiagnosticException(
        Reason.WAITING,
        List.of(
            Diagnostic.error(
                    "llm.handoff.waiting",
                    "The answer to this prompt is awaited.",
                    SourceLocation.of(prompt))
                .withHint(
                    "Save the model's answer as " + answer + " and run the same command again.")));
  }

  private static DiagnosticException unwritable(Path prompt, IOException cause) {
    return new DiagnosticException(
        Reason.INPUT,
        List.of(
            Diagnostic.error(
                    "llm.handoff.unwritable",
                    "The prompt cannot be written: " + SourceText.reason(cause) + ".",
                    SourceLocation.of(prompt))
                .withHint("Choose another folder with --llm handoff:FOLDER.")));
  }
}
