package dev.eventchain.llm.handoff;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.AtomicFile;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import dev.eventchain.llm.recording.CallCounter;
import dev.eventchain.llm.recording.RecordingFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Asks a person for answers that are not recorded. It writes each prompt to {@code
 * TASK-NN.prompt.md} and continues when {@code TASK-NN.answer.md} exists. Prompts are identified by
 * key, so an answer is used for its own prompt only, in any order of prompts. A changed prompt gets
 * a new number, and no file in the folder is overwritten. The count of equal prompts in a run
 * includes recorded answers, so that no answer is used twice.
 */
public final class HandoffModel implements ChatModel {
  private static final String PROMPT = ".prompt.md";

  private final ModelName model;
  private final Path folder;
  private final RecordingFolder recordings;
  private final CallCounter calls = new CallCounter();

  /**
   * Creates a model whose answers a person gives.
   *
   * @param folder where prompts and answers are exchanged
   * @param recordings the recorded answers
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
    Path prompt = folder;
    Path answer;
    try {
      String name = name(request.task(), key, earlier);
      prompt = promptFile(name);
      answer = answerFile(name);
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

  /**
   * Returns the name of the existing file of a prompt, or the first free name. Numbers may be
   * missing, since a person may have removed files.
   */
  private String name(String task, RequestKey key, int earlier) throws IOException {
    int same = 0;
    int last = lastPrompt(task);
    for (int number = 1; number <= last; number++) {
      String name = name(task, number);
      if (HandoffPrompt.keyOf(promptFile(name)).equals(Optional.of(key.value()))
          && same++ == earlier) {
        return name;
      }
    }
    int free = 1;
    while (Files.exists(promptFile(name(task, free)))
        || Files.exists(answerFile(name(task, free)))) {
      free++;
    }
    return name(task, free);
  }

  /** Returns the largest number of a prompt of the task in the folder; 0 without one. */
  private int lastPrompt(String task) throws IOException {
    if (!Files.isDirectory(folder)) {
      return 0;
    }
    Pattern file = Pattern.compile(Pattern.quote(task) + "-([0-9]{2,6})" + Pattern.quote(PROMPT));
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(path -> file.matcher(path.getFileName().toString()))
          .filter(Matcher::matches)
          .mapToInt(matcher -> Integer.parseInt(matcher.group(1)))
          .max()
          .orElse(0);
    }
  }

  private static String name(String task, int number) {
    return String.format(Locale.ROOT, "%s-%02d", task, number);
  }

  private Path promptFile(String name) {
    return folder.resolve(name + PROMPT);
  }

  private Path answerFile(String name) {
    return folder.resolve(name + ".answer.md");
  }

  private static DiagnosticException waiting(Path prompt, Path answer) {
    return new DiagnosticException(
        Reason.WAITING,
        List.of(
            Diagnostic.of(
                    AnswerRules.HANDOFF_WAITING,
                    "The answer to this prompt is awaited.",
                    SourceLocation.of(prompt))
                .withHint(
                    "Save the model's answer as " + answer + " and run the same command again.")));
  }

  private static DiagnosticException unwritable(Path prompt, IOException cause) {
    return new DiagnosticException(
        Reason.INPUT,
        List.of(
            Diagnostic.of(
                    HandoffRules.HANDOFF_UNWRITABLE,
                    "The prompt cannot be written: " + SourceText.reason(cause) + ".",
                    SourceLocation.of(prompt))
                .withHint("Choose another folder with --llm handoff:FOLDER.")));
  }
}
