package dev.eventchain.llm.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.ModelAccess;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Several runs with the same requests: each has its own answers. */
class SampledModelTest {

  private static final ModelName MODEL = ModelName.parse("openai/gpt-5");
  private static final List<ChatMessage> QUESTION = List.of(ChatMessage.user("Design."));

  @TempDir Path folder;
  private Path common;

  @BeforeEach
  void name() {
    common = folder.resolve("common");
  }

  private void record(List<ChatMessage> messages, String... answers) {
    ChatRequest request = ChatRequest.of("design", messages);
    for (int i = 0; i < answers.length; i++) {
      ChatResponse response =
          new ChatResponse(answers[i], FinishReason.STOP, "gpt-5", "openai", Optional.empty());
      Recording.Sample sample = new Recording.Sample("2026-11-22T10:00:00Z", response);
      new RecordingFolder(common).put("design", MODEL, RequestJson.of(MODEL, request), i, sample);
    }
  }

  private ChatModel run(String source, int number) {
    ModelAccess access = ModelAccess.of(source, folder.resolve("own-" + number), true);
    return ChatModels.openRun(access, MODEL.toString(), common, number);
  }

  private static String ask(ChatModel model, List<ChatMessage> messages) {
    return model.chat(ChatRequest.of("design", messages)).text();
  }

  private static List<ChatMessage> after(String answer) {
    return List.of(QUESTION.get(0), ChatMessage.assistant(answer), ChatMessage.user("Again."));
  }

  @Test
  void runsTakeAnswersInTheirOrderAndNoneTwice() {
    record(QUESTION, "one", "two");
    assertEquals("one", ask(run("replay", 0), QUESTION));
    assertEquals("two", ask(run("replay", 1), QUESTION));
    assertEquals("two", ask(run("replay", 1), QUESTION), "whoever asks first");
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> ask(run("replay", 2), QUESTION));
    assertEquals("llm.recording.exhausted", e.diagnostics().get(0).id());
    assertTrue(
        e.diagnostics()
            .get(0)
            .message()
            .startsWith("Run 3 sends a prompt that has 2 recorded answers"));
  }

  @Test
  void aConversationGoesOnWithTheAnswersOfItsOwnRun() {
    record(QUESTION, "bad", "worse", "bad");
    record(after("bad"), "better", "best");
    record(after("worse"), "good");
    String[] last = {"better", "good", "best"};
    for (int number = 0; number < last.length; number++) {
      ChatModel run = run("replay", number);
      assertEquals(last[number], ask(run, after(ask(run, QUESTION))), "run " + number);
    }
  }

  /**
   * As for a verdict, whose prompt shows the component and not the answer that it was taken from.
   */
  @Test
  void aConversationThatBeginsOtherwiseTakesAnswersByTheNumberOfTheRun() {
    record(after("ours"), "one", "two");
    assertEquals("one", ask(run("replay", 0), after("ours")));
    assertEquals("two", ask(run("replay", 1), after("ours")));
    assertThrows(DiagnosticException.class, () -> ask(run("replay", 2), after("ours")));
  }

  @Test
  void whatIsNotRecordedIsAskedAndRecordedApart() {
    record(QUESTION, "one");
    Path program = folder.resolve("own-1/design");
    assertEquals("one", ask(run("auto", 0), QUESTION));
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> ask(run("handoff:" + folder, 1), QUESTION));
    assertEquals("llm.handoff.waiting", e.diagnostics().get(0).id());
    assertTrue(Files.notExists(program));
    assertEquals("asked", ask(run("command:echo asked", 1), QUESTION).strip());
    assertTrue(Files.exists(program));
    assertEquals("asked", ask(run("command:false", 1), QUESTION).strip(), "from its recording");
    DiagnosticException missing =
        assertThrows(
            DiagnosticException.class, () -> ask(run("replay", 0), after("never recorded")));
    assertEquals("llm.recording.missing", missing.diagnostics().get(0).id());
  }
}
