package dev.eventchain.llm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.github.tomakehurst.wiremock.verification.LoggedRequest;
import dev.eventchain.llm.ChatResponse.FinishReason;
import dev.eventchain.llm.ChatResponse.Usage;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Questions and answers in the format of each kind of SERVICE. */
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
}
