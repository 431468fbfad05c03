package dev.eventchain.mcp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the protocol, with a script in the place of the command line. */
class AgentServerTest {

  private static final Path RESOURCES = Path.of("src/test/resources/dev/eventchain/mcp");
  private static final Path SCRIPT = RESOURCES.resolve("program.sh");

  @TempDir private Path folder;

  private Client client;

  @BeforeEach
  void start() throws Exception {
    Files.createDirectories(folder.resolve("p"));
    Files.writeString(folder.resolve("p/eventchain.yaml"), "name: p\n");
    Files.writeString(folder.resolve("p/requirements.md"), "# One\n");
    client = new Client(folder, SCRIPT);
  }

  @AfterEach
  void end() throws Exception {
    client.end();
  }

  @ParameterizedTest
  @CsvSource({
    "2024-11-05, 2024-11-05",
    "2025-11-25, 2025-11-25",
    "2026-07-28, 2025-11-25",
    "nonsense, 2025-11-25"
  })
  void aVersionThatIsNotKnownGetsTheNewest(String asked, String answered) throws Exception {
    assertEquals(answered, client.begin(asked).at("/result/protocolVersion").asText());
  }

  @Test
  void aMethodThatIsNotKnownIsAnErrorAlsoBeforeTheBeginning() throws Exception {
    assertEquals(-32601, client.request("server/discover", Map.of()).at("/error/code").asInt());
    assertEquals(-32600, client.request("tools/list", Map.of()).at("/error/code").asInt());
  }

  @ParameterizedTest
  @ValueSource(strings = {"not json", "{\"jsonrpc\":\"2.0\"", "{} {}", "\u0001", "{\"a\":1,}"})
  void aLineThatIsNoJsonGetsAnErrorAndTheSessionGoesOn(String line) throws Exception {
    client.begun().line(line);
    JsonNode answer = client.next();
    assertEquals(-32700, answer.at("/error/code").asInt(), answer.toString());
    assertTrue(answer.has("id") && answer.get("id").isNull());
    assertTrue(client.request("ping", Map.of()).has("result"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"[]", "7", "null", "{}", "{\"jsonrpc\":\"1.0\",\"id\":3,\"method\":\"ping\"}"})
  void whatIsNoMessageGetsAnError(String line) throws Exception {
    client.begun().line(line);
    assertEquals(-32600, client.next().at("/error/code").asInt());
    assertTrue(client.request("ping", Map.of()).has("result"));
  }

  @Test
  void blankLinesAreNoMessages() throws Exception {
    client.begun().line("");
    client.line(" \t\r");
    assertTrue(client.request("ping", Map.of()).has("result"));
  }

  @Test
  void bytesThatAreNoTextGetAnError() throws Exception {
    client.begun().bytes(new byte[] {'"', (byte) 0xff, (byte) 0xfe, '"', '\n'});
    assertEquals(-32700, client.next().at("/error/code").asInt());
  }

  @Test
  void aLineThatIsTooLongIsRefused() throws Exception {
    byte[] line = new byte[(4 << 20) + 2];
    Arrays.fill(line, (byte) '1');
    line[line.length - 1] = '\n';
    client.begun().bytes(line);
    assertEquals(-32600, client.next().at("/error/code").asInt());
    assertTrue(client.request("ping", Map.of()).has("result"));
  }

  @Test
  void aCommandsReportIsTheStructureAndItsTextTheText() throws Exception {
    JsonNode result = client.begun().call("validate", Map.of("project", "p"));
    assertEquals(
        "done\nPASSED: validate p\n", result.at("/content/0/text").asText(), result.toString());
    assertEquals(0, result.at("/structuredContent/report/exitCode").asInt());
    assertFalse(result.path("isError").asBoolean());
    assertTrue(result.at("/_meta").toString().contains("no instructions"), result.toString());
  }

  @Test
  void eachMessageOfACommandIsProgress() throws Exception {
    int id =
        client
            .begun()
            .send(
                "tools/call",
                Map.of(
                    "name", "run",
                    "arguments", Map.of("project", "p"),
                    "_meta", Map.of("progressToken", "t")));
    List<JsonNode> before = new ArrayList<>();
    client.answer(id, before);
    List<String> said = before.stream().map(each -> each.at("/params/message").asText()).toList();
    // What comes at once is one message.
    assertEquals("done", said.get(said.size() - 1));
    assertTrue(
        List.of("Simulate  one", "Simulate  two", "done").containsAll(said), said.toString());
    for (int i = 0; i < before.size(); i++) {
      assertEquals("t", before.get(i).at("/params/progressToken").asText());
      assertEquals(i + 1, before.get(i).at("/params/progress").asInt());
    }
  }

  @Test
  void aCancelledCallEndsItsProcessesAndGetsNoAnswer() throws Exception {
    int id = client.begun().send("tools/call", Map.of("name", "mutate", "arguments", project()));
    long sleeper = awaitSleeper();
    client.line(
        "{\"jsonrpc\":\"2.0\",\"method\":\"notifications/cancelled\",\"params\":{\"requestId\":"
            + id
            + "}}");
    while (runs(sleeper)) {
      Thread.sleep(5);
    }
    List<JsonNode> before = new ArrayList<>();
    client.answer(client.send("ping", Map.of()), before);
    assertEquals(List.of(), before);
    // What is not there cannot be cancelled, and nobody is told so.
    client.line("{\"jsonrpc\":\"2.0\",\"method\":\"notifications/cancelled\"}");
    assertEquals("PASSED: validate p\n", lastLine(client.text("validate", project())));
  }

  private static String lastLine(String text) {
    return text.substring(text.indexOf('\n') + 1);
  }

  @Test
  void theEndOfInputEndsARunningCall() throws Exception {
    client.begun().send("tools/call", Map.of("name", "mutate", "arguments", project()));
    long sleeper = awaitSleeper();
    client.end();
    assertFalse(runs(sleeper));
  }

  /** Returns the process that a command has started; its id is in a file. */
  private long awaitSleeper() throws Exception {
    Path file = folder.resolve("sleeper");
    while (!Files.exists(file) || Files.readString(file).isBlank()) {
      Thread.sleep(5);
    }
    return Long.parseLong(Files.readString(file).strip());
  }

  /** Returns whether a process is there and not only waiting to be noticed by its parent. */
  private static boolean runs(long process) throws IOException {
    Path status = Path.of("/proc", Long.toString(process), "status");
    return Files.exists(status) && !Files.readString(status).contains("State:\tZ");
  }

  private static Map<String, Object> project() {
    return Map.of("project", "p");
  }

  @Test
  void aCallThatTakesLongDoesNotStopOthers() throws Exception {
    client.begun().send("tools/call", Map.of("name", "mutate", "arguments", project()));
    awaitSleeper();
    assertFalse(client.call("validate", project()).path("isError").asBoolean());
  }

  @Test
  void callsThatAreTooManyAreRefused() throws Exception {
    client.begun();
    for (int i = 0; i < 4; i++) {
      client.send("tools/call", Map.of("name", "mutate", "arguments", project()));
      awaitSleeper();
      Files.delete(folder.resolve("sleeper"));
    }
    String text = client.text("validate", project());
    assertTrue(text.contains("[mcp.busy]"), text);
  }

  @Test
  void onlyCommandsThatJudgeHaveAVerdict() throws Exception {
    client.begun();
    assertFalse(client.call("validate", project()).path("structuredContent").has("verdict"));
    assertEquals("PASSED", client.call("run", project()).at("/structuredContent/verdict").asText());
    Map<String, Object> chosen = Map.of("project", "p", "scenarios", List.of("failing"));
    JsonNode failed = client.call("run", chosen).path("structuredContent");
    assertEquals(1, failed.path("exitCode").asInt());
    assertFalse(failed.has("verdict"), "the exit code contradicts what is printed");
  }

  @ParameterizedTest
  @CsvSource({
    "un-r152, PASSED: search p p/c.yaml --only=un-r152",
    "@x, PASSED: search p p/c.yaml --only=@x"
  })
  void aSearchIsACommand(String only, String said) throws Exception {
    String text =
        client.begun().text("search", Map.of("project", "p", "file", "p/c.yaml", "only", only));
    assertTrue(text.contains(said), text);
  }

  @Test
  void aSuiteIsAName() throws Exception {
    client.begun();
    Files.createSymbolicLink(folder.resolve("un-r152"), Path.of("/etc"));
    for (String outside : List.of("/etc/passwd", "../x.yaml", "un-r152")) {
      String text = client.text("simulate", Map.of("project", "p", "suite", outside));
      assertTrue(text.contains("[mcp.outside]"), text);
    }
    String text = client.text("simulate", Map.of("project", "p", "suite", "un-r157-alks"));
    assertFalse(text.contains("[mcp."), text);
    Map<String, Object> wrong = Map.of("project", "p", "driver", "ros2");
    assertTrue(client.text("simulate", wrong).contains("[mcp.argument]"));
  }

  @Test
  void aCommandThatSaysNothingIsNoSuccess() throws Exception {
    JsonNode result = client.begun().call("simulate", project());
    assertTrue(result.path("isError").asBoolean());
  }

  @Test
  void findingsThatAreTooManyAreCounted() throws Exception {
    JsonNode result = client.begun().call("campaign", Map.of("project", "p", "file", "p/c.yaml"));
    assertEquals(50, result.at("/structuredContent/leftOut").asInt());
    assertEquals(200, result.at("/structuredContent/report/findings").size());
  }

  @Test
  void whatIsReadOutsideIsNotSaid() throws Exception {
    JsonNode result = client.begun().call("generate", project());
    assertTrue(result.toString().contains("[mcp.outside]"), result.toString());
    assertFalse(result.toString().contains("root:x"), result.toString());
  }

  @ParameterizedTest
  @CsvSource({
    "validate, projct, p, mcp.argument",
    "validate, project, ../p, mcp.outside",
    "validate, project, /etc, mcp.outside",
    "validate, project, p/../.., mcp.outside",
    "campaign, project, p, mcp.argument",
    "results, project, p, mcp.results",
    "apply, proposal, 0, mcp.change"
  })
  void aCallThatCannotBeAnsweredSaysWhy(String tool, String name, String value, String rule)
      throws Exception {
    JsonNode result = client.begun().call(tool, Map.of(name, value));
    assertTrue(result.path("isError").asBoolean());
    assertTrue(result.toString().contains("[" + rule + "]"), result.toString());
  }

  @Test
  void noLinkLeadsOut() throws Exception {
    Files.createSymbolicLink(folder.resolve("link"), Path.of("/etc"));
    Files.createSymbolicLink(folder.resolve("p/link"), Path.of("/etc/passwd"));
    client.begun();
    for (String path : List.of("p", "link", "link/x")) {
      String text = client.text("validate", Map.of("project", path));
      assertTrue(text.contains("[mcp.outside]"), text);
    }
    assertTrue(read("eventchain://files/p/link").has("error"));
    assertTrue(read("eventchain://files/link/passwd").has("error"));
  }

  private JsonNode read(String uri) throws Exception {
    return client.request("resources/read", Map.of("uri", uri));
  }

  @Test
  void filesAndPagesAreResources() throws Exception {
    client.begun();
    assertEquals(
        "# One\n",
        read("eventchain://files/p/requirements.md").at("/result/contents/0/text").asText());
    String page = read("eventchain://rules/mcp.outside").at("/result/contents/0/text").asText();
    assertTrue(page.startsWith("# mcp.outside"), page);
    String list = read("eventchain://files").at("/result/contents/0/text").asText();
    assertTrue(list.contains("\"p/requirements.md\""), list);
    assertTrue(
        read("eventchain://rules").at("/result/contents/0/text").asText().contains("mcp.file"));
    String schema = read("eventchain://formats/bench").at("/result/contents/0/text").asText();
    assertEquals("bench --schema\n", schema);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "eventchain://files/p/.hidden",
        "eventchain://files/nothing",
        "eventchain://files/p/large",
        "eventchain://files/p/binary",
        "eventchain://files/%zz",
        "eventchain://rules/nothing",
        "file:///etc/passwd"
      })
  void whatCannotBeReadIsAnError(String uri) throws Exception {
    Files.writeString(folder.resolve("p/.hidden"), "x");
    Files.write(folder.resolve("p/large"), new byte[(1 << 20) + 1]);
    Files.write(folder.resolve("p/binary"), new byte[] {(byte) 0xff});
    assertTrue(client.begun().request("resources/read", Map.of("uri", uri)).has("error"));
  }

  @Test
  void eachTaskHasAPrompt() throws Exception {
    JsonNode prompts = client.begun().request("prompts/list", Map.of()).at("/result/prompts");
    List<String> names = new ArrayList<>();
    prompts.forEach(prompt -> names.add(prompt.path("name").asText()));
    assertEquals(
        List.of("constrain", "design", "implement", "model", "test"),
        names.stream().sorted().toList());
    for (String name : names) {
      String text =
          client
              .request(
                  "prompts/get",
                  Map.of("name", name, "arguments", Map.of("project", "here", "component", "C")))
              .at("/result/messages/0/content/text")
              .asText();
      assertTrue(text.contains("`here`") && !text.contains("{"), text);
    }
  }

  @Test
  void resultsAreAsTheSchemasSay() throws Exception {
    Files.createDirectories(folder.resolve("p/out/curves"));
    Files.copy(RESOURCES.resolve("verdict.json"), folder.resolve("p/out/verdict.json"));
    Files.copy(RESOURCES.resolve("curves.csv"), folder.resolve("p/out/curves/s.csv"));
    Map<String, JsonNode> schemas = new TreeMap<>();
    client
        .begun()
        .request("tools/list", Map.of())
        .at("/result/tools")
        .forEach(tool -> schemas.put(tool.path("name").asText(), tool.path("outputSchema")));
    Map<String, Map<String, Object>> calls =
        Map.of(
            "validate", project(),
            "init", project(),
            "explain", Map.of(),
            "results", project(),
            "query", Map.of("project", "p", "table", "criteria"),
            "signals", Map.of("project", "p", "scenario", "s", "time", 1),
            "propose", Map.of("project", "p", "edits", edits("requirements.md", "One", "Two")));
    for (Map.Entry<String, Map<String, Object>> call : calls.entrySet()) {
      JsonNode result = client.call(call.getKey(), call.getValue());
      assertFalse(result.path("isError").asBoolean(), result.toString());
      JsonNode schema = schemas.get(call.getKey());
      assertEquals(
          List.of(),
          List.copyOf(
              JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
                  .getSchema(schema)
                  .validate(result.path("structuredContent"))),
          call.getKey());
      for (String name : required(result)) {
        assertTrue(schema.path("properties").has(name), call.getKey() + " " + name);
      }
    }
  }

  private static List<String> required(JsonNode result) {
    List<String> names = new ArrayList<>();
    result.path("structuredContent").fieldNames().forEachRemaining(names::add);
    return names;
  }

  private static List<Map<String, String>> edits(String file, String old, String text) {
    return List.of(Map.of("file", file, "old", old, "new", text));
  }

  @Test
  void tablesAreReadByThePage() throws Exception {
    Files.createDirectories(folder.resolve("p/out/curves"));
    Files.copy(RESOURCES.resolve("verdict.json"), folder.resolve("p/out/verdict.json"));
    Files.copy(RESOURCES.resolve("curves.csv"), folder.resolve("p/out/curves/s.csv"));
    client.begun();
    JsonNode failed =
        query(
            "criteria",
            Map.of(
                "where",
                List.of(Map.of("column", "passed", "equals", false)),
                "columns",
                List.of("text")));
    assertEquals("[{\"text\":\"it stops\"}]", failed.path("rows").toString());
    JsonNode first =
        query("criteria", Map.of("orderBy", "margin.value", "descending", true, "limit", 1));
    assertEquals("no impact", first.at("/rows/0/text").asText());
    assertEquals(1, first.path("next").asInt());
    JsonNode fast =
        query("curves/s", Map.of("where", List.of(Map.of("column", "speed [m/s]", "least", 9.5))));
    assertEquals(2, fast.path("total").asInt());
    JsonNode around =
        client
            .call("signals", Map.of("project", "p", "scenario", "s", "time", 1.0, "around", 0.1))
            .path("structuredContent");
    assertEquals(
        "[{\"time [s]\":1,\"gap [m]\":5.5,\"speed, \\\"true\\\"\":10}]",
        around.path("rows").toString().replace("\"speed [m/s]\":9,", ""));
  }

  private JsonNode query(String table, Map<String, Object> more) throws Exception {
    Map<String, Object> arguments = new TreeMap<>(more);
    arguments.putAll(Map.of("project", "p", "table", table));
    return client.call("query", arguments).path("structuredContent");
  }

  @Test
  void resultsOfAnOlderProjectSaySo() throws Exception {
    Files.createDirectories(folder.resolve("p/out"));
    Files.copy(RESOURCES.resolve("verdict.json"), folder.resolve("p/out/verdict.json"));
    assertEquals(
        "[]",
        client.begun().call("results", project()).at("/structuredContent/changedSince").toString());
    Path file = folder.resolve("p/requirements.md");
    Files.setLastModifiedTime(
        file,
        java.nio.file.attribute.FileTime.fromMillis(
            Files.getLastModifiedTime(file).toMillis() + 60_000));
    String text = client.text("results", project());
    assertTrue(text.startsWith("Changed after these results: requirements.md"), text);
  }

  @Test
  void aProposalIsCheckedOnACopyAndMadeByItsName() throws Exception {
    JsonNode proposed =
        client
            .begun()
            .call(
                "propose", Map.of("project", "p", "edits", edits("requirements.md", "One", "Two")))
            .path("structuredContent");
    String diff =
        """
        --- a/requirements.md
        +++ b/requirements.md
        @@ -1,1 +1,1 @@
        -# One
        +# Two
        """;
    assertEquals(diff, proposed.path("diff").asText());
    assertEquals("[\"requirements.md\"]", proposed.path("judges").toString());
    assertEquals("# One\n", Files.readString(folder.resolve("p/requirements.md")));
    Map<String, Object> name = Map.of("proposal", proposed.path("proposal").asText());
    assertEquals("Changed: requirements.md", client.text("apply", name));
    assertEquals("# Two\n", Files.readString(folder.resolve("p/requirements.md")));
    assertTrue(client.text("apply", name).contains("[mcp.change]"));
  }

  @Test
  void aProposalAboutFilesThatHaveChangedIsNotMade() throws Exception {
    JsonNode proposed =
        client.begun().call("propose", Map.of("project", "p", "edits", edits("new.md", "", "Two")));
    Files.writeString(folder.resolve("p/new.md"), "by somebody else");
    String id = proposed.at("/structuredContent/proposal").asText();
    assertTrue(client.text("apply", Map.of("proposal", id)).contains("[mcp.change]"));
    assertEquals("by somebody else", Files.readString(folder.resolve("p/new.md")));
  }

  @Test
  void proposalsThatDifferHaveDifferentNames() throws Exception {
    Files.createDirectories(folder.resolve("q"));
    Files.writeString(folder.resolve("q/eventchain.yaml"), "name: q\n");
    client.begun();
    JsonNode whole = proposed("p", "x.md", "Two\n");
    JsonNode open = proposed("p", "x.md", "Two");
    JsonNode windows = proposed("p", "x.md", "Two\r\n");
    JsonNode empty = proposed("p", "x.md", "");
    JsonNode other = proposed("q", "x.md", "Two\n");
    String head = "--- /dev/null\n+++ b/x.md\n";
    assertEquals(head + "@@ -0,0 +1,1 @@\n+Two\n", whole.path("diff").asText());
    assertEquals(
        head + "@@ -0,0 +1,1 @@\n+Two\n\\ No newline at end of file\n", open.path("diff").asText());
    assertEquals(head + "@@ -0,0 +1,1 @@\n+Two␍\n", windows.path("diff").asText());
    assertEquals(head + "\\ New empty file\n", empty.path("diff").asText());
    assertEquals(
        5,
        Stream.of(whole, open, windows, empty, other)
            .map(each -> each.path("proposal").asText())
            .distinct()
            .count());
    assertTrue(whole.path("checked").asBoolean());
    client.text("apply", Map.of("proposal", whole.path("proposal").asText()));
    assertEquals("Two\n", Files.readString(folder.resolve("p/x.md")));
    assertFalse(Files.exists(folder.resolve("q/x.md")));
  }

  private JsonNode proposed(String project, String file, String text) throws Exception {
    return client
        .call("propose", Map.of("project", project, "edits", edits(file, "", text)))
        .path("structuredContent");
  }

  @Test
  void aProposalWhoseCheckCouldNotBeDoneIsMadeAsUnchecked() throws Exception {
    Files.createDirectories(folder.resolve("unreadable"));
    Files.writeString(folder.resolve("unreadable/eventchain.yaml"), "name: p\n");
    client.begun();
    JsonNode proposed = proposed("unreadable", "x.md", "Two\n");
    assertFalse(proposed.path("checked").asBoolean(true));
    JsonNode applied = client.call("apply", Map.of("proposal", proposed.path("proposal").asText()));
    assertFalse(applied.at("/structuredContent/checked").asBoolean(true));
    assertTrue(applied.at("/content/0/text").asText().contains("Unchecked"), applied.toString());
  }

  @ParameterizedTest
  @CsvSource({
    "eventchain.yaml, name, mcp.protected",
    "eventchain-suppressions.yaml, '', mcp.protected",
    "mutants.yaml, '', mcp.protected",
    "accepted.yaml, '', mcp.protected",
    "out/verdict.json, '', mcp.protected",
    ".git/config, '', mcp.protected",
    "recordings/x.json, '', mcp.protected",
    "../q/x.md, '', mcp.protected",
    "../../x.md, '', mcp.outside",
    "/etc/passwd, '', mcp.outside",
    "requirements.md, Three, mcp.change",
    "requirements.md, One, mcp.change"
  })
  void whatMayNotOrCannotBeChangedIsRefused(String file, String old, String rule) throws Exception {
    String text =
        client.begun().text("propose", Map.of("project", "p", "edits", edits(file, old, old)));
    assertTrue(text.contains("[" + rule + "]"), text);
  }

  @ParameterizedTest
  @CsvSource({
    "., p/eventchain-suppressions.yaml",
    "., p/accepted.yaml",
    "., p/out/verdict.json",
    "p/recordings, x.json",
    "p/out, verdict.json",
    "p/scenarios, x.yaml",
    "p, scenarios/eventchain.yaml",
    "p, q/requirements.md",
    "p, behind/x.md",
    ".hidden, x.md"
  })
  void noNameOfTheProjectMakesAFileChangeable(String project, String file) throws Exception {
    for (String name : List.of("p/recordings", "p/scenarios", "p/q", ".hidden")) {
      Files.createDirectories(folder.resolve(name));
    }
    Files.writeString(folder.resolve("p/q/eventchain.yaml"), "name: q\n");
    Files.createSymbolicLink(folder.resolve("p/behind"), Path.of("recordings"));
    String text =
        client.begun().text("propose", Map.of("project", project, "edits", edits(file, "", "x")));
    assertTrue(text.contains("[mcp.protected]"), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"p", "p/out", "p/scenarios", ".", ".vscode", "new/.git", "above", "link"})
  void aTemplateWritesIntoNoProject(String output) throws Exception {
    Files.createDirectories(folder.resolve("above/q"));
    Files.writeString(folder.resolve("above/q/eventchain.yaml"), "name: q\n");
    Files.createSymbolicLink(folder.resolve("link"), Path.of("p"));
    String text = client.begun().text("generate", template(output));
    assertTrue(text.contains("[mcp.protected]"), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"p/out/text", "new/text"})
  void aTemplateWritesIntoAFolderOfItsOwn(String output) throws Exception {
    String text = client.begun().text("generate", template(output));
    assertFalse(text.contains("[mcp.protected]"), text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "out",
        "recordings",
        "accepted.yaml",
        "mutants.yaml",
        "eventchain-suppressions.yaml"
      })
  void noProjectStartsAroundWhatWouldDecideAboutIt(String name) throws Exception {
    client.begun();
    Files.createDirectories(folder.resolve("new"));
    assertFalse(client.text("init", Map.of("project", "new")).contains("[mcp.protected]"));
    Files.writeString(folder.resolve("new/" + name), "");
    assertTrue(client.text("init", Map.of("project", "new")).contains("[mcp.protected]"));
  }

  private static Map<String, Object> template(String output) {
    return Map.of("template", "t.mtl", "models", List.of("m.xmi"), "output", output);
  }

  @ParameterizedTest
  @ValueSource(strings = {".git", "p/scenarios", "p/out"})
  void noProjectStartsInAnother(String project) throws Exception {
    String text = client.begun().text("init", Map.of("project", project));
    assertTrue(text.contains("[mcp.protected]"), text);
  }

  @Test
  void schemasOfToolsAreStrict() throws Exception {
    JsonNode tools = client.begun().request("tools/list", Map.of()).at("/result/tools");
    assertEquals(14, tools.size());
    for (JsonNode tool : tools) {
      assertFalse(tool.at("/inputSchema/additionalProperties").asBoolean(true));
      assertTrue(tool.has("outputSchema") && tool.has("annotations"), tool.toString());
      for (String word : List.of("suppress", "overwrite", "llm", "timeLimit", "date")) {
        assertFalse(tool.at("/inputSchema/properties").has(word), word);
      }
    }
    assertTrue(
        new ObjectMapper().writeValueAsBytes(tools).length < 20_000,
        "an agent carries all of it through its whole session");
  }
}
