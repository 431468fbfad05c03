package dev.eventchain.openscenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.openscenario.document.ResolvedScenario;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.document.ScenarioFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

/** Scenarios as they stand, and with values. */
class ScenarioFileTest {

  private static final Path RESOURCES = Path.of("src/test/resources");
  private static final Path LIBRARY = RESOURCES.resolve("library");
  private static final Path REAR_END = LIBRARY.resolve("scenarios/rear-end/rear-end.xosc");

  private static final ScenarioFile FILE = ScenarioFile.read(REAR_END, LIBRARY);

  private static ScenarioElement target(ResolvedScenario scenario) {
    return scenario.root().required("Entities").children().get(1).choice();
  }

  @Test
  void fileTellsWhatItDeclares() {
    assertEquals(ScenarioFile.Kind.SCENARIO, FILE.kind());
    assertEquals("1.3", FILE.header().version());
    assertEquals("An ego behind a slower target", FILE.header().description());
    assertEquals(
        List.of("ego_kph", "headway_s", "overlap", "row", "gap", "ego_mps", "aside", "car"),
        FILE.parameters().stream().map(each -> each.name()).toList());
    assertEquals("${$headway_s * $ego_mps}", FILE.parameters().get(4).value());
    assertEquals("lessOrEqual", FILE.parameters().get(0).constraints().get(0).get(1).rule());
    assertEquals("boolean", FILE.variables().get(0).type());
    assertEquals("../../roads/straight.xodr", FILE.roadNetwork().orElseThrow());
    assertEquals("..\\..\\catalogs\\vehicles", FILE.catalogLocations().get("VehicleCatalog"));
    assertEquals(List.of(), FILE.warnings());
  }

  @Test
  void parametersFollowFromEachOtherInAnyOrder() {
    ResolvedScenario scenario = FILE.resolve(Map.of("ego_kph", "36", "overlap", "-75"));
    assertEquals("10", scenario.parameters().get("ego_mps"));
    assertEquals("40", scenario.parameters().get("gap"));
    assertEquals("-0.45", scenario.parameters().get("aside"));
    assertEquals(Map.of("touched", "false", "limit", "11"), scenario.variables());
    assertEquals(
        LIBRARY.resolve("roads/straight.xodr").normalize(), scenario.roadFile().orElseThrow());
  }

  @Test
  void referencesAreReplacedByEntriesWithTheirParameters() {
    ResolvedScenario scenario = FILE.resolve(Map.of());
    assertEquals("Vehicle", target(scenario).name());
    assertEquals(
        1.75, target(scenario).required("BoundingBox").required("Dimensions").number("width"));
    assertTrue(target(scenario).location().toString().contains("catalogs/vehicles/cars.xosc:15:"));
    ScenarioElement ego = scenario.root().required("Entities").children().get(0).choice();
    assertEquals(Double.POSITIVE_INFINITY, ego.required("Performance").number("maxSpeed"));
    // The ego's entry has no parameter for the width that the reference assigns.
    assertEquals("osc.parameter.unknown", firstId(() -> FILE.resolve(Map.of("car", "ego"))));
  }

  private static String firstId(Runnable work) {
    DiagnosticException refused = assertThrows(DiagnosticException.class, work::run);
    return refused.diagnostics().get(0).id();
  }

  /** A story hides an outer parameter; what stands outside of it still sees that. */
  @Test
  void innerDeclarationsHideOuterOnes() {
    ScenarioElement board = FILE.resolve(Map.of("ego_kph", "36")).root().required("Storyboard");
    List<ScenarioElement> moves =
        board.required("Story").required("Act").required("ManeuverGroup").children("Maneuver");
    List<Double> rates =
        moves.stream()
            .map(
                move ->
                    move.required("Event").required("Action").choice().choice().choice().choice())
            .map(dynamics -> dynamics.number("value"))
            .toList();
    assertEquals(List.of(40.0, 4.0), rates);
    ScenarioElement end = board.required("StopTrigger").choice().choice().choice().choice();
    assertEquals(4, end.number("value"));
  }

  @Test
  void valuesFromOutsideAreHeldAgainstTypesAndConstraints() {
    assertEquals("osc.parameter.constraint", firstId(() -> FILE.resolve(Map.of("ego_kph", "140"))));
    assertEquals("osc.parameter.unknown", firstId(() -> FILE.resolve(Map.of("egokph", "40"))));
    assertEquals("osc.value", firstId(() -> FILE.resolve(Map.of("ego_kph", "fast"))));
  }

  @Test
  void catalogsOutsideTheFolderAreNotRead() {
    ScenarioFile alone = ScenarioFile.read(REAR_END);
    assertEquals("osc.path", firstId(() -> alone.resolve(Map.of())));
    assertEquals("osc.path", firstId(() -> ScenarioFile.read(REAR_END, LIBRARY.resolve("roads"))));
  }

  @Test
  void filesOfOtherKindsAreNotRead(@TempDir Path folder) throws IOException {
    Path copy = folder.resolve("scenario.xosc");
    Files.writeString(folder.resolve("secret.txt"), "a line that no finding shows");
    String road =
        Files.readString(REAR_END).replaceAll("filepath=\"[^\"]*\"", "filepath=\"secret.txt\"");
    Files.writeString(copy, road);
    assertEquals(
        List.of("`secret.txt` is not named as a scenario or a road map."),
        messages(() -> ScenarioFile.read(copy).resolve(Map.of()), "osc.path").stream()
            .filter(message -> message.contains("secret"))
            .toList());
  }

  private static List<String> messages(Executable reading, String rule) {
    return assertThrows(DiagnosticException.class, reading).diagnostics().stream()
        .filter(each -> each.id().equals(rule))
        .map(Diagnostic::message)
        .toList();
  }

  @Test
  void linksDoNotLeadOutOfTheFolder(@TempDir Path folder) throws IOException {
    Path inside = Files.createDirectory(folder.resolve("inside"));
    Path copy = inside.resolve("scenario.xosc");
    String text = Files.readString(REAR_END).replace("../../roads/", "roads/");
    Files.writeString(copy, text.replace("../../", "").replace("..\\..\\", ""));
    Files.createSymbolicLink(
        inside.resolve("catalogs"), LIBRARY.resolve("catalogs").toAbsolutePath());
    assertEquals("osc.path", firstId(() -> ScenarioFile.read(copy).resolve(Map.of())));
    Files.delete(inside.resolve("catalogs"));
    Files.createSymbolicLink(inside.resolve("catalogs"), folder);
    assertEquals("osc.path", firstId(() -> ScenarioFile.read(copy).resolve(Map.of())));
  }

  /** Contents of version 1.0 are in the form of the latest version. */
  @Test
  void olderVersionsAreBroughtToOneForm() throws IOException {
    Path folder = RESOURCES.resolve("versions");
    ResolvedScenario scenario = ScenarioFile.read(folder.resolve("first.xosc")).resolve(Map.of());
    assertEquals(List.of(), scenario.warnings());
    StringBuilder text = new StringBuilder();
    print(scenario.root().required("Storyboard"), "", text);
    ExpectedFile.check(folder.resolve("first.expected"), text.toString());
  }

  private static void print(ScenarioElement element, String indent, StringBuilder into) {
    into.append(indent).append(element.name());
    new TreeMap<>(element.values())
        .forEach((name, value) -> into.append(" ").append(name).append("=").append(value));
    into.append("\n");
    element.children().forEach(child -> print(child, indent + "  ", into));
  }

  /** A file that something is wrong with gives findings, and never another exception. */
  @Test
  void anyDamageGivesFindings(@TempDir Path folder) throws IOException {
    String whole = Files.readString(REAR_END).replace("../../", "").replace("..\\..\\", "");
    String[] damages = {"\"", "$", "${", "}", "<", ">", "/", "-", "9", "x", "", "&#0;", "INF"};
    Random random = new Random(36);
    Path file = folder.resolve("damaged.xosc");
    int start = whole.indexOf("<OpenSCENARIO>"); // what is in front of it may say another encoding
    int refused = 0;
    for (int i = 0; i < 400; i++) {
      int from = start + random.nextInt(whole.length() - start - 20);
      String damage = damages[random.nextInt(damages.length)];
      int to = from + random.nextInt(20);
      Files.writeString(file, whole.substring(0, from) + damage + whole.substring(to));
      try {
        ScenarioFile.read(file).resolve(Map.of());
      } catch (DiagnosticException e) {
        refused++;
        assertTrue(
            e.diagnostics().stream().allMatch(each -> each.location().line() > 0), e.getMessage());
      }
    }
    assertEquals(400, refused);
  }
}
