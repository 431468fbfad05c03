package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.agents.Mutation.Outcome;
import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.answer.AnswerText;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * An accepted answer, with the checks of its task.
 *
 * @param name the source of the answer
 * @param text the whole answer: one block between fences
 * @param existing the names of the existing components
 * @param check the checks of the task's agent
 * @param differences the differences between two artefacts
 */
record GoodAnswer(
    String name,
    AnswerKind kind,
    String text,
    Set<String> existing,
    Function<SourceText, List<Diagnostic>> check,
    BiFunction<SourceText, SourceText, List<String>> differences) {
  private static final JsonMapper MAPPER = new JsonMapper();

  /**
   * The result of judging an answer.
   *
   * @param details the findings or the differences
   */
  record Result(Outcome outcome, List<String> details) {}

  /** Returns the content between the fences. */
  String block() {
    return text.substring(text.indexOf('\n') + 1, text.lastIndexOf("```"));
  }

  /** Returns the answer with other content between the fences. */
  String withBlock(String block) {
    return text.substring(0, text.indexOf('\n') + 1)
        + block
        + (block.endsWith("\n") ? "" : "\n")
        + text.substring(text.lastIndexOf("```"));
  }

  /** Returns the content between the fences, as a new copy of its JSON. */
  JsonNode json() {
    try {
      return MAPPER.readTree(block());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  String with(JsonNode json) {
    return withBlock(json.toPrettyString());
  }

  /** Judges a changed answer. */
  Result judge(String changed) {
    AnswerText answer = extract(changed);
    Optional<SourceText> artefact = answer.artefact();
    List<Diagnostic> found =
        artefact.map(check).orElse(answer.problems()).stream().sorted().toList();
    if (Diagnostic.anyError(found)) {
      return new Result(Outcome.REJECTED, List.of(FindingLines.of(found)));
    }
    SourceText original = extract(text).artefact().orElseThrow();
    List<String> different = differences.apply(original, artefact.orElseThrow());
    return new Result(different.isEmpty() ? Outcome.EQUAL : Outcome.VISIBLE, different);
  }

  private AnswerText extract(String answer) {
    return AnswerText.extract(
        kind,
        "artefact",
        new ChatResponse(answer, FinishReason.STOP, "test", "test", Optional.empty()));
  }
}
