package dev.eventchain.llm.chat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.llm.ChatModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The shape of the schema for each model, and in its recordings. */
class AnswerSchemaTest {

  private static final String NESTED =
      """
      {"type": "object", "description": "nested", "required": ["a", "b", "c"], "properties": {
        "a": {"type": "string"},
        "b": {"anyOf": [{"$ref": "#/$defs/B"}, {"type": "null"}]},
        "c": {"type": "array", "items": {"$ref": "#/$defs/B"}}},
       "$defs": {"B": {"type": "object", "required": ["n"], "properties": {
        "n": {"anyOf": [{"type": "number"}, {"type": "null"}]}}}}}
      """;

  private static final String FLAT = "{\"type\": \"object\", \"description\": \"flat\"}";

  private static JsonNode json(String text) throws IOException {
    return new JsonMapper().readTree(text);
  }

  private static ChatRequest request() throws IOException {
    return new ChatRequest(
        "model",
        List.of(ChatMessage.user("Model.")),
        Optional.of(new AnswerSchema(json(NESTED), json(FLAT))),
        Sampling.DEFAULT);
  }

  /** The recording of a hand-off is that of the model, and replay finds it. */
  @ParameterizedTest
  @CsvSource({
    "openai/gpt-5, nested, 3",
    "llamacpp/qwen, nested, 3",
    "ollama/qwen, nested, 3",
    "gemini/gemini-2.5-flash, flat, 0",
    "anthropic/claude-opus-4-5, flat, 0",
    "authored, nested, 1",
    "nowhere/unknown, nested, 1"
  })
  void aModelHasItsShapeHoweverItsAnswersCome(
      String model, String shape, int required, @TempDir Path folder) throws IOException {
    Path handoff = folder.resolve("handoff");
    Path recordings = folder.resolve("recordings");
    assertThrows(DiagnosticException.class, () -> handoff(model, handoff, recordings));
    String prompt = Files.readString(handoff.resolve("model-01.prompt.md"));
    assertTrue(prompt.stripTrailing().endsWith("Model."), "a person reads no schema");
    Files.writeString(handoff.resolve("model-01.answer.md"), "{}");
    handoff(model, handoff, recordings);
    assertEquals(
        "{}", ChatModels.open("replay", model, recordings, false).chat(request()).text().strip());
    try (Stream<Path> files = Files.list(recordings.resolve("model"))) {
      JsonNode schema =
          json(Files.readString(files.findFirst().orElseThrow())).at("/request/schema");
      assertEquals(shape, schema.path("description").asText());
      assertEquals(required, schema.path("required").size());
    }
  }

  private static void handoff(String model, Path handoff, Path recordings) throws IOException {
    ChatModels.open("handoff:" + handoff, model, recordings, true).chat(request());
  }

  @Test
  void aProgramIsToldTheSchema(@TempDir Path folder) throws IOException {
    Path prompt = folder.resolve("prompt");
    ChatModel model =
        ChatModels.open("command:sh -c 'tee " + prompt + "'", "authored", folder, false);
    model.chat(request());
    assertTrue(Files.readString(prompt).contains("The answer must satisfy this JSON Schema:"));
  }

  @Test
  void nothingIsSentBeforeAShapeIsChosen() throws IOException {
    ChatRequest request = request();
    ModelName model = ModelName.parse("openai/gpt-5");
    assertThrows(IllegalStateException.class, () -> RequestJson.of(model, request));
  }
}
