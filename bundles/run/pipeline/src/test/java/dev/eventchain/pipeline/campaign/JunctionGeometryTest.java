package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests where cars that do not brake meet in the cases of {@code euro-ncap-2026-junction}. */
class JunctionGeometryTest {

  private static final String SUITE = "euro-ncap-2026-junction";

  /** The time at which they meet, in s. */
  private static final double TIME = 8;

  private static final double WIDTH = 1.712;
  private static final double LENGTH = 4.023;

  /** From the rear axle of the tested car to its front, in m. */
  private static final double FRONT = 1.349 + 4.358 / 2;

  @TempDir Path folder;

  private static World world(SuiteCases.Case each) {
    return new World(each.situation(), new Trace(Map.of(), each.situation().road()));
  }

  private static double speed(SuiteCases.Case each, int factor) {
    return each.values().values().get(factor).doubleValue() / 3.6;
  }

  @Test
  void carsThatCrossAreMetAQuarterOfTheirLengthBehindTheirFront() {
    for (SuiteCases.Case each : SuiteCases.of(SUITE, "cccscp", folder)) {
      double side = each.values().values().get(0).doubleValue();
      World world = world(each);
      Actor crossing = world.actors().get(0);
      assertEquals("Crossing", crossing.name());
      world.advanceTo(World.nanoseconds(TIME + 1));
      assertEquals(TIME, World.seconds(world.now()), 0.01, each.words());
      assertEquals(
          StrictMath.hypot(speed(each, 1), speed(each, 2)),
          world.trace().impactSpeed().orElseThrow(),
          0.01,
          each.words());
      assertEquals(side * LENGTH / 4, crossing.across(TIME), 0.02, each.words());
    }
  }

  @Test
  void carsAreParkedBesideTheLaneOnTheSideFromWhichTheOtherOneComes() {
    for (SuiteCases.Case each : SuiteCases.of(SUITE, "cccscp", folder)) {
      double side = each.values().values().get(0).doubleValue();
      World world = world(each);
      List<Actor> parked = world.actors().subList(1, 4);
      double line = TIME * speed(each, 1) + WIDTH / 2;
      double front = line - (side > 0 ? 21 : 24);
      for (Actor car : parked) {
        double edge = Math.abs(car.across(0)) - car.size().width() / 2;
        assertEquals(side > 0 ? 5.5 : 2, edge, 1e-6, each.words());
        assertEquals(side, Math.signum(car.across(0)), each.words());
        assertEquals(front, car.rear(0) + car.size().length(), 1e-6, each.words());
        front = car.rear(0) - 1;
      }
    }
  }

  /** The path is integrated here from the table of radii and angles. */
  @Test
  void oncomingCarsAreMetWhereThePathCrossesTheirs() {
    for (SuiteCases.Case each : SuiteCases.of(SUITE, "ccftap", folder)) {
      double kmh = each.values().values().get(0).doubleValue();
      double radius = kmh == 10 ? 9 : kmh == 15 ? 11.75 : 14.75;
      double alpha = StrictMath.toRadians(kmh == 10 ? 20.62 : kmh == 15 ? 20.93 : 21.79);
      double spiral = 2 * alpha / (1 / 1500.0 + 1 / radius);
      double step = 1e-4;
      double x = 0;
      double y = 0;
      double heading = 0;
      double way = 0;
      while (y < 3.5) {
        double part = Math.min(1, way / spiral);
        heading += step * (1 / 1500.0 + part * (1 / radius - 1 / 1500.0));
        x += step * StrictMath.cos(heading);
        y += step * StrictMath.sin(heading);
        way += step;
      }
      World world = world(each);
      world.advanceTo(World.nanoseconds(TIME));
      double driven = TIME * speed(each, 0) + FRONT + StrictMath.sqrt(2) * WIDTH / 2;
      Actor oncoming = world.actors().get(0);
      // The world begins at the front bumper, the way at the rear axle.
      assertEquals(driven - way + x - FRONT, oncoming.rear(TIME), 0.01, each.words());
      assertEquals(3.5, oncoming.across(TIME), 1e-6, each.words());
      assertTrue(world.trace().impactSpeed().isEmpty(), each.words());
      world.advanceTo(World.nanoseconds(TIME + 1));
      assertTrue(world.trace().impactSpeed().isPresent(), each.words());
    }
  }
}
