package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the evaluation of language models from the command line. */
class EvaluateTest {

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String LABEL = "authored by people: not an evaluation of a language model";

  private static final String CRASH =
      """
      tests:
        - {name: a crash, requirement: AEB-4, inputs: {ttc: 0.1}, outputs: {braking_force: 1}}
      """;

  private static final String BRAKES_LATE =
      """
      ```python
      class Braking_Decision:
          \"""Brakes late.\"""

          def execute(self, ttc):
              \"""Take the TTC in s; return the force.\"""
              return {"braking_force": 1.0 if ttc < 0.3 else 0.0}
      ```
      """;

  private static final String KEY = "sk-not-to-be-seen-anywhere";

  private static JsonSchema schema;

  @TempDir Path folder;
  private Path project;

  @BeforeEach
  void copyExample() throws IOException {
    project = Program.exampleIn(folder);
  }

  private Program.Ended evaluate(Object... more) {
    return program().run(Stream.concat(Stream.of("evaluate", project), Stream.of(more)).toArray());
  }

  private static Program program() {
    return new Program().with("OURS_KEY", KEY);
  }

  private JsonNode json() throws IOException {
    return MAPPER.readTree(project.resolve("out/evaluation/evaluation.json").toFile());
  }

  private String page() throws IOException {
    return Files.readString(project.resolve("out/evaluation/evaluation.html"));
  }

  /** Returns the results without machine-dependent values. */
  private static JsonNode withoutHost(JsonNode json) {
    json.findParents("host").forEach(each -> ((ObjectNode) each).remove("host"));
    return json;
  }

  private static String squeezed(String text) {
    return text.replaceAll(" +", " ");
  }

  private void configure(String more) throws IOException {
    Files.writeString(project.resolve("eventchain.yaml"), more, StandardOpenOption.APPEND);
  }

  private static RecordedService service(String wire) throws IOException {
    return new RecordedService(wire, Program.ROOT.resolve("examples/aeb/recordings"));
  }

  private void connect(String wire, RecordedService service) throws IOException {
    String ours = "{wire: %s, url: \"%s\", key: OURS_KEY}".formatted(wire, service.url());
    configure("\nservices:\n  ours: " + ours + "\n");
  }

  @InTurn
  @Test
  void whatPeopleWroteIsCountedOnceAndIsNoEvaluation() throws IOException {
    Program.Ended ended = evaluate("--runs", 5).expect(0);
    String table = squeezed(ended.out());
    assertTrue(table.startsWith("The answers are " + LABEL), table);
    ended.says("1 of 5 runs counted (no recorded answer: 4)");
    ended.says("[evaluation.authored]").says("[evaluation.run.uncounted]");
    String row = "1/1 21–100 % 1/1 21–100 % 1/1 21–100 %";
    assertTrue(table.contains(" without repair " + row + "\n with repair " + row), table);
    JsonNode json = json();
    assertEquals(Set.of(), schema.validate(json));
    assertTrue(json.path("label").asText().contains(LABEL));
    assertTrue(page().contains("The answers are " + LABEL));
    assertTrue(page().contains("<a href=\"authored/run-01/report.html\">authored 1</a>"));
    assertFalse(json.at("/models/0/measuresALanguageModel").asBoolean(true));
    assertEquals("the run's own chain", json.at("/runs/0/implementedFor").asText());
    JsonNode again = again(json);
    assertEquals(json, again, "also what depends on the machine: nothing was run");
    configure("\nrepairs: 2\n");
    assertFalse(evaluate("--runs", 1).expect(0).err().contains("as before"));
  }

  private JsonNode again(JsonNode before) throws IOException {
    evaluate("--runs", 5).expect(0).says("overall passed (as before)");
    assertEquals(5, before.path("runs").size());
    return json();
  }

  @BeforeAll
  static void readSchema() {
    String text = new Program().run("evaluate", "--schema").expect(0).out();
    schema = JsonSchemaFactory.getInstance(VersionFlag.V202012).getSchema(text);
  }

  /** {@link LiveRunTest} asks each kind of service in each build. */
  static Stream<String> wires() {
    return Thorough.allOrFirst(
        List.of("openai", "openai-compatible", "gemini", "anthropic", "ollama"))
        .stream();
  }

  @InTurn
  @ParameterizedTest
  @MethodSource("wires")
  void answersOfEachKindOfServicePass(String wire) throws IOException {
    try (RecordedService service = service(wire)) {
      connect(wire, service);
      configure(
          "\nprices:\n  ours/authored: {input_per_million: 1000, output_per_million: 2000}\n");
      Program.Ended ended =
          evaluate("--runs", 1, "--models", "ours/authored", "--llm", "live").expect(0);
      ended.says("ours/authored: 1 of 1 run counted; 126 tokens, cost 0.189");
      assertFalse(ended.out().contains("authored by people"));
      assertEquals(1, json().at("/models/0/overall/withoutRepair/passed").asInt());
      assertTrue(json().at("/models/0/measuresALanguageModel").asBoolean());
      assertEquals(Set.of(), schema.validate(json()));
      try (Stream<Path> files = Files.walk(project)) {
        assertTrue(files.filter(Files::isRegularFile).noneMatch(EvaluateTest::holdsTheKey));
      }
    }
  }

  private static boolean holdsTheKey(Path file) {
    try {
      return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).contains(KEY);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @InTurn
  @Test
  void runsAtOnceComeToTheSameAndGoOnWithoutTheService() throws IOException {
    JsonNode first;
    try (RecordedService service = service("openai")) {
      connect("openai", service);
      evaluate("--runs", 2, "--models", "ours/a,ours/b", "--llm", "live", "--parallel", 2)
          .expect(0);
      first = withoutHost(json());
    }
    assertEquals(4, first.path("runs").size());
    Path result = project.resolve("out/evaluation").resolve(first.at("/runs/1/folder").asText());
    Files.delete(result.resolve("result.json"));
    Program.Ended ended =
        evaluate("--runs", 2, "--models", "ours/a,ours/b", "--llm", "live").expect(0);
    assertEquals(3, ended.err().split("as before", -1).length - 1, ended::err);
    assertEquals(first, withoutHost(json()));
  }

  @InTurn
  @Test
  void aKilledEvaluationGoesOn() throws Exception {
    try (RecordedService service = service("gemini")) {
      connect("gemini", service);
      Path out = folder.resolve("out.txt");
      Path err = folder.resolve("err.txt");
      Object[] command = {"evaluate", project, "--runs", 3, "--models", "ours/a", "--llm", "live"};
      Process halted = program().haltedAt("ours/a run 1", out, err, command);
      halted.destroyForcibly().waitFor();
      assertFalse(Files.exists(project.resolve("out/evaluation/evaluation.json")));
      program().run(command).expect(0).says("3 of 3 runs counted").says("(as before)");
      int requests = service.requests();
      assertTrue(
          requests == 21 || requests == 22,
          () -> requests + " questions, not 7 of each run, and the one that was under way");
    }
  }

  /**
   * A source of nonsense answers fails with its own errors, by identifiers that can be looked up.
   */
  @Test
  void nonsenseScoresNothing() throws IOException {
    String source = "command:echo '[{\"name\": \"A\"}]'";
    evaluate("--runs", 2, "--models", "../x,a/<b>", "--llm", source)
        .expect(0)
        .says("design: agents.requirement.unsatisfied 2x")
        .says("nothing to judge")
        .says("[evaluation.reference.missing]");
    assertEquals(Set.of(), schema.validate(json()));
    assertEquals(0, json().at("/models/1/chainModel/withRepair/passed").asInt(-1));
    assertEquals(2, json().at("/models/1/chainModel/withRepair/judged").asInt());
    assertTrue(page().contains("a/&lt;b&gt;") && !page().contains("<b>"));
    assertFalse(page().contains("<script"));
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of(project), files.toList());
    }
    new Program().run("run", project, "--to", "design").expect(0);
    Program.Ended ended = evaluate("--runs", 1, "--models", "a/<b>", "--llm", source).expect(0);
    ended.says("implement: ");
    assertEquals(1, json().at("/models/0/functionCode/withRepair/judged").asInt());
    assertEquals("chain.json of the latest run", json().at("/runs/0/implementedFor").asText());
  }

  @InTurn
  @Test
  void whatCannotBeAskedDoesNotCount() throws IOException {
    RecordedService gone = service("openai");
    gone.close();
    connect("openai", gone);
    Program.Ended ended = evaluate("--runs", 2, "--models", "ours/a,ours/b", "--llm", "live");
    ended.expect(3).says("[llm.service.unreachable]").says("not answered: 1, not begun: 1");
    assertFalse(ended.out().contains("%"), ended::out);
    assertTrue(page().contains("Nothing was counted") && !page().contains("How often"));
    assertEquals(Set.of(), schema.validate(json()));
    evaluate("--models", "ours/a").expect(1).says("[evaluation.nothing.counted]");
    evaluate("--models", "elsewhere/a", "--llm", "live").expect(2).says("[llm.service.unknown]");
  }

  /** A wrong answer is the model's fault; a missing correction is not. */
  @Test
  void whatCannotBeRepairedForWantOfAnAnswerDoesNotCount() throws IOException {
    Path program = folder.resolve("once.sh");
    Path asked = folder.resolve("asked");
    Files.writeString(
        program,
        "cat > /dev/null\ntest -e %s && exit 1\ntouch %s\necho '[]'\n".formatted(asked, asked));
    evaluate("--runs", 1, "--models", "a", "--llm", "command:sh " + program)
        .expect(3)
        .says("[llm.command.failed]")
        .says("0 of 1 run counted (not answered: 1)");
    replaceAnswers("design", "[]");
    evaluate("--runs", 1)
        .expect(1)
        .says("0 of 1 run counted (no recorded answer: 1)")
        .says("[evaluation.nothing.counted]");
  }

  private void replaceAnswers(String task, String text) throws IOException {
    try (Stream<Path> files = Files.list(project.resolve("recordings").resolve(task))) {
      for (Path file : files.toList()) {
        ObjectNode recording = (ObjectNode) MAPPER.readTree(file.toFile());
        ((ObjectNode) recording.at("/samples/0")).putArray("text").add(text);
        MAPPER.writeValue(file.toFile(), recording);
      }
    }
  }

  @InTurn
  @Test
  void aSpentBudgetEndsAllOfIt() throws IOException {
    try (RecordedService service = service("openai")) {
      connect("openai", service);
      configure("\nbudget: {tokens: 140}\n");
      evaluate("--runs", 2, "--models", "ours/a,ours/b", "--llm", "live")
          .expect(3)
          .says("[llm.budget.spent]")
          .says("ours/a: 1 of 2 runs counted (not answered: 1)")
          .says("ours/b: 0 of 2 runs counted (not begun: 2)");
    }
  }

  @Test
  void wrongUsageIsRefused() {
    evaluate("--models", "a,a").expect(2).says("'a' is named twice");
    evaluate("--models", "a,,b").expect(2).says("a model has no name");
    evaluate("--models", "direct").expect(2).says("'direct' is not a language model");
    evaluate("--runs", "0").expect(2).says("the number of runs must be 1 to 99");
    evaluate("--parallel", "0").expect(2).says("at once");
    evaluate("--llm", "groq/x", "--models", "y").expect(2).says("names a model");
    evaluate("--llm", "telepathy").expect(2).says("[llm.provider.unknown]");
    evaluate("--schema").expect(2);
    new Program().run("evaluate").expect(2);
  }

  /** Each folder of answers is a session with a chat, given in the rounds of a hand-off. */
  @Test
  void recordedSessionsBecomeRows() throws IOException {
    Path sessions = folder.resolve("sessions");
    for (String session : List.of("first", "second")) {
      Files.createDirectories(sessions.resolve(session));
      Files.writeString(sessions.resolve(session + "/design-01.answer.md"), recordedDesign());
    }
    Files.writeString(sessions.resolve("second/constrain-07.answer.md"), "nothing");
    evaluate("--llm", "answers:" + sessions)
        .expect(0)
        .says("sessions: 2 of 2 runs counted")
        .says("first/constrain-01.answer.md: warning: The session ended before the run")
        .says("[evaluation.answers.ended]")
        .says("second: warning: Nobody asked for constrain-07.answer.md.")
        .says("[evaluation.answer.unused]");
    assertEquals("answers", json().path("source").asText());
    assertEquals("failed", json().at("/runs/0/overall/withRepair").asText());
    assertEquals(Set.of(), schema.validate(json()));
    evaluate("--llm", "answers:" + folder.resolve("nowhere")).expect(2).says("no such folder");
  }

  @InTurn
  @Test
  void aSessionThatEndsBeforeADiagnosisHasWrittenItsCode() throws IOException {
    Path session = Files.createDirectories(folder.resolve("sessions/one"));
    for (String task : List.of("design", "model", "constrain")) {
      Files.writeString(session.resolve(task + "-01.answer.md"), recorded(task, ""));
    }
    Files.writeString(session.resolve("test-01.answer.md"), recorded("test", "ranges"));
    String right = recorded("implement", "class TTC_Calculation");
    Files.writeString(
        session.resolve("implement-01.answer.md"), right.replace("class TTC_", "class Time_"));
    Files.writeString(session.resolve("implement-02.answer.md"), BRAKES_LATE);
    Files.writeString(session.resolve("implement-03.answer.md"), right);
    Files.createDirectories(project.resolve("tests"));
    Files.writeString(project.resolve("tests/Braking_Decision.yaml"), CRASH);
    evaluate("--llm", "answers:" + session.getParent())
        .expect(0)
        .says("one/diagnose-01.answer.md: warning: The session ended before the run")
        .says("chain model passed, function code passed, overall failed")
        .says("implement: component.class.missing: 1 of 1 right");
    assertEquals(1, json().at("/runs/0/tasks/implement/withoutRepair").asInt());
    assertEquals(2, json().at("/models/0/tasks/implement/withRepair").asInt());
    assertEquals(Set.of(), schema.validate(json()));
    assertTrue(page().contains("<code>implement: component.class.missing</code> 1 of 1"));
  }

  private String recordedDesign() throws IOException {
    return recorded("design", "");
  }

  /** Returns the recorded answer to a task that has some words. */
  private String recorded(String task, String words) throws IOException {
    try (Stream<Path> files = Files.list(project.resolve("recordings").resolve(task))) {
      for (Path file : files.toList()) {
        StringBuilder answer = new StringBuilder();
        MAPPER
            .readTree(file.toFile())
            .at("/samples/0/text")
            .forEach(line -> answer.append(line.asText()).append('\n'));
        if (answer.indexOf(words) >= 0) {
          return answer.toString();
        }
      }
    }
    throw new AssertionError("no recorded " + task + " with " + words);
  }
}
