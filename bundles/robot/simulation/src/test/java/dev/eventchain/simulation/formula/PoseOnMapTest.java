package dev.eventchain.simulation.formula;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Trace;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The pose on the map, as a localization or CARLA's bridge gives it, in a full circle of 50 m. */
class PoseOnMapTest {

  private static final double RADIUS = 50;
  private static final double ROUND = 2 * Math.PI * RADIUS;

  /** Returns a drive at 15 m/s through the quarters of a circle, 1 m left of the lane's centre. */
  private static Trace circle() {
    Trace trace = new Trace(Map.of(), Road.bend(1 / RADIUS, 3.75));
    double yawRate = 15 / (RADIUS - 1);
    for (int quarter = 0; quarter <= 4; quarter++) {
      trace.state(
          new Trace.State(
              quarter,
              15,
              Double.POSITIVE_INFINITY,
              Double.POSITIVE_INFINITY,
              2,
              quarter * ROUND / 4,
              Double.NaN,
              new Trace.Pose(1, 0.1, yawRate)));
    }
    return trace;
  }

  private static double[] values(String signal, Trace trace) {
    return new WorldSignals().find(signal).orElseThrow().samples().apply(trace);
  }

  @Test
  void aCircleLeadsBackToItsStart() {
    Trace circle = circle();
    assertArrayEquals(new double[] {0, 49, 0, -49, 0}, values("ego.x", circle), 1e-9);
    assertArrayEquals(new double[] {1, 50, 99, 50, 1}, values("ego.y", circle), 1e-9);
    double half = Math.PI / 2;
    double[] yaw = {0.1, half + 0.1, 0.1 - Math.PI, 0.1 - half, 0.1};
    assertArrayEquals(yaw, values("ego.yaw", circle), 1e-9);
    double[] z = values("ego.orientation.z", circle);
    double[] w = values("ego.orientation.w", circle);
    for (int i = 0; i < yaw.length; i++) {
      assertEquals(Math.sin(yaw[i]), 2 * z[i] * w[i], 1e-9);
      assertEquals(Math.cos(yaw[i]), 1 - 2 * z[i] * z[i], 1e-9);
    }
  }

  /** Braking with 2 m/s2 and turning to the left, the acceleration is against both. */
  @Test
  void theAccelerationHasThatOfTurning() {
    Trace circle = circle();
    double aside = 15 * 15 / (RADIUS - 1);
    double[] x = values("ego.acceleration.x", circle);
    double[] y = values("ego.acceleration.y", circle);
    double[] yaw = values("ego.yaw", circle);
    for (int i = 0; i < x.length; i++) {
      double forward = x[i] * Math.cos(yaw[i]) + y[i] * Math.sin(yaw[i]);
      double left = y[i] * Math.cos(yaw[i]) - x[i] * Math.sin(yaw[i]);
      assertEquals(-2, forward, 1e-9);
      assertEquals(aside, left, 1e-9);
    }
  }

  /** An inertial sensor is fixed to the vehicle, wherever the road leads. */
  @Test
  void theVehicleFeelsTurningAcrossItsAxis() {
    double aside = 15 * 15 / (RADIUS - 1);
    double[] expected = {aside, aside, aside, aside, aside};
    assertArrayEquals(expected, values("ego.acceleration.left", circle()), 1e-9);
  }

  /**
   * 6,378,137 m of radius: 49 m to the east are 49 / 111,319.49 degrees, and so are some to the
   * north.
   */
  @Test
  void metresOnTheMapAreDegreesOnTheEarth() {
    double degree = 111_319.490793;
    Trace circle = circle();
    double[] east = values("ego.longitude", circle);
    double[] north = values("ego.latitude", circle);
    assertArrayEquals(new double[] {0, 49 / degree, 0, -49 / degree, 0}, east, 1e-12);
    assertArrayEquals(
        new double[] {1 / degree, 50 / degree, 99 / degree, 50 / degree, 1 / degree}, north, 1e-12);
  }
}
