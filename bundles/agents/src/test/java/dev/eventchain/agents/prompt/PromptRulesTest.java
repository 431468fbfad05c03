package dev.eventchain.agents.prompt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.QosSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Prompts state every rule that answers are checked for. A table maps each rule of the checking
 * bundles to the words of a prompt, or to the reason why it refuses no answer; new rules have to be
 * added.
 */
class PromptRulesTest {
  private static final Path TABLE = Path.of("src/test/resources/prompt-rules.txt");

  /** The checking bundles; findings about a project's own files are left out. */
  private static final List<String> CHECKING =
      List.of(
          "agents",
          "chain/contracts",
          "chain/description",
          "chain/project",
          "mde/constraints",
          "mde/json-models",
          "mde/ocl",
          "robot/sandbox");

  private static final Set<String> TASKS =
      Set.of("design", "test", "implement", "model", "constrain", "diagnose");

  /** A line of the table. */
  private record Line(String id, String task, String words) {}

  @Test
  void everyRuleIsInTheTable() throws IOException {
    Set<String> pages = new TreeSet<>();
    for (String bundle : CHECKING) {
      try (Stream<Path> files = Files.list(Path.of("..").resolve(bundle).resolve("rules"))) {
        files
            .map(file -> file.getFileName().toString().replaceFirst("\\.md$", ""))
            .filter(id -> !id.startsWith("project.") && !id.startsWith("suppression."))
            .forEach(pages::add);
      }
    }
    assertFalse(pages.isEmpty());
    assertEquals(
        pages, table().stream().map(Line::id).collect(Collectors.toCollection(TreeSet::new)));
  }

  @Test
  void promptsHoldTheWordsOfTheTable() throws IOException {
    for (Line line : table()) {
      if (line.task().equals("-")) {
        assertFalse(line.words().isBlank(), line::toString);
      } else {
        assertTrue(TASKS.contains(line.task()), line::toString);
        assertTrue(prompt(line.task()).contains(line.words()), line::toString);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"design", "model"})
  void profilesOfQualityOfServiceAreNamed(String task) {
    for (String name : QosSettings.names()) {
      assertTrue(Pattern.compile("\\b" + name + "\\b").matcher(prompt(task)).find(), name);
    }
  }

  @Test
  void modulesThatComponentsMayImportAreNamed() throws IOException {
    Path names =
        Path.of("../robot/sandbox/src/main/resources/dev/eventchain/sandbox/component_names.py");
    String allowed = Files.readString(names);
    allowed = allowed.substring(0, allowed.indexOf("}.items()"));
    List<String> modules =
        Pattern.compile("(?m)^        \"([a-z.]+)\":")
            .matcher(allowed)
            .results()
            .map((MatchResult found) -> found.group(1))
            .filter(module -> !module.startsWith("numpy"))
            .toList();
    assertTrue(modules.contains("math"));
    assertTrue(
        prompt("implement").contains(modules.stream().sorted().collect(Collectors.joining(", "))),
        modules::toString);
  }

  @Test
  void noPromptNamesTheRequirementsOfOneProject() throws IOException {
    for (String task : TASKS) {
      assertFalse(prompt(task).contains("AEB-"), task);
    }
    assertFalse(Files.readString(Path.of("../../metamodel/eventchain.ecore")).contains("AEB-"));
  }

  private static String prompt(String task) {
    return PromptTemplate.resource(task + "/v1.md")
        .lines()
        .filter(line -> !line.startsWith("%%"))
        .collect(Collectors.joining("\n"));
  }

  private static List<Line> table() throws IOException {
    return Files.readAllLines(TABLE).stream()
        .filter(line -> !line.startsWith("#"))
        .map(line -> line.split(" \\| ", 3))
        .map(parts -> new Line(parts[0], parts[1], parts[2]))
        .toList();
  }
}
