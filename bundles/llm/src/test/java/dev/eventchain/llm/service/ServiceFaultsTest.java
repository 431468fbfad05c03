package dev.eventchain.llm.service;

import static com.github.tomakehurst.wiremock.client.WireMock.aResponse;
import static com.github.tomakehurst.wiremock.client.WireMock.any;
import static com.github.tomakehurst.wiremock.client.WireMock.anyUrl;
import static com.github.tomakehurst.wiremock.stubbing.Scenario.STARTED;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.github.tomakehurst.wiremock.client.ResponseDefinitionBuilder;
import com.github.tomakehurst.wiremock.http.Fault;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import java.io.IOException;
import java.net.ServerSocket;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Faults between client and service: each ends in one finding that names it. */
class ServiceFaultsTest {

  @RegisterExtension static final FakeService SERVICE = new FakeService();

  private Diagnostic finding(ChatModel model) {
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(FakeService.question()));
    assertEquals(Reason.UNAVAILABLE, e.reason());
    Diagnostic finding = e.diagnostics().get(0);
    assertFalse(finding.toString().contains(FakeService.KEY), finding::toString);
    assertFalse(finding.hint().isBlank(), finding::toString);
    return finding;
  }

  private Diagnostic finding(Wire wire, ResponseDefinitionBuilder response) {
    SERVICE.answers(response);
    return finding(SERVICE.model(wire));
  }

  /** Gives one response, and then a good one. */
  private void answersThenWell(Wire wire, ResponseDefinitionBuilder first) throws IOException {
    SERVICE
        .server()
        .stubFor(
            any(anyUrl())
                .inScenario("again")
                .whenScenarioStateIs(STARTED)
                .willReturn(first)
                .willSetStateTo("well"));
    SERVICE
        .server()
        .stubFor(
            any(anyUrl())
                .inScenario("again")
                .whenScenarioStateIs("well")
                .willReturn(FakeService.ok(wire, FakeService.body(wire, "good"))));
  }

  private ChatModel patient(Wire wire, double deadline, double silence) {
    return SERVICE.model(
        SERVICE.service(
            wire,
            Duration.ofMillis(Math.round(deadline * 1000)),
            Duration.ofMillis(Math.round(silence * 1000))));
  }

  @ParameterizedTest
  @EnumSource
  void aServiceThatIsAskedTooOftenIsLeftAloneForAsLongAsItSays(Wire wire) throws IOException {
    answersThenWell(wire, aResponse().withStatus(429).withHeader("Retry-After", "1"));
    long before = System.nanoTime();
    SERVICE.model(wire).chat(FakeService.question());
    assertTrue(System.nanoTime() - before >= 1_000_000_000L);
    assertEquals(2, SERVICE.requests().size());
    assertTrue(SERVICE.progress.get(0).contains("again in 1 s"), SERVICE.progress::toString);
  }

  @Test
  void itMayNameADateInstead() throws IOException {
    String date =
        DateTimeFormatter.RFC_1123_DATE_TIME.format(
            Instant.now().plusSeconds(2).atOffset(ZoneOffset.UTC));
    answersThenWell(Wire.OPENAI, aResponse().withStatus(503).withHeader("Retry-After", date));
    SERVICE.model(Wire.OPENAI).chat(FakeService.question());
    assertEquals(2, SERVICE.requests().size());
  }

  @Test
  void nobodyWaitsLongerThanTheDeadline() {
    Diagnostic finding =
        finding(Wire.OPENAI, aResponse().withStatus(429).withHeader("Retry-After", "3600"));
    assertEquals("llm.service.limited", finding.id());
    assertEquals(1, SERVICE.requests().size());
  }

  @ParameterizedTest
  @EnumSource
  void aBrokenServiceIsAskedThreeTimes(Wire wire) {
    Diagnostic finding =
        finding(
            wire,
            aResponse().withStatus(500).withHeader("Retry-After", "0").withBody("{\"error\": {}}"));
    assertEquals("llm.service.failed", finding.id());
    assertTrue(finding.message().contains("HTTP status 500"), finding::message);
    assertEquals(3, SERVICE.requests().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "400 | {'error': {'message': 'Invalid schema for response_format model'}} | true",
        "400 | {'error': {'message': 'This model does not support response format'}} | true",
        "400 | {'error': {'message': 'output_config.format.schema: too complex'}} | true",
        "400 | {'error': 'failed to parse grammar'} | true",
        "400 | {'error': {'message': 'too long a context'}} | false",
        "401 | {'error': {'message': 'no schema for you'}} | false"
      })
  void aSchemaThatIsRefusedIsCalledThat(int status, String body, boolean named) throws IOException {
    ChatRequest withSchema = FakeService.questionWithSchema();
    for (Wire wire : Wire.values()) {
      SERVICE.server().resetAll();
      SERVICE.answers(aResponse().withStatus(status).withBody(body.replace('\'', '"')));
      ChatModel model = SERVICE.model(wire);
      DiagnosticException e = assertThrows(DiagnosticException.class, () -> model.chat(withSchema));
      String message = e.diagnostics().get(0).message();
      assertEquals(named, message.contains("rejects the JSON Schema"), message);
      assertFalse(finding(model).message().contains("rejects the JSON Schema"), message);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "401 | {'error': {'message': 'Incorrect key sk-secret-0123456789'}} | llm.key.refused"
            + " | Incorrect key ***",
        "403 | {'error': {'message': 'no right'}} | llm.key.refused | no right",
        "400 | {'error': {'message': 'too long a context'}} | llm.request.rejected | too long",
        "404 | {'error': 'model not found'} | llm.request.rejected | model not found",
        "429 | {'error': {'message': 'You exceeded your current quota', 'type':"
            + " 'insufficient_quota'}} | llm.quota.spent | insufficient_quota",
        "400 | {'error': {'message': 'Your credit balance is too low'}} | llm.quota.spent | credit",
        "302 | moved | llm.request.rejected | HTTP status 302",
        "422 | <html><b>no</b></html> | llm.request.rejected | HTTP status 422"
      })
  void whatWillNotPassIsNotTriedAgain(int status, String body, String id, String part) {
    for (Wire wire : Wire.values()) {
      SERVICE.server().resetAll();
      Diagnostic finding =
          finding(
              wire,
              aResponse()
                  .withStatus(status)
                  .withHeader("Location", SERVICE.server().baseUrl() + "/elsewhere")
                  .withBody(body.replace('\'', '"')));
      assertEquals(id, finding.id(), finding::toString);
      assertTrue(finding.message().contains(part), finding::message);
      assertEquals(1, SERVICE.requests().size(), wire::id);
    }
  }

  @ParameterizedTest
  @EnumSource
  void aBodyThatDribblesInEndsAtTheDeadlineOfTheWholeCall(Wire wire) throws IOException {
    SERVICE.answers(
        FakeService.ok(wire, FakeService.body(wire, "good")).withChunkedDribbleDelay(20, 6_000));
    Diagnostic finding = finding(patient(wire, 1.5, 10));
    assertEquals("llm.answer.late", finding.id());
    assertTrue(finding.message().contains("within 1.5 s"), finding::message);
  }

  @ParameterizedTest
  @EnumSource
  void aServiceThatFallsSilentIsGivenUp(Wire wire) throws IOException {
    SERVICE.answers(
        FakeService.ok(wire, FakeService.body(wire, "good")).withChunkedDribbleDelay(2, 3_000));
    Diagnostic finding = finding(patient(wire, 25, 0.5));
    assertEquals("llm.answer.late", finding.id());
    assertTrue(finding.message().contains("nothing arrived for 0.5 s"), finding::message);
  }

  @Test
  void aServiceThatNeverBeginsToAnswerIsGivenUp() {
    SERVICE.answers(aResponse().withFixedDelay(4_000));
    assertEquals("llm.answer.late", finding(patient(Wire.OPENAI, 0.7, 10)).id());
  }

  @ParameterizedTest
  @EnumSource
  void aStreamWithoutItsEndIsNoAnswer(Wire wire) throws IOException {
    String body = FakeService.body(wire, "good");
    String cut = body.substring(0, body.indexOf("forty"));
    cut = cut.substring(0, cut.lastIndexOf('\n') + 1);
    Diagnostic finding = finding(wire, FakeService.ok(wire, cut));
    assertEquals("llm.answer.cut", finding.id(), finding::toString);
    assertEquals(1, SERVICE.requests().size(), "a part of it had come, and may be paid for");
  }

  @ParameterizedTest
  @EnumSource
  void aConnectionThatBreaksInTheMiddleIsNoEnd(Wire wire) {
    SERVICE.answers(aResponse().withStatus(200).withFault(Fault.MALFORMED_RESPONSE_CHUNK));
    String id = finding(patient(wire, 20, 10)).id();
    assertTrue(id.equals("llm.answer.cut") || id.equals("llm.answer.unreadable"), id);
  }

  @ParameterizedTest
  @EnumSource(
      value = Fault.class,
      names = {"EMPTY_RESPONSE", "CONNECTION_RESET_BY_PEER"})
  void aConnectionThatBreaksBeforeAnAnswerIsTriedAgain(Fault fault) throws IOException {
    answersThenWell(Wire.OPENAI, aResponse().withFault(fault));
    SERVICE.model(Wire.OPENAI).chat(FakeService.question());
    assertEquals(2, SERVICE.requests().size());
  }

  @ParameterizedTest
  @EnumSource
  void anErrorInTheMiddleIsNoAnswer(Wire wire) throws IOException {
    String body = FakeService.body(wire, "good");
    int middle = wire == Wire.OLLAMA ? body.indexOf('\n') + 1 : body.indexOf("\n\n") + 2;
    String event =
        switch (wire) {
          case OLLAMA -> "{\"error\": \"out of memory\"}\n";
          case ANTHROPIC ->
              "event: error\ndata: {\"type\": \"error\", \"error\": {\"type\": \"overloaded_error\","
                  + " \"message\": \"Overloaded: out of memory\"}}\n\n";
          default -> "data: {\"error\": {\"message\": \"out of memory\", \"code\": 500}}\n\n";
        };
    Diagnostic finding =
        finding(
            wire, FakeService.ok(wire, body.substring(0, middle) + event + body.substring(middle)));
    assertEquals("llm.service.failed", finding.id(), finding::toString);
    assertTrue(finding.message().contains("out of memory"), finding::message);
  }

  @ParameterizedTest
  @EnumSource
  void aWebPageIsNoAnswer(Wire wire) {
    Diagnostic finding =
        finding(
            wire,
            aResponse()
                .withStatus(200)
                .withHeader("Content-Type", "text/html; charset=utf-8")
                .withBody("<html><body>Please <b>sign in</b></body></html>"));
    assertEquals("llm.answer.unreadable", finding.id());
    assertTrue(finding.message().contains("Please sign in"), finding::message);
    assertEquals(1, SERVICE.requests().size());
  }

  @ParameterizedTest
  @EnumSource
  void jsonThatIsCutIsOneClearMessage(Wire wire) {
    String broken =
        wire == Wire.OLLAMA ? "{\"model\": \"x\", \"mess\n" : "data: {\"choices\": [\n\n";
    Diagnostic finding = finding(wire, FakeService.ok(wire, broken));
    assertEquals("llm.answer.unreadable", finding.id(), finding::toString);
    assertFalse(finding.message().contains("Exception"), finding::message);
    assertEquals(1, SERVICE.requests().size());
  }

  @Test
  void nobodyListens() throws IOException {
    int port;
    try (ServerSocket socket = new ServerSocket(0)) {
      port = socket.getLocalPort();
    }
    ModelService nowhere =
        new ModelService(
            "fake",
            Wire.OPENAI,
            URI.create("http://localhost:" + port + "/v1"),
            Optional.empty(),
            Duration.ofSeconds(3),
            Duration.ofSeconds(1),
            100);
    Diagnostic finding = finding(SERVICE.model(nowhere));
    assertEquals("llm.service.unreachable", finding.id());
    assertTrue(finding.message().contains("localhost:" + port), finding::message);
  }

  @Test
  void aKeyThatIsNotSetIsSaidBeforeAnythingIsSent() {
    ModelService keyed =
        ModelService.of(
            "other", Wire.OPENAI, URI.create(SERVICE.server().baseUrl()), Optional.of("NO_KEY"));
    Diagnostic finding = finding(SERVICE.model(keyed));
    assertEquals("llm.key.missing", finding.id());
    assertTrue(finding.message().contains("NO_KEY"), finding::message);
    assertEquals(0, SERVICE.requests().size());
  }

  @ParameterizedTest
  @CsvSource({"0", "6000"})
  void anInterruptedCallEndsAtOnce(int delay) throws Exception {
    SERVICE.answers(
        FakeService.ok(Wire.OPENAI, FakeService.body(Wire.OPENAI, "good"))
            .withFixedDelay(delay)
            .withChunkedDribbleDelay(10, 6_000));
    Throwable[] thrown = new Throwable[1];
    Thread asking =
        new Thread(
            () -> {
              try {
                SERVICE.model(Wire.OPENAI).chat(FakeService.question());
              } catch (CancellationException e) {
                thrown[0] = e;
              }
            });
    asking.start();
    while (SERVICE.requests().isEmpty()) {
      Thread.sleep(10);
    }
    asking.interrupt();
    asking.join(10_000);
    assertFalse(asking.isAlive());
    assertTrue(thrown[0] instanceof CancellationException);
  }
}
