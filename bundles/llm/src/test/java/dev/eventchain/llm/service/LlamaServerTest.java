package dev.eventchain.llm.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.LlamaServer;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.Sampling;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A real server: its streams, refusals and limits. */
class LlamaServerTest {

  private static final String KEY = "sk-of-this-server";
  private static final int CONTEXT = 8_192;
  private static final Duration LONG = Duration.ofMinutes(5);

  private static LlamaServer server;

  @BeforeAll
  static void start() throws IOException, InterruptedException {
    server = LlamaServer.start(KEY, CONTEXT);
  }

  @AfterAll
  static void stop() {
    if (server != null) {
      server.close();
    }
  }

  private static ChatModel model(String key, Consumer<String> progress) {
    ModelService service =
        new ModelService(
            "llamacpp",
            Wire.OPENAI_COMPATIBLE,
            URI.create(server.url()),
            Optional.of("KEY"),
            LONG,
            LONG,
            2_000);
    return new ServiceModel(
        service, new ModelName("llamacpp", "tiny-random"), name -> key, progress);
  }

  private static ChatModel model() {
    return model(KEY, message -> {});
  }

  private static ChatRequest request(
      String text, Optional<JsonNode> schema, int tokens, long seed) {
    Sampling sampling =
        new Sampling(OptionalDouble.of(1.0), OptionalInt.of(tokens), OptionalLong.of(seed));
    return new ChatRequest(
        "design", List.of(ChatMessage.user(text)), schema.map(AnswerSchema::of), sampling);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void evenNonsenseSatisfiesTheSchema(long seed) throws IOException {
    String schema =
        """
        {"type": "object", "additionalProperties": false, "required": ["eClass", "nodes"],
         "properties": {
           "eClass": {"enum": ["EventChain"]},
           "nodes": {"type": "array", "minItems": 1, "maxItems": 2, "items": {
             "type": "object", "additionalProperties": false, "required": ["kind", "next"],
             "properties": {
               "kind": {"enum": ["software", "hardware"]},
               "next": {"type": ["string", "null"], "maxLength": 12}}}}}}
        """;
    ChatResponse response =
        model()
            .chat(
                request("Design.", Optional.of(new ObjectMapper().readTree(schema)), 1_500, seed));
    assertEquals(FinishReason.STOP, response.finishReason(), response::text);
    JsonNode answer = new ObjectMapper().readTree(response.text());
    assertEquals("EventChain", answer.path("eClass").asText());
    assertTrue(answer.path("nodes").size() >= 1 && answer.path("nodes").size() <= 2);
    for (JsonNode node : answer.path("nodes")) {
      assertTrue(List.of("software", "hardware").contains(node.path("kind").asText()));
    }
    assertTrue(response.usage().orElseThrow().outputTokens() > 0);
    assertEquals("tiny-random", response.model());
  }

  /** The schemas of the tasks, in both shapes, with the inputs of the example. */
  @ParameterizedTest
  @CsvSource({"design, nested", "design, flat", "model, nested", "model, flat"})
  void theSchemasOfTheTasksAreSatisfied(String task, String shape) throws IOException {
    Path file =
        Path.of("../agents/src/test/resources/schemas/aeb.%s.%s.json".formatted(task, shape));
    JsonNode schema = new ObjectMapper().readTree(file.toFile());
    JsonSchema validator =
        JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(schema);
    for (long seed = 1; seed <= 4; seed++) {
      ChatResponse response = model().chat(request("Go.", Optional.of(schema), 6_000, seed));
      assertEquals(FinishReason.STOP, response.finishReason(), response::text);
      JsonNode answer =
          JsonMapper.builder()
              .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
              .build()
              .readTree(response.text());
      assertEquals(Set.of(), validator.validate(answer), response::text);
    }
  }

  @Test
  void anAnswerAtItsLimitIsCut() {
    ChatResponse response = model().chat(request("Say much.", Optional.of(endless()), 20, 1));
    assertEquals(FinishReason.LENGTH, response.finishReason());
    assertEquals(20, response.usage().orElseThrow().outputTokens());
  }

  @Test
  void aWrongKeyIsRefused() {
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class,
            () -> model("sk-wrong", message -> {}).chat(request("Hello.", Optional.empty(), 3, 1)));
    Diagnostic finding = e.diagnostics().get(0);
    assertEquals("llm.key.refused", finding.id());
    assertFalse(finding.toString().contains("sk-wrong"), finding::toString);
  }

  @Test
  void aPromptThatIsTooLongIsRefusedInTheServersWords() {
    String text = "much too long ".repeat(2_000);
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class, () -> model().chat(request(text, Optional.empty(), 3, 1)));
    Diagnostic finding = e.diagnostics().get(0);
    assertEquals("llm.request.rejected", finding.id(), finding::toString);
    assertTrue(finding.message().contains("context"), finding::message);
  }

  @Test
  void aCancelledAnswerEndsAndTheNextOneComes() {
    // As soon as a part of the answer has arrived.
    ChatModel cancelled = model(KEY, message -> Thread.currentThread().interrupt());
    assertThrows(
        CancellationException.class,
        () -> cancelled.chat(request("Say much.", Optional.of(endless()), 7_000, 1)));
    assertTrue(Thread.interrupted(), "whoever interrupted can see that it was");
    assertEquals(
        FinishReason.LENGTH,
        model().chat(request("Say much.", Optional.of(endless()), 20, 1)).finishReason());
  }

  /** Returns a schema whose answer cannot end soon. */
  private static JsonNode endless() {
    try {
      return new ObjectMapper().readTree("{\"type\": \"string\", \"minLength\": 1500}");
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
