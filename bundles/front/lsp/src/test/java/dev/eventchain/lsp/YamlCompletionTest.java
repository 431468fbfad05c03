package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Completion in the YAML of projects: keys and values by the schemas, names by the project. */
class YamlCompletionTest {

  private static final String SCENARIO = "scenarios/new.yaml";

  @TempDir private static Path folder;

  private static Path project;

  @BeforeAll
  static void open() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    project = Projects.copy(example, folder.resolve("radar-aeb"));
  }

  private static final String AHEAD =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <OpenSCENARIO>
        <FileHeader revMajor="1" revMinor="2" date="2026-01-01T00:00:00" description="" author=""/>
        <ParameterDeclarations>
          <ParameterDeclaration name="Ego_speed" parameterType="double" value="11.5"/>
          <ParameterDeclaration name="Road" parameterType="string" value="wet"/>
        </ParameterDeclarations>
        <CatalogLocations/>
        <RoadNetwork/>
        <Entities/>
        <Storyboard>
          <Init><Actions/></Init>
          <StopTrigger/>
        </Storyboard>
      </OpenSCENARIO>
      """;

  /** Returns the proposals at the mark in a text. */
  private static List<Completion> proposals(String file, String marked) {
    return analysis(file, marked).completions(cursor(marked));
  }

  private static Analysis analysis(String file, String marked) {
    return UnsavedText.analysis(project.resolve(file).toString(), marked);
  }

  private static TextPosition cursor(String marked) {
    return new TextLines(marked).position(marked.indexOf('^'));
  }

  private static List<String> labels(String file, String marked) {
    return proposals(file, marked).stream().map(Completion::label).toList();
  }

  /** Returns the text once a proposal is taken, with further lines indented as editors do it. */
  private static String taken(String file, String marked, String label) {
    Completion taken =
        proposals(file, marked).stream()
            .filter(each -> each.label().equals(label))
            .findFirst()
            .orElseThrow();
    String text = marked.replace("^", "");
    TextLines lines = new TextLines(text);
    int start = lines.offset(taken.replaced().start());
    int begin = text.lastIndexOf('\n', start - 1) + 1;
    String line = text.substring(begin);
    String indent = line.substring(0, line.length() - line.stripLeading().length());
    String inserted =
        taken.snippet() ? taken.insertText().replace("$0", "^") : taken.insertText() + "^";
    return text.substring(0, start)
        + inserted.replace("\n", "\n" + indent)
        + text.substring(lines.offset(taken.replaced().end()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "dur^                             | duration_s  | duration_s: ^",
        "title: x\\neg^\\nseed: 1          | ego         | title: x\\nego:\\n  ^\\nseed: 1",
        "ego:\\n  len^                     | length_m    | ego:\\n  length_m: ^",
        "ego:\\n  spe^ed: 3                | speed_kmh   | ego:\\n  speed_kmh^: 3",
        "ego: {sp^}                       | speed_kmh   | ego: {speed_kmh: ^}",
        "ego: {length_m: 4, ^             | speed_kmh   | ego: {length_m: 4, speed_kmh: ^",
        "act^                             | actors      | actors:\\n  - ^",
        "actors:\\n  - ki^                  | kind        | actors:\\n  - kind: ^",
        "actors:\\n- ki^                    | kind        | actors:\\n- kind: ^",
        "actors:\\n  - gap_m: 1\\n    man^   | maneuvers   | actors:\\n  - gap_m: 1\\n    maneuvers:\\n      - ^",
        "actors:\\n  - man^                 | maneuvers   | actors:\\n  - maneuvers:\\n      - ^",
        "actors: [{gap_m: 1, ^}]          | maneuvers   | actors: [{gap_m: 1, maneuvers: [^]}]",
        "actors:\\n  - kind: ped^           | pedestrian  | actors:\\n  - kind: pedestrian^",
        "actors:\\n  - {kind:^              | pedestrian  | actors:\\n  - {kind: pedestrian^",
        "accept:\\n  no_^                   | no_impact   | accept:\\n  no_impact: true^",
        "ego:\\n  speed_kmh\\nacc^           | accept      | ego:\\n  speed_kmh\\naccept:\\n  ^",
        "requirements: [RAD-1, ^          | RAD-2       | requirements: [RAD-1, RAD-2^",
        "requirements:\\n  - RA^            | RAD-3       | requirements:\\n  - RAD-3^",
        "accept:\\n  judges:\\n    stops: {^} | RAD-3      | accept:\\n  judges:\\n    stops: {RAD-3: ^}",
        "phases_ms:\\n  ^                   | Radar_Tracking | phases_ms:\\n  Radar_Tracking: ^",
        "\"seed\": 1\\nti^                   | title       | \"seed\": 1\\ntitle: ^",
      })
  void whatIsTakenStandsWhereItBelongs(String marked, String label, String expected) {
    assertEquals(
        expected.replace("\\n", "\n"), taken(SCENARIO, marked.replace("\\n", "\n"), label));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "eventchain.yaml   | ^                                       | frequency",
        "eventchain.yaml   | name: a\\nros_distro: ^                  | jazzy",
        "eventchain.yaml   | models:\\n  ^                            | implement",
        "eventchain.yaml   | services:\\n  ours:\\n    wire: ^          | ollama",
        "eventchain.yaml   | requirements:\\n  - ^                    | file",
        "eventchain.yaml   | strength: ^                             | whole",
        "eventchain.yaml   | strength:\\n  ^                          | minimum_percent",
        "eventchain.yaml   | strength:\\n  requirements:\\n    ^        | RAD-1",
        "eventchain-suppressions.yaml | - ^                          | expires",
        "eventchain-suppressions.yaml | - id: a.b\\n  ^               | reason",
        "eventchain-suppressions.yaml | - id: ^                      | ocl.violated",
        "bench.yaml        | ^                                       | provides",
        "bench.yaml        | consumes:\\n  ^                          | /brake/request",
        "bench.yaml        | consumes:\\n  /a:\\n    fields:\\n      b: ^ | hand_brake",
        "faults.yaml       | faults:\\n  - name: a\\n    ^              | at_s",
        "faults.yaml       | faults:\\n  - kill: ^                    | Radar_Tracking",
        "faults.yaml       | faults:\\n  - drop: {topic: ^            | /radar/target",
        "faults.yaml       | faults:\\n  - scenario: [a, ^            | stopped-vehicle-50",
        "campaigns/c.yaml  | ^                                       | factors",
        "campaigns/c.yaml  | scenario: ^                             | stopped-vehicle-50",
        "campaigns/c.yaml  | factors:\\n  speed: {^                   | uniform",
        "campaigns/c.yaml  | search:\\n  method: ^                    | cma_es",
        "campaigns/c.yaml  | campaigns:\\n  a:\\n    sampling:\\n      ^  | halton",
        "elsewhere/c.yaml  | factors:\\n  speed:\\n    ^                | csv",
      })
  void eachKindOfFileHasItsSchemaAndNames(String file, String marked, String label) {
    List<String> labels = labels(file, marked.replace("\\n", "\n"));
    assertTrue(labels.contains(label), labels.toString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "scenarios/new.yaml | ^ | name, title, ego, accept, duration_s | name: $1\\ntitle: $2\\nego:\\n  speed_kmh: $3\\naccept:\\n  $4\\nduration_s: $5",
        "scenarios/new.yaml | openscenario:\\n  file: a.xosc\\n^ | name, title, accept | name: $1\\ntitle: $2\\naccept:\\n  $3",
        "scenarios/new.yaml | furn^ | furniture … | furniture:\\n  - kind: ${1:parked_car}\\n    gap_m: $2",
        "scenarios/new.yaml | actors:\\n  - ^ | gap_m, speed_kmh | gap_m: $1\\n  speed_kmh: $2",
        "scenarios/new.yaml | ego:\\n  maneuvers:\\n    - at_s: 1\\n      ^ | speed_kmh, acceleration_mps2 | speed_kmh: $1\\nacceleration_mps2: $2",
        "eventchain.yaml | pri^ | prices … | prices:\\n  ${1:name}:\\n    input_per_million: $2\\n    output_per_million: $3",
        "eventchain.yaml | services:\\n  ours:\\n    ^ | wire, url | wire: ${1:openai}\\nurl: $2",
        "eventchain-suppressions.yaml | - ^ | id, reason, expires | id: $1\\n  reason: $2\\n  expires: $3",
        "faults.yaml | faults:\\n  - name: a\\n    ^ | scenario, at_s, drop | scenario: $1\\nat_s: $2\\ndrop:\\n  topic: $3",
        "campaigns/c.yaml | factors:\\n  a:\\n    ^ | from, to, step | from: $1\\nto: $2\\nstep: $3",
        "bench.yaml | ^ | provides … | provides:\\n  ${1:name}:\\n    rate_hz: $2\\n    fields:\\n      ${3:name}: $4",
      })
  void whatIsRequiredIsProposedAtOnce(String file, String marked, String label, String expected) {
    Completion found =
        proposals(file, marked.replace("\\n", "\n")).stream()
            .filter(each -> each.kind() == ElementKind.SNIPPET && each.label().equals(label))
            .findFirst()
            .orElseThrow();
    assertTrue(found.snippet());
    assertEquals(expected.replace("\\n", "\n"), found.insertText());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "actors:\n  - gap_m: 1\n    ^",
        "ego: {^}",
        "act^ors: 1",
        "ego:\n  speed_kmh: 3\n  ^"
      })
  void nothingElseIsProposedAtOnce(String marked) {
    assertEquals(
        List.of(),
        proposals(SCENARIO, marked).stream()
            .filter(each -> each.kind() == ElementKind.SNIPPET)
            .map(Completion::label)
            .filter(each -> !each.equals("maneuvers …"))
            .toList());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "# ^",
        "seed: 1 # ^",
        "description: >\\n  eg^",
        "title: ^",
        "seed: 1\\n  ^",
        "unknown:\\n  ^"
      })
  void nothingIsProposedWhereNothingIsKnown(String marked) {
    assertEquals(List.of(), labels(SCENARIO, marked.replace("\\n", "\n")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "factors:\\n  speed:\\n    path: ^              | ego.speed_kmh | path: ego.speed_kmh^",
        "factors:\\n  gap:\\n    path: ac^              | actors[0].gap_m | path: actors[0].gap_m^",
        "factors:\\n  gap:\\n    path: actors[sto^pped].x # a | actors[0].gap_m | path: actors[0].gap_m^ # a",
        "factors:\\n  gap: {path: ^, values: [1]}  | actors[0].gap_m | {path: \"actors[0].gap_m\"^, values: [1]}",
        "factors:\\n  gap: {path: \"act^\", from: 1} | actors[0].gap_m | {path: \"actors[0].gap_m^\", from: 1}",
        "factors:\\n  gap:\\n    paths:\\n      - ^    | ego.speed_kmh | - ego.speed_kmh^",
        "computed:\\n  gap:\\n    path: ^               | ego.speed_kmh | path: ego.speed_kmh^",
        "factors:\\n  phase:\\n    path: ph^           | phases_ms.Radar_Tracking | path: phases_ms.Radar_Tracking^",
      })
  void pathsOfFactorsLeadToNumbersOfTheScenario(String marked, String label, String expected) {
    for (String scenario : List.of("stopped-vehicle-50", "../scenarios/stopped-vehicle-50.yaml")) {
      String campaign = "scenario: " + scenario + "\n" + marked.replace("\\n", "\n") + "\n";
      String taken = taken("campaigns/c.yaml", campaign, label);
      assertTrue(taken.contains(expected.replace("\\n", "\n")), taken);
    }
  }

  /** Parameters of a file in OpenSCENARIO XML that are numbers, with what they are now. */
  @Test
  void pathsOfFactorsLeadToParametersOfOpenScenario() throws IOException {
    Path folder = Files.createDirectories(project.resolve("campaigns"));
    Files.writeString(folder.resolve("ahead.xosc"), AHEAD);
    Files.writeString(folder.resolve("broken.xosc"), AHEAD.replace("</OpenSCENARIO>", ""));
    String campaign = "scenario: %s\nfactors:\n  speed:\n    path: ^\n";
    List<String> labels = labels("campaigns/c.yaml", campaign.formatted("ahead.xosc"));
    assertTrue(labels.contains("openscenario.parameters.Ego_speed"), labels.toString());
    assertTrue(labels.contains("phases_ms.Radar_Tracking"), labels.toString());
    assertFalse(labels.contains("openscenario.parameters.Road"), labels.toString());
    assertEquals(List.of(), labels("campaigns/c.yaml", campaign.formatted("broken.xosc")));
    assertEquals(List.of(), labels("campaigns/c.yaml", campaign.formatted("../../ahead.xosc")));
  }

  @Test
  void pathsOfFactorsAreThoseOfTheirOwnCampaign() {
    String campaigns =
        """
        campaigns:
          a:
            scenario: none
            factors:
              x:
                path: %s
          b:
            scenario: stopped-vehicle-50
            factors:
              x:
                path: %s
        """;
    assertEquals(List.of(), labels("campaigns/c.yaml", campaigns.formatted("^", "")));
    List<String> labels = labels("campaigns/c.yaml", campaigns.formatted("", "^"));
    assertTrue(labels.contains("ego.speed_kmh"), labels.toString());
    assertTrue(labels.stream().anyMatch(each -> each.startsWith("bench:")), labels.toString());
    assertFalse(labels.contains("name"), labels.toString());
  }

  @Test
  void findingsThatCannotBeSuppressedAreNotProposed() {
    List<String> labels = labels("eventchain-suppressions.yaml", "- id: ^");
    assertFalse(labels.contains("ocl.nothing-evaluated"), labels.toString());
    assertFalse(labels.contains("suppression.invalid"), labels.toString());
  }

  @Test
  void settingsAndSuppressionsAreDescribed() {
    String settings = "name: aeb\nrep^airs: 2\n";
    assertEquals(
        "How often an answer that failed its checks goes back. Default: 3.",
        analysis("eventchain.yaml", settings).hover(cursor(settings)).orElseThrow().markdown());
    String suppressions = "- id: a.b\n  rea^son: r\n";
    assertEquals(
        "Required. Why they do not count.",
        analysis("eventchain-suppressions.yaml", suppressions)
            .hover(cursor(suppressions))
            .orElseThrow()
            .markdown());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "faults.yaml | faults:\\n  - scenario: stopped-veh^icle-50 | Stopped vehicle, 50 km/h | scenarios/stopped-vehicle-50.yaml | name: stopped-vehicle-50",
        "faults.yaml | faults:\\n  - kill: Brake_^Request | Brakes with 9 m/s2 below | software-base/components.json | \"name\": \"Brake_Request\",",
        "faults.yaml | faults:\\n  - drop: {topic: /radar/tar^get} | `demo_msgs/msg/RadarTarget`, provided by the vehicle | software-base/signals.json | \"Topic Name\": \"/radar/target\",",
        "scenarios/new.yaml | phases_ms:\\n  Brake_^Request: 3 | Brakes with 9 m/s2 below | software-base/components.json | \"name\": \"Brake_Request\",",
        "faults.yaml | faults:\\n  - kill: Nob^ody | | |",
      })
  void namesAreDescribedAndLeadToTheirOwners(
      String file, String marked, String about, String target, String line) throws IOException {
    String whole = marked.replace("\\n", "\n");
    Analysis analysis = analysis(file, whole);
    String shown = analysis.hover(cursor(whole)).map(each -> each.markdown()).orElse("");
    assertTrue(about == null ? shown.isEmpty() : shown.startsWith(about), shown);
    List<FileRange> found = analysis.definitions(cursor(whole));
    assertEquals(target == null ? 0 : 1, found.size(), found.toString());
    if (target != null) {
      assertEquals(project.resolve(target), found.get(0).file());
      List<String> lines = Files.readAllLines(found.get(0).file());
      assertEquals(line, lines.get(found.get(0).range().start().line()).strip());
    }
  }

  @Test
  void whatIsNeededComesFirstWithItsDescriptionAndWhatIsThereNotAtAll() {
    List<Completion> found =
        proposals(SCENARIO, "actors:\n  - ^\n    name: it\n    gap_m: 1\nseed: 1\n");
    assertEquals("speed_kmh", found.get(0).label());
    assertEquals("required", found.get(0).detail());
    assertFalse(found.stream().anyMatch(each -> List.of("name", "gap_m").contains(each.label())));
    Completion kind =
        found.stream().filter(each -> each.label().equals("kind")).findFirst().orElseThrow();
    assertEquals("Gives it a size. Default: car.", kind.documentation());
    String known = "actors:\n  - ki^nd: car\n";
    assertEquals(
        "Gives it a size. Default: car.",
        analysis(SCENARIO, known).hover(cursor(known)).orElseThrow().markdown());
  }

  /** Each place of each scenario, cut off there, is answered about. */
  @Test
  void textsThatEndAnywhereAreAnsweredAbout() throws Exception {
    String whole = Files.readString(project.resolve("scenarios/stopped-vehicle-50.yaml"));
    for (int end = 0; end <= whole.length(); end += 7) {
      String cut = whole.substring(0, end) + "^";
      List<Completion> found = proposals(SCENARIO, cut);
      int line = new TextLines(cut).position(end).line();
      assertTrue(found.stream().allMatch(each -> each.replaced().start().line() == line));
    }
  }
}
