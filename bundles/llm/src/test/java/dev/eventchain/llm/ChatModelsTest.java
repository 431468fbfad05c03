package dev.eventchain.llm;

import static com.github.tomakehurst.wiremock.client.WireMock.aResponse;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.service.FakeService;
import dev.eventchain.llm.service.ModelServices;
import dev.eventchain.llm.service.ServiceProbe;
import dev.eventchain.llm.service.Wire;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The sources of answers, and the budget of a run. */
class ChatModelsTest {

  @RegisterExtension static final FakeService SERVICE = new FakeService();

  private static final String ANSWER = "{\"answer\": \"forty two\"}";

  private final List<Diagnostic> findings = new ArrayList<>();
  private final List<Diagnostic> problems = new ArrayList<>();

  @TempDir Path recordings;

  private ModelServices services(String yaml) {
    return Document.parse(
            SourceText.of("eventchain.yaml", yaml),
            DocumentFormat.YAML,
            DocumentRules.all(Rule.error("project.configuration")),
            problems::add)
        .object("", problems::add)
        .map(ModelServices::read)
        .orElseThrow();
  }

  private ModelServices services() {
    return services(
        """
        services:
          ours: {wire: openai-compatible, url: "%s/v1", key: FAKE_API_KEY}
          gone: {wire: ollama, url: "http://localhost:1"}
        """
            .formatted(SERVICE.server().baseUrl()));
  }

  private ModelAccess access(String source, boolean record, ModelServices services) {
    return new ModelAccess(
        source,
        recordings,
        record,
        services,
        new Spending(services),
        name -> name.equals(FakeService.VARIABLE) ? FakeService.KEY : null,
        message -> {},
        findings::add);
  }

  private static String id(ChatModel model) {
    return assertThrows(DiagnosticException.class, () -> model.chat(FakeService.question()))
        .diagnostics()
        .get(0)
        .id();
  }

  @ParameterizedTest
  @ValueSource(strings = {"live", "auto", "ours/gpt-5-mini"})
  void aServiceAnswers(String source) throws IOException {
    SERVICE.answers(Wire.OPENAI_COMPATIBLE, "good");
    ChatModel model =
        ChatModels.open(access(source, false, services()), List.of("ours/gpt-5-mini"));
    assertEquals(ANSWER, model.chat(FakeService.question()).text());
    assertEquals(List.of(), findings);
    try (Stream<Path> files = Files.list(recordings)) {
      assertEquals(0, files.count(), "nobody asked to record");
    }
  }

  @ParameterizedTest
  @CsvSource({"live, llm.service.unknown", "somewhere, llm.provider.unknown"})
  void aWayThatIsNoneIsSaidAtOnce(String source, String id) {
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class,
            () -> ChatModels.open(access(source, false, services()), List.of("nobody/model")));
    assertEquals(id, e.diagnostics().get(0).id());
  }

  @Test
  void whatIsRecordedIsNotAskedAgain() throws IOException {
    SERVICE.answers(Wire.OPENAI_COMPATIBLE, "good");
    List<String> models = List.of("ours/gpt-5-mini");
    ChatModel first = ChatModels.open(access("auto", true, services()), models);
    first.chat(FakeService.question());
    first.chat(FakeService.question());
    assertEquals(2, SERVICE.requests().size());
    for (String source : List.of("auto", "replay")) {
      ChatModel again = ChatModels.open(access(source, true, services()), models);
      assertEquals(ANSWER, again.chat(FakeService.question()).text());
      assertEquals(ANSWER, again.chat(FakeService.question()).text());
    }
    assertEquals(2, SERVICE.requests().size());
  }

  @Test
  void theKeyIsInNoRecording() throws IOException {
    SERVICE.answers(Wire.OPENAI_COMPATIBLE, "good");
    ChatModels.open(access("live", true, services()), List.of("ours/gpt-5-mini"))
        .chat(FakeService.question());
    assertTrue(SERVICE.requests().get(0).getHeader("Authorization").contains(FakeService.KEY));
    try (Stream<Path> files = Files.walk(recordings)) {
      List<Path> written = files.filter(Files::isRegularFile).toList();
      assertEquals(1, written.size());
      assertFalse(Files.readString(written.get(0)).contains(FakeService.KEY));
    }
  }

  @Test
  void whereOneCannotBeReachedTheNextOneAnswersAndThatIsSaid() throws IOException {
    SERVICE.answers(Wire.OPENAI_COMPATIBLE, "good");
    ModelServices services =
        services(
            """
            services:
              ours: {wire: openai-compatible, url: "%s/v1"}
              keyed: {wire: anthropic, url: "http://localhost:1", key: NOT_SET}
            """
                .formatted(SERVICE.server().baseUrl()));
    ChatModel model =
        ChatModels.open(access("live", false, services), List.of("keyed/first", "ours/gpt-5-mini"));
    assertEquals(ANSWER, model.chat(FakeService.question()).text());
    assertEquals(List.of("llm.model.fallback"), findings.stream().map(Diagnostic::id).toList());
    String message = findings.get(0).message();
    assertTrue(message.contains("ours/gpt-5-mini answered the task 'design' instead of"), message);
    assertTrue(message.contains("NOT_SET"), message);
  }

  @Test
  void whereNobodyCanBeReachedTheFirstReasonIsSaid() {
    SERVICE.answers(aResponse().withStatus(401));
    ChatModel model =
        ChatModels.open(access("live", false, services()), List.of("ours/a", "gone/b"));
    assertEquals("llm.key.refused", id(model));
  }

  @Test
  void anotherModelThanTheOneThatWasAskedIsSaid() throws IOException {
    SERVICE.answers(Wire.OPENAI_COMPATIBLE, "good");
    ChatModels.open(access("live", false, services()), List.of("ours/gpt-4o"))
        .chat(FakeService.question());
    assertEquals(List.of("llm.model.differs"), findings.stream().map(Diagnostic::id).toList());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{tokens: 30} | 2 | llm.budget.spent",
        "{tokens: 18} | 1 | llm.budget.spent",
        "{cost: 0.00002} | 1 | llm.budget.spent",
        "{cost: 0.00005} | 2 | llm.budget.spent"
      })
  void aSpentBudgetEndsTheRun(String budget, int calls, String id) throws IOException {
    SERVICE.answers(Wire.OPENAI_COMPATIBLE, "good");
    // 11 tokens in and 7 out: 0.000025 per call.
    ModelServices services =
        services(
            """
            services: {ours: {wire: openai-compatible, url: "%s/v1"}}
            prices: {ours/gpt-5-mini: {input_per_million: 1, output_per_million: 2}}
            budget: %s
            """
                .formatted(SERVICE.server().baseUrl(), budget));
    ModelAccess access = access("live", false, services);
    ChatModel model = ChatModels.open(access, List.of("ours/gpt-5-mini"));
    for (int i = 0; i < calls; i++) {
      model.chat(FakeService.question());
    }
    assertEquals(id, id(model));
    assertEquals(calls, SERVICE.requests().size());
    Spending.Line line = access.spending().lines().get(0);
    assertEquals(calls, line.calls());
    assertEquals(11L * calls, line.inputTokens());
    assertEquals(0.000025 * calls, line.cost().orElseThrow().doubleValue(), 1e-12);
  }

  @Test
  void aCostCannotBeLimitedWithoutPrices() {
    ModelServices services =
        services(
            """
            services: {ours: {wire: openai-compatible, url: "%s/v1"}}
            budget: {cost: 1}
            """
                .formatted(SERVICE.server().baseUrl()));
    ChatModel model = ChatModels.open(access("live", false, services), List.of("ours/gpt-5-mini"));
    assertEquals("llm.price.missing", id(model));
    assertEquals(0, SERVICE.requests().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "services: {a: {wire: smoke, url: 'http://h'}} | llm.service.wire",
        "services: {a: {wire: openai, url: 'ftp://h'}} | llm.service.url",
        "services: {a: {wire: openai, url: 'https://user:key@h'}} | llm.service.url",
        "services: {a: {wire: openai}} | project.configuration",
        "services: {openai: {deadline_s: 0}} | project.configuration",
        "services: {openai: {temperature: 3}} | project.configuration",
        "services: {openai: {seed: -1}} | project.configuration",
        "command: {deadline_s: 0} | project.configuration",
        "command: {deadline: 60} | project.configuration",
        "services: {openai: {api_key: sk-1}} | project.configuration",
        "prices: {a/b: {input_per_million: 1}} | project.configuration",
        "budget: {euro: 1} | project.configuration"
      })
  void whatIsWrongInAConfigurationIsFound(String yaml, String id) {
    services(yaml);
    assertTrue(
        problems.stream().anyMatch(problem -> problem.id().startsWith(id)), problems::toString);
    assertTrue(problems.get(0).location().line() > 0);
  }

  @Test
  void aProgramGetsThePromptAndGivesTheAnswer() {
    ChatModel model =
        ChatModels.open(
            access("command:sh -c 'cat; echo \"and more\"'", false, services()), List.of("mine"));
    ChatResponse response = model.chat(FakeService.conversation());
    assertTrue(response.text().contains("first"), response::text);
    assertTrue(response.text().endsWith("and more\n"), response::text);
    assertEquals("command", response.provenance());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "command:sh -c 'echo no credit >&2; exit 3' | exit code 3: no credit",
        "command:/no/such/program | cannot be started",
        "command:false | exit code 1",
        "command:true | wrote nothing to standard output"
      })
  void aProgramThatFailsGivesNoAnswer(String source, String part) {
    ChatModel model = ChatModels.open(access(source, false, services()), List.of("mine"));
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> model.chat(FakeService.question()));
    Diagnostic finding = e.diagnostics().get(0);
    assertEquals("llm.command.failed", finding.id());
    assertTrue(finding.message().contains(part), finding::message);
  }

  @Test
  void whoCanBeReachedIsSeenWithoutAKey() {
    SERVICE.answers(aResponse().withStatus(401));
    List<ServiceProbe.State> states =
        ServiceProbe.look(services(), List.of("ours", "gone", "nobody"), name -> null);
    assertEquals(List.of("gone", "ours"), states.stream().map(ServiceProbe.State::name).toList());
    assertTrue(states.get(0).problem().isPresent());
    assertTrue(states.get(1).problem().isEmpty());
    assertFalse(states.get(1).isReady(), "its key is not set");
  }
}
