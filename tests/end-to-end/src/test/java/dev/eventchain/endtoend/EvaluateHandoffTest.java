package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests an evaluation with answers by people, from a chat window. */
class EvaluateHandoffTest {

  private static final ObjectMapper MAPPER = new ObjectMapper();

  @TempDir Path folder;
  private Path project;
  private final Map<String, String> answers = new TreeMap<>();

  @BeforeEach
  void copyExample() throws IOException {
    project = Program.exampleIn(folder);
    try (Stream<Path> files = Files.walk(project.resolve("recordings"))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        JsonNode recording = MAPPER.readTree(file.toFile());
        JsonNode question = recording.at("/request/messages/0/content");
        answers.put(lines(question), lines(recording.at("/samples/0/text")));
      }
    }
  }

  private static String lines(JsonNode text) {
    return String.join(
        "\n", StreamSupport.stream(text.spliterator(), false).map(JsonNode::asText).toList());
  }

  private Program.Ended evaluate() {
    return new Program()
        .run(
            "evaluate",
            project,
            "--runs",
            2,
            "--models",
            "vendor/chat",
            "--llm",
            "handoff:" + folder.resolve("handoff"));
  }

  private List<Path> prompts() throws IOException {
    try (Stream<Path> files = Files.walk(folder.resolve("handoff"))) {
      return files.filter(file -> file.toString().endsWith(".prompt.md")).sorted().toList();
    }
  }

  /** Answers the prompts of a run. */
  private void answer(String run, String statement) throws IOException {
    for (Path prompt : prompts()) {
      if (prompt.getParent().endsWith(run)) {
        String text = Files.readString(prompt);
        String answer =
            answers.keySet().stream().filter(text::contains).findFirst().map(answers::get).get();
        Path file = Path.of(prompt.toString().replace(".prompt.md", ".answer.md"));
        Files.writeString(file, statement + answer + "\n");
      }
    }
  }

  @InTurn
  @Test
  void allPromptsAreWrittenAndWhatIsAnsweredIsCounted() throws IOException {
    evaluate().expect(4).says("[llm.handoff.waiting]").says("waiting for an answer: 2");
    assertEquals(2, prompts().size(), "the design of each run");
    answer("run-01", "");
    evaluate().expect(4);
    assertEquals(1 + 2 + 2 + 1 + 1 + 1, prompts().size(), "all that does not wait for each other");
    answer("run-01", "");
    evaluate()
        .expect(4)
        .says("vendor/chat run 1")
        .says("overall passed")
        .says("1 of 2 runs counted (waiting for an answer: 1)");
    String table = evaluate().expect(4).says("(as before)").out();
    assertFalse(table.contains("authored"), table);
  }

  @InTurn
  @Test
  void answersThatPeopleSayTheyWroteAreNoMeasurement() throws IOException {
    evaluate().expect(4);
    answer("run-01", "");
    answer("run-02", "<!-- provenance: authored -->\n");
    evaluate().expect(4);
    answer("run-01", "");
    answer("run-02", "");
    String table = evaluate().expect(0).out();
    assertTrue(table.startsWith("Answers of vendor/chat are authored by people"), table);
    assertTrue(table.contains("\nvendor/chat: 1 of 1 run counted"), table);
    assertTrue(table.contains("\nvendor/chat (authored): 1 of 1 run counted"), table);
  }
}
