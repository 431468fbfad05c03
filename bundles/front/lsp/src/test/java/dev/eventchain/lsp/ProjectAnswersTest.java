package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.editing.Workspace;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.project.ProjectLanguageService;
import dev.eventchain.lsp.text.OpenTexts;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Answers about each kind of file of a project: outline, colours, selection, and names. */
class ProjectAnswersTest {

  private static final Path PROJECT =
      Repository.ROOT.toAbsolutePath().normalize().resolve("examples/radar-aeb");
  private static final String SCENARIO = "scenarios/stopped-vehicle-50.yaml";

  /** A workspace in which one file has another text than on disk. */
  private record Edited(Path file, Optional<String> text) implements Workspace {
    @Override
    public List<Path> files() {
      return List.of();
    }

    @Override
    public Optional<SourceText> text(Path asked) {
      return Optional.of(
          asked.equals(file) && text.isPresent()
              ? SourceText.of(file.toString(), text.get())
              : SourceText.read(asked));
    }

    @Override
    public List<EPackage> metamodels(Path of) {
      return List.of();
    }
  }

  private static Analysis analysis(String name, Optional<String> text) {
    Path file = PROJECT.resolve(name);
    return new ProjectLanguageService(new Edited(file, text), new OpenTexts())
        .analysis(file)
        .orElseThrow();
  }

  private static Analysis saved(String name) {
    return analysis(name, Optional.empty());
  }

  private static TextPosition at(String name, String word) throws IOException {
    String text = Files.readString(PROJECT.resolve(name));
    assertTrue(text.contains(word), word);
    return new TextLines(text).position(text.indexOf(word) + word.length() - 1);
  }

  private static String outline(List<Symbol> symbols, String indent) {
    StringBuilder text = new StringBuilder();
    for (Symbol each : symbols) {
      text.append(indent).append(each.name());
      text.append(each.detail().isEmpty() ? "" : " = " + each.detail()).append('\n');
      text.append(outline(each.children(), indent + "  "));
    }
    return text.toString();
  }

  @Test
  void yamlIsOutlinedByKeysAndItems() {
    String text =
        """
        name: a # so called
        actors:
        - gap_m: 80
          speed_kmh: 0
        -
          name: walker
        accept:
          judges: {RAD-1: x,
            RAD-2: y}
          notes: |
            key: no key
            - no item

          formulas:
            - formula: always
                gap > 1 m
              half typed
            - - deep
        last
        """;
    assertEquals(
        """
        name = a
        actors
          gap_m: 80
            gap_m = 80
            speed_kmh = 0
          walker
            name = walker
        accept
          judges = {RAD-1: x,
          notes
          formulas
            formula: always
              formula = always
            -
              deep
        """,
        outline(analysis(SCENARIO, Optional.of(text)).symbols(), ""));
  }

  @Test
  void jsonAndModelsAreOutlinedByTheirNames() {
    assertTrue(
        outline(saved("software-base/components.json").symbols(), "")
            .startsWith("Radar_Tracking\n  /radar/target\n    valid\n    distance\n"));
    assertTrue(
        outline(saved("software-base/signals.json").symbols(), "")
            .startsWith("/radar/target\n  valid\n  range\n  range_rate\n"));
    String model = outline(saved("model/chain.xmi").symbols(), "");
    assertTrue(model.contains("  Radar_Tracking\n"), model);
    assertTrue(model.contains("  RAD-1\n"), model);
  }

  @Test
  void longAndHalfTypedTextsHaveAnOutline() {
    String longest = "x".repeat(200_000);
    String json = "[{\"name\": \"a\", \"about\": \"" + longest + "\"}, {\"name\": \"b\", ";
    assertEquals("a\nb\n", outline(analysis("a.json", Optional.of(json)).symbols(), ""));
    String model = "<a name=\"a\" about='" + longest + "'><b " + longest + " name=\"b\"/><c name=";
    assertEquals("a\n  b\n", outline(analysis("a.xmi", Optional.of(model)).symbols(), ""));
    String yaml = "a: " + longest + "\nb:\n" + "- ".repeat(2_000) + "c";
    assertEquals(2, analysis("a.yaml", Optional.of(yaml)).symbols().size());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "eventchain.yaml",
        "bench.yaml",
        SCENARIO,
        "requirements.md",
        "software-base/components.json",
        "software-base/signals.json",
        "model/chain.xmi",
        "tests/Brake_Request.yaml"
      })
  void partsAreInsideEachOtherAndTokensInTheirOrder(String name) throws IOException {
    Analysis analysis = saved(name);
    String text = Files.readString(PROJECT.resolve(name));
    TextLines lines = new TextLines(text);
    assertFalse(analysis.symbols().isEmpty());
    checkInside(analysis.symbols(), lines.range(0, text.length()));
    for (int offset = 0; offset < text.length(); offset += 7) {
      List<TextRange> ranges = analysis.selectionRanges(lines.position(offset));
      for (int i = 1; i < ranges.size(); i++) {
        checkInside(ranges.get(i - 1), ranges.get(i));
      }
    }
    SemanticToken before = new SemanticToken(0, 0, 0, SemanticToken.Kind.COMMENT, false);
    for (SemanticToken each : analysis.tokens()) {
      boolean isAfter =
          each.line() > before.line()
              || (each.line() == before.line()
                  && each.column() >= before.column() + before.length());
      assertTrue(isAfter, before + " " + each);
      before = each;
    }
  }

  private static void checkInside(List<Symbol> symbols, TextRange around) {
    for (Symbol each : symbols) {
      checkInside(each.range(), around);
      checkInside(each.nameRange(), each.range());
      checkInside(each.children(), each.range());
    }
  }

  private static void checkInside(TextRange inner, TextRange outer) {
    assertTrue(outer.touches(inner.start()) && outer.touches(inner.end()), inner + " " + outer);
  }

  @Test
  void wordsOfYamlHaveTheirMeaning() {
    String text =
        """
        # comment
        accept:
          no_impact: true # here
          judges: {RAD-1: "to 5", gap: [1, 2.5]}
          text: >
            # no comment, 7
          formulas:
            - {name: of 7, formula: "gap > 2"}
            - formula: always[0, 1] /a/b.c == 'd' implies not ttc < 2 s
              judges: RAD-1
        """;
    List<String> words = new ArrayList<>();
    for (SemanticToken each : analysis(SCENARIO, Optional.of(text)).tokens()) {
      String line = text.lines().toList().get(each.line());
      words.add(line.substring(each.column(), each.column() + each.length()) + " " + each.kind());
    }
    assertEquals(
        List.of(
            "# comment COMMENT",
            "accept PROPERTY",
            "no_impact PROPERTY",
            "true KEYWORD",
            "# here COMMENT",
            "judges PROPERTY",
            "RAD-1 ENUMERATION_LITERAL",
            "gap PROPERTY",
            "1 NUMBER",
            "2.5 NUMBER",
            "text PROPERTY",
            "formulas PROPERTY",
            "name PROPERTY",
            "formula PROPERTY",
            "gap VARIABLE",
            "> OPERATOR",
            "2 NUMBER",
            "formula PROPERTY",
            "always KEYWORD",
            "0 NUMBER",
            "1 NUMBER",
            "/a/b NAMESPACE",
            "== OPERATOR",
            "'d' STRING",
            "implies KEYWORD",
            "not KEYWORD",
            "ttc VARIABLE",
            "< OPERATOR",
            "2 NUMBER",
            "judges PROPERTY",
            "RAD-1 ENUMERATION_LITERAL"),
        words);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "bench.yaml | /radar/target | `demo_msgs/msg/RadarTarget`, provided | signals.json",
        SCENARIO
            + " | /brake/request | float32 in m/s2, of `demo_msgs/msg/BrakeRequest` | signals.json",
        "model/chain.xmi | topicName=\"/aeb/threat | `demo_msgs/msg/Threat`, inside | signals.json",
        "model/chain.xmi | name=\"Radar_Tracking | Time to collision | components.json",
        "software-base/components.json | \"topic\": \"/aeb/threat | `demo_msgs/msg/Threat` | signals.json",
        SCENARIO + " | (ttc | in s: | ",
        SCENARIO + " | implies | `p implies q`: | ",
        "bench.yaml | ego.speed | in m/s: | ",
        "bench.yaml | range_rate | float32 in km/h | ",
      })
  void namesAreDescribedAndLeadToTheirDeclarations(
      String file, String word, String about, String target) throws IOException {
    TextPosition position = at(file, word);
    String shown = saved(file).hover(position).orElseThrow().markdown();
    assertTrue(shown.startsWith(about), shown);
    List<FileRange> found = saved(file).definitions(position);
    assertEquals(target == null ? 0 : 1, found.size(), found.toString());
    if (target != null) {
      assertEquals(PROJECT.resolve("software-base").resolve(target), found.get(0).file());
    }
  }

  @Test
  void aTopicIsFoundWhereverTheProjectNamesIt() throws IOException {
    List<String> uses =
        saved("bench.yaml").references(at("bench.yaml", "/brake/request"), true).stream()
            .map(each -> PROJECT.relativize(each.file()).toString())
            .distinct()
            .toList();
    assertEquals(
        List.of(
            "bench.yaml",
            "model/chain.xmi",
            SCENARIO,
            "software-base/components.json",
            "software-base/signals.json"),
        uses);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        SCENARIO
            + " | accept:\\n  formulas:\\n    - formula: always tt^ | ttc, implies, /brake/request.active",
        SCENARIO + " | accept:\\n  formulas:\\n    - formula: /brake/re^ | /brake/request.active",
        "bench.yaml | provides:\\n  /radar/target:\\n    fields:\\n      valid: lead^ | lead.present, and",
        "bench.yaml | provides:\\n  /radar/target:\\n    rate_hz: ^ | ",
        "bench.yaml | provides:\\n  /radar/target:\\n    fields:\\n      ran^ | range, range_rate, valid",
        "bench.yaml | consumes:\\n  /brake/request: {fields: {act^ | active, acceleration",
        "bench.yaml | provides:\\n  /radar/target:\\n    fields:\\n      range: {value: g^ | gap",
        SCENARIO + " | title: the t^ | ",
      })
  void formulasAreCompleted(String file, String marked, String labels) {
    String whole = marked.replace("\\n", "\n");
    String text = whole.replace("^", "");
    List<String> found =
        analysis(file, Optional.of(text))
            .completions(new TextLines(text).position(whole.indexOf('^')))
            .stream()
            .map(Completion::label)
            .toList();
    if (labels == null) {
      assertFalse(found.contains("ttc"), found.toString());
    } else {
      assertTrue(found.containsAll(List.of(labels.split(", ", -1))), found.toString());
    }
  }

  @Test
  void aWorkspaceIsSearchedForWhatProjectsDeclare() {
    assertEquals(
        List.of("stopped-vehicle-50"),
        saved(SCENARIO).workspaceSymbols().stream().map(Symbol::name).toList());
    List<String> components =
        saved("software-base/components.json").workspaceSymbols().stream()
            .map(Symbol::name)
            .toList();
    assertEquals("Radar_Tracking", components.get(0));
  }
}
