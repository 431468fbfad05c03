package dev.eventchain.llm.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.github.tomakehurst.wiremock.verification.LoggedRequest;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.ModelAccess;
import dev.eventchain.llm.Spending;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ChatResponse.Usage;
import dev.eventchain.llm.chat.Sampling;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Requests and answers in the format of each protocol. */
class WiresTest {

  @RegisterExtension static final FakeService SERVICE = new FakeService();

  @ParameterizedTest
  @CsvSource({
    "OPENAI, gpt-5-mini-2025-08-07, 7",
    "OPENAI_COMPATIBLE, gpt-5-mini-2025-08-07, 7",
    "GEMINI, gemini-2.5-flash, 12",
    "ANTHROPIC, claude-haiku-4-5-20251001, 7",
    "OLLAMA, llama3.2, 7"
  })
  void anAnswerIsReadWithItsModelAndItsTokens(Wire wire, String model, long output)
      throws IOException {
    SERVICE.answers(wire, "good");
    ChatResponse response = SERVICE.model(wire).chat(FakeService.question());
    assertEquals("{\"answer\": \"forty two\"}", response.text());
    assertEquals(FinishReason.STOP, response.finishReason());
    assertEquals(model, response.model());
    assertEquals("fake", response.provenance());
    assertEquals(Optional.of(new Usage(11, output)), response.usage());
  }

  @ParameterizedTest
  @EnumSource
  void anAnswerThatIsCutAtItsLimitSaysSo(Wire wire) throws IOException {
    SERVICE.answers(wire, "length");
    ChatResponse response = SERVICE.model(wire).chat(FakeService.question());
    assertEquals(FinishReason.LENGTH, response.finishReason());
  }

  @ParameterizedTest
  @EnumSource(names = {"OPENAI", "GEMINI", "ANTHROPIC"})
  void aRefusalIsNoAnswer(Wire wire) throws IOException {
    SERVICE.answers(wire, "refused");
    FinishReason reason = SERVICE.model(wire).chat(FakeService.question()).finishReason();
    assertTrue(reason == FinishReason.REFUSAL || reason == FinishReason.OTHER, reason::name);
  }

  @ParameterizedTest
  @EnumSource
  void theSchemaGoesAlongAsItIs(Wire wire) throws IOException {
    SERVICE.answers(wire, "good");
    SERVICE.model(wire).chat(FakeService.questionWithSchema());
    JsonNode sent = new ObjectMapper().readTree(SERVICE.requests().get(0).getBodyAsString());
    List<JsonNode> schemas = sent.findParents("properties");
    assertEquals(1, schemas.size(), sent::toPrettyString);
    assertTrue(schemas.get(0).path("properties").has("answer"), sent::toPrettyString);
  }

  private static ModelAccess access(String settings) {
    ModelAccess usual = ModelAccess.of("live", Path.of("target/no-recordings"), false);
    ModelServices services =
        ModelServices.read(
            Document.parse(
                    SourceText.of("eventchain.yaml", settings),
                    DocumentFormat.YAML,
                    DocumentRules.all(Rule.error("x")),
                    finding -> fail(finding.toString()))
                .object("", finding -> fail(finding.toString()))
                .orElseThrow());
    return new ModelAccess(
        usual.source(),
        usual.recordings(),
        false,
        services,
        new Spending(services),
        name -> FakeService.KEY,
        usual.progress(),
        usual.findings());
  }

  /** A temperature and a seed are sent, each in the field of its service, where it has one. */
  @ParameterizedTest
  @CsvSource({
    "OPENAI, /temperature, /seed",
    "OPENAI_COMPATIBLE, /temperature, /seed",
    "GEMINI, /generationConfig/temperature, /generationConfig/seed",
    "ANTHROPIC, /temperature, ",
    "OLLAMA, /options/temperature, /options/seed"
  })
  void theSamplingOfTheSettingsIsSent(Wire wire, String temperature, String seed)
      throws IOException {
    SERVICE.answers(wire, "good");
    ModelAccess access =
        access(
            "services: {fake: {wire: %s, url: '%s', key: %s, temperature: 0.5, seed: 7}}"
                .formatted(wire.id(), SERVICE.service(wire).url(), FakeService.VARIABLE));
    ChatModels.open(access, List.of("fake/some-model")).chat(FakeService.question());
    JsonNode sent = new ObjectMapper().readTree(SERVICE.requests().get(0).getBodyAsString());
    assertEquals(0.5, sent.at(temperature).doubleValue(), sent::toPrettyString);
    if (seed != null) {
      assertEquals(7, sent.at(seed).intValue(), sent::toPrettyString);
    }
  }

  /** Each service takes one shape, in its own field. */
  @ParameterizedTest
  @CsvSource({
    "OPENAI, nested, /response_format/json_schema/schema",
    "OPENAI_COMPATIBLE, nested, /response_format/json_schema/schema",
    "GEMINI, flat, /generationConfig/responseJsonSchema",
    "ANTHROPIC, flat, /output_config/format/schema",
    "OLLAMA, nested, /format"
  })
  void theShapeOfTheSchemaIsThatOfTheService(Wire wire, String shape, String field)
      throws IOException {
    SERVICE.answers(wire, "good");
    String key = "services: {fake: {wire: %s, url: '%s', key: %s}}";
    ModelAccess access =
        access(key.formatted(wire.id(), SERVICE.service(wire).url(), FakeService.VARIABLE));
    ObjectMapper mapper = new ObjectMapper();
    JsonNode nested = mapper.readTree(schema("nested"));
    JsonNode flat = mapper.readTree(schema("flat"));
    ChatRequest request =
        new ChatRequest(
            "design",
            FakeService.question().messages(),
            Optional.of(new AnswerSchema(nested, flat)),
            Sampling.DEFAULT);
    ChatModels.open(access, List.of("fake/some-model")).chat(request);
    JsonNode sent = mapper.readTree(SERVICE.requests().get(0).getBodyAsString());
    assertEquals(mapper.readTree(schema(shape)), sent.at(field), sent::toPrettyString);
  }

  private static String schema(String description) {
    return """
    {"type": "object", "properties": {"answer": {"type": "string"}}, "required": ["answer"],
     "additionalProperties": false, "description": "%s"}
    """
        .formatted(description);
  }

  @ParameterizedTest
  @EnumSource
  void answersAreNeverCutAtTheLimitOfAClient(Wire wire) throws IOException {
    SERVICE.answers(wire, "good");
    SERVICE.model(wire).chat(FakeService.question());
    String sent = SERVICE.requests().get(0).getBodyAsString();
    assertTrue(sent.matches("(?s).*\\D16384\\D.*"), sent);
  }

  @ParameterizedTest
  @EnumSource
  void theConversationGoesAlongInItsOrder(Wire wire) throws IOException {
    SERVICE.answers(wire, "good");
    SERVICE.model(wire).chat(FakeService.conversation());
    String sent = SERVICE.requests().get(0).getBodyAsString();
    assertTrue(sent.matches("(?s).*first.*second.*third.*"), sent);
  }

  @ParameterizedTest
  @EnumSource
  void theKeyGoesInAHeaderAndNeverInTheAddress(Wire wire) throws IOException {
    SERVICE.answers(wire, "good");
    SERVICE.model(wire).chat(FakeService.question());
    LoggedRequest sent = SERVICE.requests().get(0);
    assertTrue(sent.getHeaders().toString().contains(FakeService.KEY), wire::id);
    assertFalse(sent.getUrl().contains(FakeService.KEY), wire::id);
  }

  @ParameterizedTest
  @EnumSource
  void aServiceMayWantNoKey(Wire wire) throws IOException {
    SERVICE.answers(wire, "good");
    ModelService keyed = SERVICE.service(wire);
    ModelService open = ModelService.of("fake", wire, keyed.url(), Optional.empty());
    assertEquals(
        FinishReason.STOP, SERVICE.model(open).chat(FakeService.question()).finishReason());
  }
}
