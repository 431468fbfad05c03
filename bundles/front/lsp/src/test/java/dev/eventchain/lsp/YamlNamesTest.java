package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Names in the YAML of a project that no schema lists: units, components, and what components take
 * and give.
 */
class YamlNamesTest {

  private static final String PROJECT = "examples/radar-aeb/";

  private static Analysis analysis(String file, String marked) {
    return UnsavedText.analysis(PROJECT + file, marked);
  }

  private static TextPosition cursor(String marked) {
    return new TextLines(marked).position(marked.indexOf('^'));
  }

  private static List<Completion> proposals(String file, String marked) {
    return analysis(file, marked).completions(cursor(marked));
  }

  /** Returns the text once a proposal is taken. */
  private static String taken(String marked, Completion taken) {
    String text = marked.replace("^", "");
    TextLines lines = new TextLines(text);
    return text.substring(0, lines.offset(taken.replaced().start()))
        + taken.insertText()
        + text.substring(lines.offset(taken.replaced().end()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "inputs:\\n  a: {unit: ^}          | km/h | {unit: km/h}",
        "inputs:\\n  a:\\n    unit: k^m/s   | m/s  | unit: m/s",
        "inputs:\\n  a:\\n    unit:^        | %    | unit: \"%\"",
        "inputs:\\n  a:\\n    unit: ^       | 1    | unit: \"1\"",
        "inputs:\\n  a:\\n    unit: '^'     | %    | unit: '%'",
      })
  void unitsOfABenchStandAsYamlWantsThem(String written, String label, String expected) {
    String marked = written.replace("\\n", "\n");
    Completion unit =
        proposals("bench.yaml", marked).stream()
            .filter(each -> each.label().equals(label))
            .findFirst()
            .orElseThrow();
    String taken = taken(marked, unit);
    assertTrue(taken.endsWith(expected), taken);
  }

  @Test
  void unitsOfTheFieldComeFirst() {
    String marked =
        """
        provides:
          /radar/target:
            fields:
              range_rate: {value: "1", unit: ^}
        """;
    List<String> labels = proposals("bench.yaml", marked).stream().map(Completion::label).toList();
    assertEquals("km/h", labels.get(0));
    assertTrue(labels.indexOf("m/s") < labels.indexOf("m"), labels.toString());
    assertTrue(labels.contains("psi"), labels.toString());
  }

  /** The letter of a unit stands for many things in a project. */
  @Test
  void aUnitHasNoUses() {
    String marked = "inputs:\n  a: {unit: ^m}\n";
    Analysis analysis = analysis("bench.yaml", marked);
    assertEquals(List.of(), analysis.references(cursor(marked), true));
    assertEquals(Optional.empty(), analysis.hover(cursor(marked)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "mutants.yaml; - component: ^; Brake_Request; - component: Brake_Request",
        "eventchain-suppressions.yaml; - id: a.b\\n  element: ^; EventChain[radar_aeb]/software[Brake_Request]; element: EventChain[radar_aeb]/software[Brake_Request]",
        "eventchain-suppressions.yaml; - id: a.b\\n  element: Event^Chain[x]/so; EventChain[radar_aeb]/software[Brake_Request]; element: EventChain[radar_aeb]/software[Brake_Request]",
        "eventchain-suppressions.yaml; - {id: a.b, element: ^}; EventChain[radar_aeb]/software[Brake_Request]; element: \"EventChain[radar_aeb]/software[Brake_Request]\"}",
      })
  void componentsAreProposed(String file, String written, String label, String expected) {
    String marked = written.replace("\\n", "\n");
    List<Completion> found = proposals(file, marked);
    Completion component =
        found.stream()
            .filter(each -> each.label().equals(label))
            .findFirst()
            .orElseThrow(() -> new AssertionError(found.stream().map(Completion::label).toList()));
    assertTrue(component.documentation().startsWith("Brakes with 9 m/s2"));
    assertTrue(taken(marked, component).endsWith(expected), taken(marked, component));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "mutants.yaml; - component: Brake_^Request",
        "eventchain-suppressions.yaml; - element: EventChain[radar_aeb]/software[Brake^_Request]/measured",
        "eventchain-suppressions.yaml; - {element: '*/software[Brake^_Request]'}",
      })
  void componentsAreDescribedAndLeadToTheirFile(String file, String marked) {
    Analysis analysis = analysis(file, marked);
    String about = analysis.hover(cursor(marked)).orElseThrow().markdown();
    assertTrue(about.startsWith("Brakes with 9 m/s2"), about);
    List<FileRange> found = analysis.definitions(cursor(marked));
    assertEquals(1, found.size());
    assertTrue(found.get(0).file().endsWith("software-base/components.json"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "mutants.yaml; - component: No^body",
        "mutants.yaml; - reason: Brake_^Request",
        "eventchain-suppressions.yaml; - element: EventChain[x]/software[No^body]",
        "eventchain-suppressions.yaml; - element: EventChain[rada^r_aeb]/software[Brake_Request]",
        "eventchain-suppressions.yaml; - reason: EventChain[x]/software[Brake^_Request]",
      })
  void whatNamesNoComponentLeadsNowhere(String file, String marked) {
    Analysis analysis = analysis(file, marked);
    assertEquals(List.of(), analysis.definitions(cursor(marked)));
  }

  private static final String TESTS = "tests/Brake_Request.yaml";

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "tests:\\n- name: a\\n  inputs: {^}; ttc; inputs: {ttc: }",
        "tests:\\n- inputs:\\n    ttc: 1\\n    clo^; closing_speed; closing_speed: ",
        "tests:\\n- steps:\\n  - {repeat: 2, inputs: {^; closing_speed; inputs: {closing_speed: ",
        "tests:\\n- outputs: {acceleration: 1, ^}; active; acceleration: 1, active: }",
        "tests:\\n- outputs: {active: ^}; false; active: false}",
        "tests:\\n- outputs: {active: {value: ^}}; true; value: true}}",
        "tests:\\n- requirement: ^; RAD-3; requirement: RAD-3",
        "tests:\\n- {requirement: RAD^, inputs: {}}; RAD-3; requirement: RAD-3, inputs: {}}",
        "properties:\\n- output: ^; acceleration; output: acceleration",
        "properties:\\n- {over: {^}}; ttc; over: {ttc: }}",
        "properties:\\n- rises_with: ^; closing_speed; rises_with: closing_speed",
        "component: ^; Brake_Request; component: Brake_Request",
      })
  void testsNameWhatTheirComponentHas(String written, String label, String expected) {
    String marked = written.replace("\\n", "\n");
    List<Completion> found = proposals(TESTS, marked);
    Completion name =
        found.stream()
            .filter(each -> each.label().equals(label))
            .findFirst()
            .orElseThrow(() -> new AssertionError(found.stream().map(Completion::label).toList()));
    String taken = taken(marked, name);
    assertTrue(taken.endsWith(expected.stripTrailing()) || taken.endsWith(expected + " "), taken);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "tests/Brake_Request.yaml; tests:\\n- inputs: {^}; active",
        "tests/Brake_Request.yaml; tests:\\n- outputs: {^}; ttc",
        "tests/Brake_Request.yaml; tests:\\n- outputs: {acceleration: ^}; true",
        "tests/Nobody.yaml; tests:\\n- inputs: {^}; ttc",
      })
  void testsDoNotNameOthers(String file, String written, String label) {
    assertTrue(
        proposals(file, written.replace("\\n", "\n")).stream()
            .noneMatch(each -> each.label().equals(label)));
  }

  @Test
  void inputsAndOutputsAreDescribed() {
    String input = "tests:\n- inputs: {clos^ing_speed: 1}\n";
    Analysis analysis = analysis(TESTS, input);
    assertEquals(
        "`float32` in m/s, `closing_speed` of `/aeb/threat`",
        analysis.hover(cursor(input)).orElseThrow().markdown().lines().findFirst().orElseThrow());
    assertEquals(List.of(), analysis.references(cursor(input), true));
    String output = "properties:\n- output: accel^eration\n";
    String about = analysis(TESTS, output).hover(cursor(output)).orElseThrow().markdown();
    assertTrue(about.startsWith("`float32` in m/s2"), about);
    String component = "component: Brake_^Request\n";
    assertEquals(1, analysis(TESTS, component).definitions(cursor(component)).size());
  }

  /** Texts that a catalogue names, in quotation marks where YAML would take them otherwise. */
  @Test
  void textsAreThoseOfTheCatalogue(@TempDir Path folder) throws Exception {
    Path project =
        Projects.copy(Repository.ROOT.resolve("examples/child-presence"), folder.resolve("cpd"));
    Files.writeString(
        project.resolve("software-base/components.json"),
        """
        [{"name": "Watch", "description": "Looks at a seat.", "frequency": 10,
          "worst_case_execution_time": 1, "requirements": [],
          "input": [{"topic": "/vss/Vehicle/Cabin/Seat/Row2/Middle/OccupancyStatus",
            "message_type": "std_msgs/msg/String", "qos_profile": "default",
            "values": [{"name": "seat", "field": "data", "type": "string", "description": "Seat"}]}],
          "output": []}]
        """);
    Files.createDirectories(project.resolve("software-base/components"));
    Files.writeString(
        project.resolve("software-base/components/Watch.py"),
        "class Watch:\n    def execute(self, seat):\n        return {}\n");
    String marked = "tests:\n- inputs: {seat: ^}\n";
    List<Completion> found =
        UnsavedText.analysis(project.resolve("tests/Watch.yaml").toString(), marked)
            .completions(cursor(marked));
    assertTrue(
        found.stream().anyMatch(each -> each.insertText().equals("OCCUPIED")), found.toString());
  }
}
