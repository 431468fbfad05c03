package dev.eventchain.llm;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;

/**
 * Asks a person: writes each prompt to {@code TASK-NN.prompt.md} and goes on once {@code
 * TASK-NN.answer.md} is there. NN counts the calls of a task in a run, so one run uses one
 * instance. A prompt that changed sets its old answer aside.
 */
final class HandoffModel implements ChatModel {
  private final ModelName model;
  private final Path folder;
  private final CallCounter calls = new CallCounter();

  HandoffModel(ModelName model, Path folder) {
    this.model = model;
    this.folder = folder;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    String name = "%s-%02d".formatted(request.task(), calls.next(request.task()) + 1);
    Path prompt = folder.resolve(name + ".prompt.md");
    Path answer = folder.resolve(name + ".answer.md");
    ObjectNode json = RequestJson.of(model, request);
    RequestKey key = RequestKey.of(json);
    try {
      boolean changed = !HandoffPrompt.keyOf(prompt).equals(Optional.of(key.value()));
      if (changed && Files.exists(answer)) {
        setAside(answer, name);
      }
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

  private void setAside(Path answer, String name) throws IOException {
    int number = 1;
    Path target;
    do {
      target = folder.resolve("%s.outdated-%02d.md".formatted(name, number++));
    } while (Files.exists(target));
    Files.move(answer, target, StandardCopyOption.ATOMIC_MOVE);
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
                    "The prompt cannot be written: " + cause,
                    SourceLocation.of(prompt))
                .withHint("Choose another folder with --llm handoff:FOLDER.")));
  }
}
