package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Names in the YAML of a project that no schema lists: units and components. */
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
            .orElseThrow(
                () -> new AssertionError(found.stream().map(Completion::label).toList()));
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
}
