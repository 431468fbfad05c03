package dev.eventchain.llm.handoff;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Hand-off to a person through files. */
class HandoffTest {
  @TempDir Path folder;
  private Path handoff;
  private Path recordings;

  @BeforeEach
  void folders() {
    handoff = folder.resolve("handoff");
    recordings = folder.resolve("recordings");
  }

  @Test
  void withoutAnAnswerThePromptIsWrittenAndTheRunWaits() throws IOException {
    assertWaiting(run(false), "Design a chain.");
    String prompt = Files.readString(handoff.resolve("design-01.prompt.md"));
    assertTrue(prompt.endsWith("\n\nDesign a chain.\n"), prompt);
    assertTrue(prompt.contains("design-01.answer.md"), prompt);
  }

  @Test
  void withTheAnswerTheRunGoesOnToTheNextPrompt() throws IOException {
    assertWaiting(run(false), "first");
    answer("design-01", "one\n");
    ChatModel again = run(false);
    assertEquals("one", again.chat(request("first")).text());
    assertWaiting(again, "second");
    assertTrue(Files.exists(handoff.resolve("design-02.prompt.md")));
  }

  @Test
  void anEmptyAnswerFileIsNoAnswerYet() throws IOException {
    assertWaiting(run(false), "first");
    answer("design-01", " \n");
    assertWaiting(run(false), "first");
  }

  @Test
  void aChangedPromptDoesNotGetTheOldAnswer() throws IOException {
    assertWaiting(run(false), "first");
    answer("design-01", "one");
    assertWaiting(run(false), "first, but different");
    answer("design-02", "two");
    assertEquals("two", run(false).chat(request("first, but different")).text());
    assertEquals("one", run(false).chat(request("first")).text());
  }

  @Test
  void anAnswerBelongsToItsPromptWhateverComesBetween() throws IOException {
    ChatModel both = run(false);
    assertWaiting(both, "first");
    assertWaiting(both, "second");
    answer("design-02", "two");
    ChatModel again = run(false);
    assertWaiting(again, "first");
    assertWaiting(again, "a new one between");
    assertEquals("two", again.chat(request("second")).text());
    assertTrue(Files.exists(handoff.resolve("design-03.prompt.md")));
  }

  @Test
  void anAnswerWithoutItsPromptIsNotTrusted() throws IOException {
    Files.createDirectories(handoff);
    answer("design-01", "for whatever was asked before");
    assertWaiting(run(false), "first");
    assertTrue(Files.exists(handoff.resolve("design-02.prompt.md")));
  }

  @Test
  void anAnswerIsFoundThoughFilesOfEarlierPromptsWereRemoved() throws IOException {
    ChatModel both = run(false);
    assertWaiting(both, "first");
    assertWaiting(both, "second");
    answer("design-02", "two");
    Files.delete(handoff.resolve("design-01.prompt.md"));
    ChatModel again = run(false);
    assertEquals("two", again.chat(request("second")).text());
    assertWaiting(again, "third");
    assertTrue(Files.exists(handoff.resolve("design-01.prompt.md")));
  }

  @Test
  void aConversationTellsItsTurnsApart() throws IOException {
    ChatRequest request =
        ChatRequest.of(
            "design",
            List.of(
                ChatMessage.user("ask"),
                ChatMessage.assistant("wrong"),
                ChatMessage.user("again")));
    ChatModel model = run(false);
    assertThrows(DiagnosticException.class, () -> model.chat(request));
    String prompt = Files.readString(handoff.resolve("design-01.prompt.md"));
    assertTrue(prompt.contains("<!-- message 2 of 3, its answer -->\n\nwrong\n\n"), prompt);
    assertTrue(prompt.endsWith("<!-- message 3 of 3, to the model -->\n\nagain\n"), prompt);
  }

  @Test
  void aRecordedAnswerIsReplayedLater() throws IOException {
    assertWaiting(run(true), "first");
    answer("design-01", "<!-- model: gpt-4o-2024-08-06 -->\n\none\r\ntwo\n");
    ChatResponse response = run(true).chat(request("first"));
    assertEquals("one\ntwo", response.text());
    assertEquals("gpt-4o-2024-08-06", response.model());
    assertEquals("handoff", response.provenance());
    assertEquals(response, replay().chat(request("first")));
  }

  @Test
  void anAnswerThatAPersonWroteSaysSo() throws IOException {
    assertWaiting(run(true), "first");
    answer("design-01", "<!-- provenance: authored -->\none");
    run(true).chat(request("first"));
    assertEquals("authored", replay().chat(request("first")).provenance());
  }

  @Test
  void recordingTheSameAnswerAgainChangesNothing() throws IOException {
    assertWaiting(run(true), "first");
    answer("design-01", "one");
    run(true).chat(request("first"));
    Path file = onlyRecording();
    byte[] before = Files.readAllBytes(file);
    Files.setLastModifiedTime(file, java.nio.file.attribute.FileTime.fromMillis(0));
    run(true).chat(request("first"));
    assertEquals(0, Files.getLastModifiedTime(file).toMillis());
    assertEquals(
        new String(before, java.nio.charset.StandardCharsets.UTF_8), Files.readString(file));
  }

  @Test
  void theNthIdenticalRequestOfARunGetsSampleN() throws IOException {
    assertWaiting(run(true), "same");
    answer("design-01", "one");
    ChatModel second = run(true);
    second.chat(request("same"));
    assertWaiting(second, "same");
    answer("design-02", "two");
    ChatModel third = run(true);
    third.chat(request("same"));
    third.chat(request("same"));

    ChatModel replay = replay();
    assertEquals("one", replay.chat(request("same")).text());
    assertEquals("two", replay.chat(request("same")).text());
    DiagnosticException exhausted =
        assertThrows(DiagnosticException.class, () -> replay.chat(request("same")));
    assertEquals("llm.recording.exhausted", exhausted.diagnostics().get(0).id());
    assertEquals("one", replay().chat(request("same")).text());
  }

  @Test
  void whatIsRecordedIsNotAskedForAgain() throws IOException {
    assertWaiting(run(true), "first");
    answer("design-01", "one");
    run(true).chat(request("first"));
    Files.delete(handoff.resolve("design-01.answer.md"));
    Files.delete(handoff.resolve("design-01.prompt.md"));
    ChatModel again = run(false);
    assertEquals("one", again.chat(request("first")).text());
    assertFalse(Files.exists(handoff.resolve("design-01.prompt.md")));
    assertWaiting(again, "first");
    assertTrue(Files.exists(handoff.resolve("design-01.prompt.md")));
    assertWaiting(again, "second");
  }

  @Test
  void aFileInPlaceOfTheFolderIsReported() throws IOException {
    Files.writeString(handoff, "not a folder");
    ChatModel model = run(false);
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(request("first")));
    assertEquals(Reason.INPUT, e.reason());
    assertEquals("llm.handoff.unwritable", e.diagnostics().get(0).id());
  }

  private ChatModel run(boolean record) {
    return ChatModels.open("handoff:" + handoff, "authored", recordings, record);
  }

  private ChatModel replay() {
    return ChatModels.open("replay", "authored", recordings, false);
  }

  private Path onlyRecording() throws IOException {
    try (var files = Files.list(recordings.resolve("design"))) {
      List<Path> all = files.toList();
      assertEquals(1, all.size(), all.toString());
      return all.get(0);
    }
  }

  private void answer(String name, String text) throws IOException {
    Files.writeString(handoff.resolve(name + ".answer.md"), text);
  }

  private static ChatRequest request(String prompt) {
    return ChatRequest.of("design", List.of(ChatMessage.user(prompt)));
  }

  private static void assertWaiting(ChatModel model, String prompt) {
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(request(prompt)));
    assertEquals(Reason.WAITING, e.reason());
    assertEquals("llm.handoff.waiting", e.diagnostics().get(0).id());
  }
}
