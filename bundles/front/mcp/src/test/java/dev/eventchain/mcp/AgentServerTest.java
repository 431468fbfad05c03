package dev.eventchain.mcp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the protocol, with a script in the place of the command line. */
class AgentServerTest extends AgentSession {

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
        List.of("constrain", "design", "diagnose", "implement", "model", "test"),
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
  void schemasOfToolsAreStrict() throws Exception {
    JsonNode tools = client.begun().request("tools/list", Map.of()).at("/result/tools");
    assertEquals(16, tools.size());
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
