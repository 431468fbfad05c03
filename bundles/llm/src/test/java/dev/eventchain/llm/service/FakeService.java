package dev.eventchain.llm.service;

import static com.github.tomakehurst.wiremock.client.WireMock.aResponse;
import static com.github.tomakehurst.wiremock.client.WireMock.any;
import static com.github.tomakehurst.wiremock.client.WireMock.anyUrl;
import static com.github.tomakehurst.wiremock.core.WireMockConfiguration.wireMockConfig;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.github.tomakehurst.wiremock.WireMockServer;
import com.github.tomakehurst.wiremock.client.ResponseDefinitionBuilder;
import com.github.tomakehurst.wiremock.verification.LoggedRequest;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.Sampling;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** A local service with prepared responses. */
public final class FakeService implements BeforeAllCallback, BeforeEachCallback, AfterAllCallback {

  public static final String KEY = "sk-secret-0123456789";
  public static final String VARIABLE = "FAKE_API_KEY";

  final List<String> progress = new ArrayList<>();
  private final WireMockServer server = new WireMockServer(wireMockConfig().dynamicPort());

  @Override
  public void beforeAll(ExtensionContext context) {
    server.start();
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    server.resetAll();
    progress.clear();
  }

  @Override
  public void afterAll(ExtensionContext context) {
    server.stop();
  }

  public WireMockServer server() {
    return server;
  }

  public List<LoggedRequest> requests() {
    return server.findAll(
        com.github.tomakehurst.wiremock.client.WireMock.anyRequestedFor(anyUrl()));
  }

  /** Answers each request with a file in the protocol. */
  public void answers(Wire wire, String file) throws IOException {
    answers(ok(wire, body(wire, file)));
  }

  public void answers(ResponseDefinitionBuilder response) {
    server.stubFor(any(anyUrl()).willReturn(response));
  }

  static ResponseDefinitionBuilder ok(Wire wire, String body) {
    String type = wire == Wire.OLLAMA ? "application/x-ndjson" : "text/event-stream";
    return aResponse().withStatus(200).withHeader("Content-Type", type).withBody(body);
  }

  static String body(Wire wire, String file) throws IOException {
    String name = wire == Wire.OPENAI_COMPATIBLE ? "openai" : wire.id();
    return Files.readString(Path.of("src/test/resources/wires", name + "." + file));
  }

  ModelService service(Wire wire) {
    return service(wire, Duration.ofSeconds(30), Duration.ofSeconds(10));
  }

  ModelService service(Wire wire, Duration deadline, Duration silence) {
    return new ModelService(
        "fake",
        wire,
        URI.create(server.baseUrl() + (wire == Wire.OLLAMA ? "" : "/v1")),
        Optional.of(VARIABLE),
        deadline,
        silence,
        ModelService.MAXIMUM_TOKENS);
  }

  ChatModel model(Wire wire) {
    return model(service(wire));
  }

  ChatModel model(ModelService service) {
    return new ServiceModel(
        service,
        new ModelName("fake", "some-model"),
        name -> name.equals(VARIABLE) ? KEY : null,
        progress::add,
        Duration.ofMillis(20));
  }

  public static ChatRequest question() {
    return ChatRequest.of("design", List.of(ChatMessage.user("What is the answer?")));
  }

  public static ChatRequest conversation() {
    return ChatRequest.of(
        "design",
        List.of(
            ChatMessage.user("first"), ChatMessage.assistant("second"), ChatMessage.user("third")));
  }

  static ChatRequest questionWithSchema() throws IOException {
    String schema =
        """
        {"type": "object", "properties": {"answer": {"type": "string"}}, "required": ["answer"],
         "additionalProperties": false}
        """;
    return new ChatRequest(
        "design",
        question().messages(),
        Optional.of(AnswerSchema.of(new ObjectMapper().readTree(schema))),
        Sampling.DEFAULT);
  }
}
