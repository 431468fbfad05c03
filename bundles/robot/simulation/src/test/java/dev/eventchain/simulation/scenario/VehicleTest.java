package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the vehicle of a project, and its size. */
class VehicleTest {

  private static final String SCENE =
      """
      name: passing
      title: Past a post
      duration_s: 5
      ego: {speed_kmh: 36%s}
      furniture:
        - {kind: parked_car, gap_m: 20, lateral_offset_m: %s, length_m: 1, width_m: 1}
      accept: {no_impact: true}
      """;

  @TempDir Path folder;

  private Bench bench(String vehicle) throws Exception {
    Path file = Files.writeString(folder.resolve("bench.yaml"), "extends: carla\n" + vehicle);
    return Bench.read(Optional.of(file), List.of(), MessageCatalog.of(List.of()));
  }

  private static Scenario scenario(String ego, double offset, Bench bench) {
    return Scenario.parse(SourceText.of("s.yaml", SCENE.formatted(ego, offset)), bench);
  }

  @Test
  void whatAScenarioDoesNotSayIsThatOfTheProject() throws Exception {
    Bench bench =
        bench("vehicle: {length_m: 6, width_m: 2.5, brake_delay_s: 0.4, lidar_dropout_percent: 5}");
    EgoVehicle ego = scenario(", width_m: 2", 5, bench).situation().ego();
    assertEquals(new Shape(6, 2, 1.5, 0.9), ego.shape());
    assertEquals(0.4, ego.brakeDelay());
    assertEquals(0.05, ego.lidar().dropout());
    assertEquals(10, ego.speed());
    assertEquals(EgoVehicle.withSpeed(0), Bench.carla().vehicle());
  }

  /** The post begins 0.5 m beside its middle, the vehicle 1 m beside its own. */
  @ParameterizedTest
  @CsvSource({"1.8, 1.45, false", "2, 1.45, true", "2, 1.55, false"})
  void widthDecidesWhatItHits(double width, double offset, boolean hits) {
    Scenario scenario = scenario(", width_m: " + width, offset, Bench.carla());
    World world = new World(scenario.situation(), new Trace());
    world.advanceTo(World.nanoseconds(5));
    assertEquals(hits, world.impacted());
  }

  @Test
  void aLongVehiclePassesLater() {
    Scenario scenario = scenario(", length_m: 12, wheelbase_m: 7", 5, Bench.carla());
    World world = new World(scenario.situation(), new Trace());
    world.advanceTo(World.nanoseconds(2.5));
    // Its front is 4 m beyond the post, its rear 8 m before it.
    assertEquals(12, world.ego().body().length());
    assertEquals(25 - 6, world.ego().body().place().x(), 0.2);
  }

  /** 10 m/s, and 5 m/s2 from 0.2 s on: 0.5 m/s less in each step, all of it at its start. */
  @Test
  void aSpeedMayChangeInSteps() {
    String steps = ", speed_step_s: 0.1, brake_delay_s: 0, brake_build_up_s: 0";
    World world = new World(scenario(steps, 5, Bench.carla()).situation(), new Trace());
    world.advanceTo(World.nanoseconds(0.2));
    world.command(world.now(), VehicleCommand.brake(5.0 / 9.0));
    world.advanceTo(World.nanoseconds(0.25));
    assertEquals(9.5, world.egoSpeed(), 1e-9);
    world.command(world.now(), VehicleCommand.brake(1));
    world.advanceTo(World.nanoseconds(0.3));
    assertEquals(9.5, world.egoSpeed(), 1e-9);
    assertEquals(2 + 0.95, world.station().along(), 1e-9);
    world.advanceTo(World.nanoseconds(0.4));
    assertEquals(9.5 - 0.9, world.egoSpeed(), 1e-9);
    assertEquals(2 + 0.95 + 0.86, world.station().along(), 1e-9);
    assertEquals(9, world.trace().end().deceleration(), 1e-9);
    world.advanceTo(World.nanoseconds(3));
    assertEquals(0, world.egoSpeed());
    assertEquals(0, world.trace().end().deceleration());
  }

  /** A build-up of 0.3 s up to 9 m/s2 is 3 m/s2 more in each step. */
  @Test
  void aBuildUpHoldsInStepsAsWell() {
    String steps = ", speed_step_s: 0.1, brake_delay_s: 0";
    World world = new World(scenario(steps, 5, Bench.carla()).situation(), new Trace());
    world.command(world.now(), VehicleCommand.brake(1));
    world.advanceTo(World.nanoseconds(0.4));
    assertEquals(10 - 0.3 - 0.6 - 0.9 - 0.9, world.egoSpeed(), 1e-9);
  }

  @Test
  void aStepIsNotTooShort() {
    assertThrows(
        DiagnosticException.class, () -> scenario(", speed_step_s: 0.001", 5, Bench.carla()));
    assertEquals(0, scenario(", speed_step_s: 0", 5, Bench.carla()).situation().ego().speedStep());
  }

  @Test
  void aVehicleThatNoYawRateDrivesDoesNotTurnOnTheSpot() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> scenario(", maximal_yaw_rate_radps: 1.5", 5, Bench.carla()));
    assertTrue(refused.getMessage().contains("no field of the bench drives its yaw_rate"));
    assertEquals(
        0,
        scenario(", maximal_yaw_rate_radps: 0", 5, Bench.carla())
            .situation()
            .ego()
            .chassis()
            .maximalYawRate());
  }

  /** A commanded speed is followed continuously, so that steps would have no effect. */
  @Test
  void aCommandedSpeedHasNoSteps() {
    String robot =
        """
        vehicle: {maximal_acceleration_mps2: 0.5, maximal_deceleration_mps2: 1, command_timeout_s: 0}
        consumes:
          /cmd_vel: {type: geometry_msgs/msg/Twist, fields: {linear.x: {drives: speed, unit: m/s}}}
        """;
    Bench bench =
        Bench.parse(SourceText.of("bench.yaml", robot), List.of(), MessageCatalog.of(List.of()));
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> scenario(", speed_step_s: 0.1", 5, bench));
    assertTrue(refused.getMessage().contains("which the vehicle follows continuously"));
    assertEquals(0, scenario(", speed_step_s: 0", 5, bench).situation().ego().speedStep());
  }

  @Test
  void aVehicleIsLongerThanItsWheelbase() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class, () -> scenario(", wheelbase_m: 4", 5, Bench.carla()));
    assertTrue(refused.getMessage().contains("s.yaml:4:35"), refused.getMessage());
    assertTrue(refused.getMessage().contains("longer than it is"), refused.getMessage());
  }

  @Test
  void bothSchemasDescribeTheSameVehicle() throws Exception {
    JsonNode scenario = new ObjectMapper().readTree(Scenario.schema()).at("/properties/ego");
    ObjectNode ego = (ObjectNode) scenario.path("properties");
    ego.remove(
        List.of("speed_kmh", "lateral_offset_m", "heading_deg", "driver_steers", "maneuvers"));
    JsonNode bench = new ObjectMapper().readTree(Bench.schema()).at("/properties/vehicle");
    assertEquals(bench.path("properties"), ego);
  }
}
