package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.RequirementTools;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the server for coding agents as agents start it. */
class McpTest {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final Path PYTHON = Path.of("tests/end-to-end/src/test/python");
  private static final String COMPONENT = "software-base/components/Brake_Request.py";
  private static final String RIGHT = "FULL_BRAKE_TTC = 1.6";
  private static final String FAULT = "FULL_BRAKE_TTC = 0.4";

  @TempDir private static Path folder;

  /** A session, whose lines are read as JSON: anything else on standard output fails. */
  private static final class Session implements AutoCloseable {

    private final Process process;
    private final BufferedReader out;
    private final OutputStream in;

    Session() throws IOException {
      process =
          new ProcessBuilder("bash", script().toString(), "mcp", folder.toString())
              .redirectError(folder.resolve("err").toFile())
              .start();
      out = process.inputReader(StandardCharsets.UTF_8);
      in = process.getOutputStream();
      send(
          """
          {"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": {"protocolVersion": "2025-11-25",\
           "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}}""");
      assertEquals("eventchain", next().at("/result/serverInfo/name").asText());
      send("{\"jsonrpc\": \"2.0\", \"method\": \"notifications/initialized\"}");
    }

    void send(String line) throws IOException {
      in.write((line + "\n").getBytes(StandardCharsets.UTF_8));
      in.flush();
    }

    void call(int id, String tool, String arguments) throws IOException {
      send(
          String.format(
              Locale.ROOT,
              """
          {"jsonrpc": "2.0", "id": %d, "method": "tools/call", "params": {"name": "%s", "arguments": %s,\
           "_meta": {"progressToken": %d}}}""",
              id,
              tool,
              arguments,
              id));
    }

    JsonNode next() throws IOException {
      String line = out.readLine();
      assertTrue(line != null, "the session has ended: " + Files.readString(folder.resolve("err")));
      return JSON.readTree(line);
    }

    /** Returns the answer to a request, after messages about its progress. */
    JsonNode answer(int id) throws IOException {
      JsonNode message = next();
      while (!message.has("id")) {
        message = next();
      }
      assertEquals(id, message.path("id").asInt(), message.toString());
      return message.path("result");
    }

    /** Waits until a run says that it does something; fails if it ends before. */
    void awaitProgress(String text) throws IOException {
      JsonNode message = next();
      while (!message.at("/params/message").asText().contains(text)) {
        assertFalse(message.has("id"), message.toString());
        message = next();
      }
    }

    /** Ends the input; fails if a process goes on. */
    @Override
    public void close() throws IOException {
      List<ProcessHandle> started = process.descendants().toList();
      in.close();
      awaitEnd(List.of(process.toHandle()));
      assertEquals(0, process.exitValue(), Files.readString(folder.resolve("err")));
      awaitEnd(started);
    }
  }

  private static void awaitEnd(List<ProcessHandle> processes) {
    processes.forEach(each -> each.onExit().orTimeout(60, TimeUnit.SECONDS).join());
  }

  private static Path script() throws IOException {
    return Files.writeString(folder.resolve("eventchain.sh"), new Program().script());
  }

  private static Path faulty(String name) throws IOException {
    Path project = Program.copyOf("radar-aeb", Files.createDirectories(folder.resolve(name)));
    Path file = project.resolve(COMPONENT);
    Files.writeString(file, Files.readString(file).replace(RIGHT, FAULT));
    return project;
  }

  @Test
  void sameAsTheCommandLine() throws Exception {
    Path project = faulty("same");
    Path chain = project.resolve("model/chain.xmi");
    Files.writeString(chain, Files.readString(chain).replace("\"Brake_Request\"", "\"class\""));
    try (Session session = new Session()) {
      session.call(1, "validate", "{\"project\": \"same/radar-aeb\"}");
      JsonNode said = session.answer(1);
      String expected = new Program().run("validate", project, "--format", "json").expect(1).out();
      assertEquals(
          JSON.readTree(expected.replace(folder + "/", "")), said.at("/structuredContent/report"));
      session.call(2, "suites", "{}");
      JsonNode suites = session.answer(2);
      String listed = new Program().run("suites", "--format=json").expect(0).out();
      assertEquals(JSON.readTree(listed).path("suites"), suites.at("/structuredContent/suites"));
      assertEquals(listed, suites.at("/content/0/text").asText());
      String text = new Program().run("validate", project).expect(1).out();
      assertTrue(
          said.at("/content/0/text").asText().endsWith(text.replace(folder + "/", "")),
          said.toString());
    }
  }

  /** A project would be as good as its author's: with findings suppressed and texts accepted. */
  @Test
  void aTemplateMakesNoProject() throws Exception {
    Path template = Files.createDirectories(folder.resolve("made")).resolve("t.mtl");
    Files.writeString(
        template,
        """
        [module t('http://www.eclipse.org/emf/2002/Ecore')]
        [template public t(p : EPackage)]
        [comment @main/]
        [file ('new/eventchain.yaml', false)]name: new[/file]
        [file ('new/accepted.yaml', false)][/file]
        [/template]
        """);
    Path model = Files.copy(Path.of("metamodel/eventchain.ecore"), folder.resolve("made/m.ecore"));
    String arguments =
        JSON.writeValueAsString(
            Map.of(
                "template", folder.relativize(template).toString(),
                "models", List.of(folder.relativize(model).toString()),
                "output", "made/text"));
    try (Session session = new Session()) {
      session.call(1, "generate", arguments);
      JsonNode said = session.answer(1);
      assertEquals(1, said.at("/structuredContent/exitCode").asInt(), said.toString());
      assertEquals(
          List.of("output.path.refused", "output.path.refused"),
          said.at("/structuredContent/report/findings").findValuesAsText("id"));
    }
    assertFalse(Files.exists(folder.resolve("made/text/new")));
  }

  @Test
  void aCancelledRunLeavesNoProcess() throws Exception {
    faulty("cancelled");
    try (Session session = new Session()) {
      session.call(1, "run", "{\"project\": \"cancelled/radar-aeb\"}");
      session.awaitProgress("Implement");
      List<ProcessHandle> started = session.process.descendants().toList();
      assertFalse(started.isEmpty());
      session.send(
          "{\"jsonrpc\": \"2.0\", \"method\": \"notifications/cancelled\", \"params\": {\"requestId\": 1}}");
      awaitEnd(started);
      session.send("{\"jsonrpc\": \"2.0\", \"id\": 2, \"method\": \"ping\"}");
      session.answer(2);
    }
  }

  @Test
  @InTurn
  void theEndOfInputEndsASimulation() throws Exception {
    faulty("ended");
    try (Session session = new Session()) {
      session.call(1, "run", "{\"project\": \"ended/radar-aeb\"}");
      session.awaitProgress("Simulate");
    }
  }

  @Test
  @InTurn
  void theOfficialClientMendsAProject() throws Exception {
    mend("auto");
  }

  @Test
  @InTurn
  void theOfficialClientMendsAProjectInTheOlderWay() throws Exception {
    mend("legacy");
  }

  private static void mend(String mode) throws Exception {
    RequirementTools client = RequirementTools.install(PYTHON.resolve("requirements-mcp.txt"));
    faulty(mode);
    RequirementTools.Ended ended =
        client.run(
            folder,
            "python",
            PYTHON.resolve("mend.py").toAbsolutePath(),
            mode,
            mode + "/radar-aeb",
            COMPONENT,
            FAULT,
            RIGHT,
            "bash",
            script(),
            "mcp",
            folder);
    assertEquals(
        """
        protocol 2025-11-25
        tools 15 prompts 6
        verdict FAILED progress True
        failed short-sight no impact
        signals True
        reads True
        proposed PASSED judges []
        applied ['software-base/components/Brake_Request.py']
        changed ['software-base/components/Brake_Request.py']
        verdict PASSED exit 0
        """,
        ended.output());
    assertEquals(0, ended.code());
  }
}
