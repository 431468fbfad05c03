package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.google.gson.JsonObject;
import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.Position;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The server for editors as a process: it finds what the command line finds. */
class LanguageServerTest {

  private static final long PATIENCE = TimeUnit.SECONDS.toNanos(120);

  /** Changes of the small radar example: file, text that occurs once, and what replaces it. */
  private static final String[][] FAULTS = {
    {"model/chain.xmi", "nextstep=\"//@software.1\"", "nextstep=\"//@software.7\""},
    {"model/chain.xmi", "id=\"RAD-4\"", "id=\"RAD-5\""},
    {"software-base/msg/demo_msgs/msg/Threat.msg", "float32 closing_speed", "flot32 closing_speed"},
    {"requirements.md", "- RAD-2", "- RAD-1"},
    {"eventchain.yaml", "name: radar_aeb", "name: Radar"},
  };

  private static final Pattern WORD = Pattern.compile("<?(?=[:./@-]*\\w)[\\w:./@-]*[\\w@]");

  @TempDir private Path folder;

  /** A process of the server, and the editor at its other end. */
  private record Session(Process process, EditorClient client) implements AutoCloseable {

    static Session of(Path... folders) throws IOException {
      Process process = new Program().startWithPipes("lsp");
      EditorClient client =
          new EditorClient(
              process.getInputStream(), process.getOutputStream(), new InitializeParams(), folders);
      return new Session(process, client);
    }

    /** Waits until the editor shows what a command has found. */
    void shows(List<String> expected) throws InterruptedException {
      long end = System.nanoTime() + PATIENCE;
      while (!found().equals(expected) && System.nanoTime() < end) {
        Thread.sleep(20);
      }
      assertEquals(String.join("\n", expected), String.join("\n", found()));
    }

    private List<String> found() {
      List<String> found = new ArrayList<>();
      client
          .all()
          .forEach(
              (uri, each) -> each.forEach(it -> found.add(line(Path.of(URI.create(uri)), it))));
      return found.stream().sorted().toList();
    }

    @Override
    public void close() {
      process.destroyForcibly();
    }
  }

  @Test
  void aFaultOfTheSmallExampleIsFoundAsOnTheCommandLine() throws Exception {
    findsAsTheCommandLine(FAULTS[0]);
  }

  @InTurn
  @Test
  void otherFaultsAreFoundAsOnTheCommandLine() throws Exception {
    findsAsTheCommandLine(Arrays.copyOfRange(FAULTS, 1, FAULTS.length));
  }

  private void findsAsTheCommandLine(String[]... faults) throws Exception {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    List<String> sound = validated(copy.path());
    try (Session session = Session.of(copy.path())) {
      for (String[] fault : faults) {
        Path file = copy.path().resolve(fault[0]);
        String text = Files.readString(file);
        copy.replace(fault[0], fault[1], fault[2]);
        String faulty = Files.readString(file);
        List<String> expected = validated(copy.path());
        assertFalse(expected.equals(sound), fault[2]);
        Files.writeString(file, text);
        session.client().open(file, text);
        session.client().change(file, null, faulty);
        session.shows(expected);
        session.client().close(file);
        session.shows(sound);
      }
      session.client().exit();
      assertTrue(session.process().waitFor(1, TimeUnit.MINUTES));
      assertEquals(0, session.process().exitValue());
    }
  }

  /** The process must not outlive its editor: not even for the minute that idle threads live. */
  @Test
  void itEndsAtOnceWhenTheEditorIsGone() throws Exception {
    try (Session session = Session.of(folder)) {
      long start = System.nanoTime();
      session.client().leave();
      assertTrue(session.process().waitFor(1, TimeUnit.MINUTES));
      assertTrue(System.nanoTime() - start < TimeUnit.SECONDS.toNanos(30));
    }
  }

  @InTurn
  @Test
  void theExamplesAreFoundAsOnTheCommandLine() throws Exception {
    for (String example : List.of("aeb", "acc", "lane-departure", "cut-in")) {
      Path copy = Program.copyOf(example, folder.resolve(example));
      if (!Files.exists(copy.resolve("model"))) {
        new Program().run("run", copy, "--to", "constrain").expect(0);
      }
      List<String> expected = validated(copy);
      try (Session session = Session.of(copy)) {
        session.client().open(copy.resolve("eventchain.yaml"));
        session.shows(expected);
      }
    }
  }

  @InTurn
  @Test
  void ourTemplatesAreFoundAsOnTheCommandLine() throws Exception {
    Path templates = folder.resolve("templates");
    FinishedRun.copy(Program.ROOT.resolve("templates"), templates);
    Files.writeString(
        templates.resolve("broken.mtl"),
        """
        [module broken('http://eventchain.dev/eventchain/1.0')/]
        [template public t(c : EventChain)]
        [c.nam/]
        [/template]
        """);
    List<String> expected =
        lines(new Program().run("compile", templates, "--format", "json").out());
    assertFalse(expected.isEmpty());
    try (Session session = Session.of(templates)) {
      session.shows(expected);
    }
  }

  private static List<String> validated(Path project) throws IOException {
    return lines(new Program().run("validate", project, "--format", "json").out());
  }

  /** Returns the findings of a report, a line for each. */
  private static List<String> lines(String json) throws IOException {
    List<String> lines = new ArrayList<>();
    for (JsonNode each : new ObjectMapper().readTree(json).path("findings")) {
      lines.add(
          Stream.concat(
                  Stream.of("severity", "id", "file", "line", "message", "hint", "rule")
                      .map(name -> each.path(name).asText()),
                  Stream.of(marked(each)))
              .reduce((left, right) -> left + " | " + right)
              .orElseThrow());
    }
    return lines.stream().sorted().toList();
  }

  /**
   * Returns the line and the columns that an editor should mark: the word at the column that the
   * command line names or, if that is none, the line without its indentation. Words are names,
   * paths, numbers and start tags; a sign alone is marked with the rest of its line.
   */
  private static String marked(JsonNode finding) throws IOException {
    int line = finding.path("line").asInt();
    if (line == 0) {
      return "1:1-1";
    }
    String text = Files.readAllLines(Path.of(finding.path("file").asText())).get(line - 1);
    int column = finding.path("column").asInt();
    int start = column > 0 ? column - 1 : text.length() - text.stripLeading().length();
    Matcher word = WORD.matcher(text);
    int end = column > 0 && word.find(start) && word.start() == start ? word.end() : text.length();
    return line + ":" + (start + 1) + "-" + (end + 1);
  }

  private static String line(Path file, Diagnostic shown) {
    JsonObject data = (JsonObject) shown.getData();
    Position start = shown.getRange().getStart();
    Position end = shown.getRange().getEnd();
    return Stream.of(
            shown.getSeverity().toString().toLowerCase(Locale.ROOT),
            shown.getCode().getLeft(),
            file.toString(),
            Integer.toString(start.getLine() + 1),
            data.get("message").getAsString(),
            data.get("hint").getAsString(),
            data.get("rule").getAsString(),
            end.getLine() + 1 + ":" + (start.getCharacter() + 1) + "-" + (end.getCharacter() + 1))
        .reduce((left, right) -> left + " | " + right)
        .orElseThrow();
  }
}
