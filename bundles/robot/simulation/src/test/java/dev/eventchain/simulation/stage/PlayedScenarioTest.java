package dev.eventchain.simulation.stage;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests scenarios whose situation is a file in OpenSCENARIO XML. */
class PlayedScenarioTest {

  private static final Path FOLDER = Path.of("src/test/resources/openscenario");
  private static final double KMH = 1 / 3.6;

  /** From the reference point of the tested car to its front, and of the target to its rear. */
  private static final double FRONT = 1.4 + 4.4 / 2;

  private static final double REAR = 1.3 - 4.0 / 2;

  private static String scenario(String file, String more) {
    return """
        name: rear-end
        title: A car ahead
        openscenario:
          file: %s
        %s
        accept:
          no_impact: true
        """
        .formatted(file, more);
  }

  private static SourceText text(String file, String more) {
    return SourceText.of(FOLDER.resolve("scenario.yaml").toString(), scenario(file, more));
  }

  private static Scenario read(String more) {
    return Scenario.parse(text("rear-end.xosc", more), Bench.carla());
  }

  private static World world(Scenario scenario) {
    Situation situation = scenario.situation();
    return new World(situation, new Trace(Map.of(), situation.road()));
  }

  private static void drive(World world, double seconds) {
    world.advanceTo(world.now() + World.nanoseconds(seconds));
  }

  @Test
  void gapsAndImpactsAreThoseOfTheFile() {
    List<Scenario> cases =
        Scenario.readFiles(
            List.of(FOLDER.resolve("rear-end-cases.xosc")),
            List.of("no_impact"),
            Bench.carla(),
            warning -> fail(warning.message()));
    assertEquals(6, cases.size());
    int index = 0;
    for (double speed : new double[] {30, 50, 70}) {
      for (double target : new double[] {0, 20}) {
        Scenario each = cases.get(index++);
        double gap = 5 * speed * KMH - FRONT + REAR;
        World world = world(each);
        assertEquals(gap, world.moment().end().gap(), 1e-9, each.title());
        drive(world, 60);
        double closing = (speed - target) * KMH;
        assertEquals(closing, world.trace().impactSpeed().getAsDouble(), 1e-6, each.title());
        assertEquals(gap / closing, World.seconds(world.now()), 1e-6, each.title());
      }
    }
  }

  @Test
  void casesAreNamedByNumberAndSayWhatDiffers() {
    Scenario third =
        Scenario.readFiles(
                List.of(FOLDER.resolve("rear-end-cases.xosc")),
                List.of("no_impact"),
                Bench.carla(),
                warning -> fail(warning.message()))
            .get(2);
    assertEquals("rear-end-cases-3", third.name());
    assertEquals("rear-end-cases (speed_kph = 50, target_kph = 0)", third.title());
  }

  @Test
  void oneOfSeveralCasesIsNotTakenForAll() {
    assertEquals(
        List.of(
            "scenario.value.range 1: Its OpenSCENARIO file has 6 cases, and one is needed here."),
        problems("rear-end-cases.xosc", ""));
  }

  @Test
  void aStoryboardThatIsNotStoppedIsNoEvidence() {
    World world = world(read("  parameters: {speed_kph: 18, target_kph: 18}"));
    drive(world, 299.98);
    assertEquals(List.of(), world.trace().neverBegun());
    drive(world, 0.02);
    assertEquals(List.of("what stops the storyboard of rear-end.xosc"), world.trace().neverBegun());
  }

  @Test
  void theWorldLiesAlongTheLaneOfTheEgo() {
    Scenario scenario = read("");
    World world = world(scenario);
    assertEquals(0, world.ego().front().x(), 1e-9);
    assertEquals(0, world.ego().front().y(), 1e-9);
    assertEquals(0, world.ego().front().heading(), 1e-9);
    assertEquals(3.5, scenario.situation().road().laneWidth(10), 1e-9);
    Actor target = world.actors().get(0);
    assertEquals("Target", target.name());
    assertEquals(0, target.across(0), 1e-9);
    assertEquals(1.4, target.size().top(), 1e-9);
    Actor kiosk = world.actors().get(1);
    assertEquals(260 - 100 - FRONT, kiosk.along(0), 1e-9, "objects of the map stand there");
    assertEquals(9 + 1.75, kiosk.across(0), 1e-9);
    assertEquals(2.5, kiosk.size().top(), 1e-9);
    EgoVehicle ego = scenario.situation().ego();
    assertEquals(4.4, ego.shape().length());
    assertEquals(2.6, ego.chassis().wheelbase());
    assertEquals(FRONT, ego.chassis().wheelbase() + ego.shape().frontOverhang(), 1e-9);
  }

  @Test
  void parametersTakeTheirValuesFromTheScenario() {
    Scenario scenario =
        Scenario.parse(
            text("rear-end.xosc", "  parameters: {speed_kph: 36, headway: 3, aside: 1.5}"),
            Bench.carla());
    World world = world(scenario);
    assertEquals(10, world.egoSpeed(), 1e-12);
    assertEquals(1.5, world.actors().get(0).across(0), 1e-9);
    assertEquals(30 - FRONT + REAR, world.moment().end().gap(), 1e-9);
  }

  @Test
  void brakingSoftwareWinsAndTheStoryboardEndsTheRun() {
    World world = world(read(""));
    drive(world, 1);
    assertEquals(50 * KMH, world.egoSpeed(), 1e-9);
    world.command(world.now(), VehicleCommand.brake(1.0));
    drive(world, 60);
    assertTrue(world.trace().impactSpeed().isEmpty());
    assertEquals(0, world.egoSpeed());
    assertTrue(world.isOver());
    // At rest for 0.1 s, and that for 1 s.
    double stopped =
        world.trace().states().stream()
            .filter(state -> state.speed() == 0)
            .mapToDouble(state -> World.seconds(state.time()))
            .findFirst()
            .orElseThrow();
    assertEquals(stopped + 1.1, World.seconds(world.now()), 0.0101);
  }

  @Test
  void eventsAreQuantitiesOfFormulas() {
    String parameters = "  parameters: {speed_kph: 36, target_kph: 36, headway: 4, brakes_at: 1}";
    String accept =
        """
          formulas:
            - {formula: "eventually[0, 3] event('target brakes').started"}
            - {formula: "always[0, 0.98] not event('target brakes').started"}
            - {formula: "eventually[0, 4] event('target brakes').ended"}
            - {formula: "always[0, 3] not event('target brakes').ended"}
        """;
    Scenario scenario =
        Scenario.parse(
            SourceText.of(
                FOLDER.resolve("scenario.yaml").toString(),
                scenario("rear-end.xosc", parameters) + accept),
            Bench.carla());
    World world = world(scenario);
    drive(world, 5);
    // 10 m/s, less 4 m/s each second from 1 s on.
    Actor target = world.actors().get(0);
    assertEquals(10, target.speedAlong(1), 1e-9);
    assertEquals(2, target.speedAlong(3), 1e-9);
    assertEquals(0, target.speedAlong(3.6), 1e-9);
    double gap = 40 - FRONT + REAR - (2.5 * 10 - 10 * 10 / (2 * 4.0)) - 10 * (4 - 3.5);
    assertEquals(gap, world.trace().stateAt(World.nanoseconds(4)).gap(), 1e-6);
    List<String> wrong =
        scenario.criteria().stream()
            .filter(criterion -> criterion.text().contains("event("))
            .filter(criterion -> !criterion.judge(world.trace()).passed())
            .map(Expectation::text)
            .toList();
    assertEquals(List.of(), wrong);
  }

  /** The target is faster, so that the storyboard ends after a second, before its event begins. */
  @Test
  void anEventThatNeverBeganDoesNotEnd() {
    World world = world(read("  parameters: {speed_kph: 36, target_kph: 37, brakes_at: 9}"));
    drive(world, 2);
    assertEquals(1, World.seconds(world.now()), 0.0101);
    assertEquals(List.of(), world.trace().happenings());
  }

  @Test
  void twoRunsOfOneScenarioAreTheSame() {
    Scenario scenario = read("");
    World first = world(scenario);
    drive(first, 2);
    World second = world(scenario);
    drive(second, 2);
    assertEquals(first.trace().states(), second.trace().states());
    assertEquals(first.now(), second.now());
  }

  private static List<String> problems(String file, String more) {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class, () -> Scenario.parse(text(file, more), Bench.carla()));
    return refused.diagnostics().stream()
        .map(each -> each.id() + " " + each.location().line() + ": " + each.message())
        .toList();
  }

  @Test
  void theEgoIsNamedOrKnown() {
    assertEquals(
        List.of("scenario.ego.unknown 4: There is no entity 'ego1'."),
        problems("rear-end.xosc", "  ego: ego1"));
    Scenario other = Scenario.parse(text("rear-end.xosc", "  ego: Target"), Bench.carla());
    assertEquals(
        List.of("Ego", "kiosk"), other.situation().actors().stream().map(Actor::name).toList());
  }

  @Test
  void whatTheFileHasIsNotSaidTwice() {
    assertEquals(
        List.of("scenario.key.unknown 5: 'actors' is that of the OpenSCENARIO file."),
        problems("rear-end.xosc", "actors: []"));
    assertTrue(
        problems("rear-end.xosc", "ego: {speed_kmh: 30}")
            .get(0)
            .startsWith("scenario.key.unknown"));
  }

  @Test
  void theEgoIsNotPutElsewhereWhileItDrives(@TempDir Path folder) throws IOException {
    String text = Files.readString(FOLDER.resolve("rear-end.xosc"));
    String action =
        text.substring(
            text.indexOf("<LongitudinalAction>", text.indexOf("name=\"slower\"")),
            text.indexOf("</PrivateAction>", text.indexOf("name=\"slower\"")));
    String jump =
        "<TeleportAction><Position><LanePosition roadId=\"1\" laneId=\"-1\" s=\"300\"/></Position></TeleportAction>";
    Path file = beside(folder, jumping(text, action, jump));
    Scenario scenario =
        Scenario.readFiles(List.of(file), List.of("no_impact"), Bench.carla(), warning -> fail())
            .get(0);
    World world = world(scenario);
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> drive(world, 5));
    assertEquals("scenario.ego.moved", refused.diagnostics().get(0).id());
    assertTrue(refused.getMessage().contains("After 1.00 s"), refused.getMessage());
  }

  /** Writes a scenario beside copies of all that it leads to. */
  private static Path beside(Path folder, String scenario) throws IOException {
    Files.createDirectory(folder.resolve("catalogs"));
    Files.copy(FOLDER.resolve("straight.xodr"), folder.resolve("straight.xodr"));
    Files.copy(FOLDER.resolve("catalogs/vehicles.xosc"), folder.resolve("catalogs/vehicles.xosc"));
    return Files.writeString(folder.resolve("other.xosc"), scenario);
  }

  /** A project may describe its vehicle otherwise than the scenario, which then meets that one. */
  @Test
  void collisionsAreThoseOfTheVehicleAsItIs(@TempDir Path folder) throws IOException {
    String text = Files.readString(FOLDER.resolve("rear-end.xosc"));
    String collision = "<CollisionCondition><EntityRef entityRef=\"Target\"/></CollisionCondition>";
    beside(folder, text.replaceFirst("<StandStillCondition [^>]*>", collision));
    String passing = scenario("other.xosc", "  parameters: {aside: 1.6}\nego: {width_m: %s}");
    for (String width : List.of("1.2", "1.8")) {
      String name = folder.resolve("scenario.yaml").toString();
      World world =
          world(Scenario.parse(SourceText.of(name, passing.formatted(width)), Bench.carla()));
      drive(world, 8);
      assertEquals(width.equals("1.8"), world.isOver(), width);
    }
  }

  private static String jumping(String text, String action, String jump) {
    return text.replace(action, jump)
        .replace(
            "name=\"brakes_at\" parameterType=\"double\" value=\"1000\"",
            "name=\"brakes_at\" parameterType=\"double\" value=\"1\"")
        .replace(
            "<Actors selectTriggeringEntities=\"false\">\n            <EntityRef entityRef=\"Target\"/>",
            "<Actors selectTriggeringEntities=\"false\">\n            <EntityRef entityRef=\"Ego\"/>");
  }

  /** The target is 100 m along a route that leads back on the other side of the road. */
  @Test
  void positionsOnRoutesAreOnTheSideThatTheScenarioSays(@TempDir Path folder) throws IOException {
    Files.createDirectory(folder.resolve("catalogs"));
    for (String each : List.of("straight.xodr", "catalogs/vehicles.xosc")) {
      Files.copy(FOLDER.resolve(each), folder.resolve(each));
    }
    String waypoint =
        "<Waypoint routeStrategy='shortest'><Position><LanePosition roadId='1' laneId='1'"
            + " s='%d'/></Position></Waypoint>";
    String position =
        "<RoutePosition><RouteRef><Route name='back' closed='false'>"
            + waypoint.formatted(400)
            + waypoint.formatted(50)
            + "</Route></RouteRef><InRoutePosition><FromLaneCoordinates pathS='100' laneId='1'/>"
            + "</InRoutePosition></RoutePosition>";
    Files.writeString(
        folder.resolve("back.xosc"),
        Files.readString(FOLDER.resolve("rear-end.xosc"))
            .replaceFirst("<RelativeLanePosition [^>]*/>", Matcher.quoteReplacement(position)));
    assertEquals("0.0 [storyboard.route.side]", targetOnRoute(folder, ""));
    assertEquals("0.0 []", targetOnRoute(folder, "  route_positions: route"));
    assertEquals("3.5 []", targetOnRoute(folder, "  route_positions: road"));
    assertEquals(
        List.of(
            "scenario.value.type 5: 'route_positions' must be `road` or `route`, not a string \"left\"."),
        problems("rear-end.xosc", "  route_positions: left"));
  }

  /** Returns how far the target is to the left of the ego's lane, and the warnings. */
  private static String targetOnRoute(Path folder, String setting) throws IOException {
    Path file = folder.resolve("scenario.yaml");
    Files.writeString(file, scenario("back.xosc", setting));
    List<String> warnings = new ArrayList<>();
    Scenario scenario =
        Scenario.readFiles(List.of(file), List.of(), Bench.carla(), each -> warnings.add(each.id()))
            .get(0);
    double across = world(scenario).actors().get(0).across(0);
    return Math.round(across * 1e6) / 1e6 + " " + warnings;
  }

  @Test
  void valuesAreThoseThatTheFileAllows() {
    List<String> wrong = problems("rear-end.xosc", "  parameters: {headway: 1}");
    assertEquals(1, wrong.size());
    assertTrue(wrong.get(0).startsWith("osc."), wrong.get(0));
    assertFalse(problems("rear-end.xosc", "  parameters: {headwy: 3}").isEmpty());
    assertFalse(problems("missing.xosc", "").isEmpty());
  }
}
