package dev.eventchain.llm.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Answers from recordings, and the messages when there is none. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ReplayTest {
  private static final ModelName MODEL = ModelName.parse("authored");
  private static final Path BROKEN = Path.of("src/test/resources/broken");
  private static final String PROMPT =
      "# Task\nDesign a chain.\n\n# Requirements\n- R-1: stop\n\n# End";

  @Test
  void aMissingRecordingShowsWhatChangedAgainstTheNearestOne(@TempDir Path recordings) {
    record(recordings, "something else altogether");
    Path nearest = record(recordings, PROMPT);
    Diagnostic diagnostic = missing(recordings, PROMPT.replace("R-1: stop", "R-1: stop at once"));
    assertEquals(
        """
        There is no recording of task 'design' for model 'authored' with this prompt. What changed \
        compared with the nearest one, %s:
          # Requirements
        - - R-1: stop
        + - R-1: stop at once
          \
        """
            .formatted(nearest.getFileName()),
        diagnostic.message());
    assertTrue(diagnostic.hint().contains("--llm handoff:FOLDER --record"), diagnostic.hint());
  }

  @Test
  void anotherModelIsNamedAsTheChange(@TempDir Path recordings) {
    record(recordings, PROMPT);
    ChatModel model = ChatModels.open("replay", "openai/gpt-4o", recordings, false);
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(request(PROMPT)));
    String message = e.diagnostics().get(0).message();
    assertTrue(
        message.endsWith(
            ":\n  provider: \"handoff\" -> \"openai\"\n  model: \"authored\" -> \"gpt-4o\""),
        message);
  }

  @Test
  void withoutAnyRecordingOfTheTaskTheMessageSaysSo(@TempDir Path recordings) {
    Diagnostic diagnostic = missing(recordings, PROMPT);
    assertTrue(diagnostic.message().endsWith(", and none of the task to compare it with."));
  }

  @Test
  void aLongDifferenceIsCutAndSaysByHowMuch(@TempDir Path recordings) {
    record(recordings, "a\n".repeat(300));
    String message = missing(recordings, "b\n".repeat(300)).message();
    assertEquals(1 + 24 + 1, message.lines().count());
    assertTrue(message.endsWith("... and 577 more lines"), message);
  }

  @Test
  void aBrokenRecordingBesideAMissingOneIsReportedToo(@TempDir Path recordings) throws IOException {
    Path file = record(recordings, PROMPT);
    Files.writeString(file, "{");
    ChatModel model = replay(recordings);
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(request("other")));
    assertEquals(
        List.of("llm.recording.missing", "llm.recording.json"),
        e.diagnostics().stream().map(Diagnostic::id).toList());
  }

  @Test
  void aRenamedRecordingIsRefused(@TempDir Path recordings) throws IOException {
    Path one = record(recordings, "one");
    Path other = record(recordings, "other");
    Files.copy(other, one, StandardCopyOption.REPLACE_EXISTING);
    ChatModel model = replay(recordings);
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(request("one")));
    assertEquals("llm.recording.key", e.diagnostics().get(0).id());
  }

  @Test
  void whatIsWrittenIsReadBack(@TempDir Path recordings) {
    String text = "line\n\n  \"quoted\" {{brace}} \u00e4\ud83d\ude97\ttab\n";
    ObjectNode request = RequestJson.of(MODEL, request(text));
    ChatResponse response =
        new ChatResponse(
            text,
            ChatResponse.FinishReason.LENGTH,
            "gpt-4o-2024-08-06",
            "openai",
            Optional.of(new ChatResponse.Usage(12, 7)));
    new RecordingFolder(recordings)
        .put("design", MODEL, request, 0, new Recording.Sample("2026-11-21T00:00:00Z", response));
    assertEquals(response, replay(recordings).chat(request(text)));
  }

  @ParameterizedTest
  @MethodSource
  void aBrokenRecordingIsReportedWithItsPlace(Path file) throws IOException {
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> RecordingReader.read(file));
    assertEquals(Reason.INPUT, e.reason());
    String actual = String.join("", e.diagnostics().stream().map(ReplayTest::line).toList());
    ExpectedFile.check(ExpectedFile.beside(file), actual);
  }

  static Stream<Path> aBrokenRecordingIsReportedWithItsPlace() throws IOException {
    try (Stream<Path> files = Files.list(BROKEN)) {
      return files.filter(file -> file.toString().endsWith(".json")).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "reply", "handoff", "handoff:", "handoff:a\0b"})
  void anUnknownProviderIsRefused(String specification, @TempDir Path recordings) {
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class,
            () -> ChatModels.open(specification, "authored", recordings, false));
    assertEquals(Reason.INPUT, e.reason());
    assertTrue(
        List.of("llm.provider.unknown", "llm.handoff.folder")
            .contains(e.diagnostics().get(0).id()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "openai/", "/gpt-4o"})
  void aModelWithoutANameIsRefused(String name, @TempDir Path recordings) {
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class, () -> ChatModels.open("replay", name, recordings, false));
    assertEquals("llm.model.name", e.diagnostics().get(0).id());
  }

  private static String line(Diagnostic diagnostic) {
    return String.format(
        Locale.ROOT,
        "%d:%d %s %s: %s\n",
        diagnostic.location().line(),
        diagnostic.location().column(),
        diagnostic.location().element(),
        diagnostic.id(),
        diagnostic.message().replace("\n", " "));
  }

  private static Diagnostic missing(Path recordings, String prompt) {
    ChatModel model = replay(recordings);
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(request(prompt)));
    assertEquals(Reason.INPUT, e.reason());
    assertEquals("llm.recording.missing", e.diagnostics().get(0).id());
    return e.diagnostics().get(0);
  }

  private static ChatModel replay(Path recordings) {
    return ChatModels.open("replay", "authored", recordings, false);
  }

  private static ChatRequest request(String prompt) {
    return ChatRequest.of("design", List.of(ChatMessage.user(prompt)));
  }

  private static Path record(Path recordings, String prompt) {
    ObjectNode request = RequestJson.of(MODEL, request(prompt));
    ChatResponse response =
        new ChatResponse(
            "answer", ChatResponse.FinishReason.STOP, "authored", "authored", Optional.empty());
    RecordingFolder folder = new RecordingFolder(recordings);
    folder.put("design", MODEL, request, 0, new Recording.Sample("2026-11-21T00:00:00Z", response));
    return folder.file("design", MODEL, RequestKey.of(request));
  }
}
