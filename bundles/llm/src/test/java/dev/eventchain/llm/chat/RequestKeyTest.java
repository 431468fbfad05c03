package dev.eventchain.llm.chat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

/** Equality of requests. */
class RequestKeyTest {
  private static final ModelName MODEL = ModelName.parse("openai/gpt-4o");

  @Test
  void aKeyStaysWhatItIsFromReleaseToRelease() {
    assertEquals(
        "de0c25ae4d51", key(MODEL, "Design a chain.", null, Sampling.DEFAULT).abbreviated());
  }

  @Test
  void theTaskIsNoPartOfTheKeyBecauseItNamesTheFolder() {
    List<ChatMessage> messages = List.of(ChatMessage.user("x"));
    assertEquals(
        RequestKey.of(RequestJson.of(MODEL, ChatRequest.of("design", messages))),
        RequestKey.of(RequestJson.of(MODEL, ChatRequest.of("model", messages))));
  }

  @Test
  void modelPromptSchemaAndSamplingAreAllPartOfTheKey() {
    RequestKey key = key(MODEL, "x", null, Sampling.DEFAULT);
    assertNotEquals(key, key(ModelName.parse("openai/gpt-5"), "x", null, Sampling.DEFAULT));
    assertNotEquals(key, key(ModelName.parse("groq/gpt-4o"), "x", null, Sampling.DEFAULT));
    assertNotEquals(key, key(MODEL, "y", null, Sampling.DEFAULT));
    assertNotEquals(key, key(MODEL, "x", "{}", Sampling.DEFAULT));
    assertNotEquals(key, key(MODEL, "x", null, temperature(0.5)));
  }

  @Test
  void aNumberIsTheSameHoweverItIsWritten() {
    assertEquals(
        key(MODEL, "x", "{\"minimum\": 10}", Sampling.DEFAULT),
        key(MODEL, "x", "{\"minimum\": 1.0e1}", Sampling.DEFAULT));
    assertNotEquals(
        key(MODEL, "x", "{\"minimum\": 10}", Sampling.DEFAULT),
        key(MODEL, "x", "{\"minimum\": \"10\"}", Sampling.DEFAULT));
  }

  @Test
  void theOrderOfPropertiesInASchemaMattersBecauseItSteersTheModel() {
    assertNotEquals(
        key(MODEL, "x", "{\"a\": 1, \"b\": 2}", Sampling.DEFAULT),
        key(MODEL, "x", "{\"b\": 2, \"a\": 1}", Sampling.DEFAULT));
  }

  @Test
  void aModelNameCannotLeaveTheFolderOfRecordings() {
    assertEquals("_._.._x", ModelName.parse("vllm/../../x").inFileName());
    assertEquals("meta-llama_llama-3", ModelName.parse("groq/meta-llama/llama-3").inFileName());
  }

  private static Sampling temperature(double value) {
    return new Sampling(OptionalDouble.of(value), OptionalInt.empty(), OptionalLong.empty());
  }

  private static RequestKey key(ModelName model, String prompt, String schema, Sampling sampling) {
    Optional<JsonNode> json = Optional.ofNullable(schema).map(RequestKeyTest::parse);
    ChatRequest request =
        new ChatRequest(
            "design", List.of(ChatMessage.user(prompt)), json.map(AnswerSchema::of), sampling);
    return RequestKey.of(RequestJson.of(model, request));
  }

  private static JsonNode parse(String json) {
    try {
      return new JsonMapper().readTree(json);
    } catch (java.io.IOException e) {
      throw new AssertionError(e);
    }
  }
}
