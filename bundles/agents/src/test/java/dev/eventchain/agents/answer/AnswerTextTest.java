package dev.eventchain.agents.answer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.FindingLines;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Artefacts found in answers, and answers without one. */
class AnswerTextTest {
  private static final Path RESOURCES = Path.of("src/test/resources");

  @ParameterizedTest
  @MethodSource
  void theArtefactIsToldFromTheTalkAroundIt(AnswerKind kind, Path file) throws IOException {
    String answer = Files.readString(file);
    AnswerText text = AnswerText.extract(kind, "artefact", response(answer, FinishReason.STOP));
    assertTrue(text.artefact().isPresent() != !text.problems().isEmpty());
    String actual = text.artefact().map(a -> a.text()).orElse("");
    ExpectedFile.check(ExpectedFile.beside(file), actual + FindingLines.of(text.problems()));
  }

  static Stream<Arguments> theArtefactIsToldFromTheTalkAroundIt() throws IOException {
    Stream<Arguments> all = Stream.empty();
    for (AnswerKind kind : AnswerKind.values()) {
      List<Path> files =
          ExpectedFile.inputs(
              RESOURCES.resolve("answers/" + kind.name().toLowerCase(Locale.ROOT)), ".md");
      all = Stream.concat(all, files.stream().map(file -> Arguments.of(kind, file)));
    }
    return all;
  }

  @ParameterizedTest
  @CsvSource({
    "LENGTH, agents.answer.truncated",
    "REFUSAL, agents.answer.refused",
    "OTHER, agents.answer.refused"
  })
  void anAnswerThatTheModelDidNotFinishIsNotUsedEvenIfItLooksWhole(FinishReason reason, String id) {
    AnswerText text = AnswerText.extract(AnswerKind.JSON, "artefact", response("[{}]", reason));
    assertEquals(Optional.empty(), text.artefact());
    assertEquals(List.of(id), text.problems().stream().map(problem -> problem.id()).toList());
  }

  @Test
  void lineEndsAndMarksOfWindowsAreDropped() {
    ChatResponse response = response("\uFEFFclass A:\r\n    pass\r\n", FinishReason.STOP);
    AnswerText text = AnswerText.extract(AnswerKind.PYTHON, "a.py", response);
    assertEquals("class A:\n    pass\n", text.artefact().orElseThrow().text());
  }

  @Test
  void jsonThatTheModelerWouldRefuseAsTooDeepIsAProblemOfTheAnswer() {
    String deep = "[".repeat(201) + "]".repeat(201);
    AnswerText text = AnswerText.extract(AnswerKind.JSON, "a", response(deep, FinishReason.STOP));
    assertEquals(
        List.of(
            "This is not valid JSON: it is nested deeper than 200 levels, or a token is too long."),
        text.problems().stream().map(problem -> problem.message()).toList());
  }

  private static ChatResponse response(String text, FinishReason reason) {
    return new ChatResponse(text, reason, "test", "test", Optional.empty());
  }
}
