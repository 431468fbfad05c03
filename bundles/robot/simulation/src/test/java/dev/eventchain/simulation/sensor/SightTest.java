package dev.eventchain.simulation.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which boxes hide others. */
class SightTest {

  private static final Road.Place EYE = new Road.Place(0, 0, 0);
  private static final double HEIGHT = 0.5;

  /** Tolerance in rad; nothing visible in the test is narrower. */
  private static final double BESIDE = 1e-9;

  private static Body box(double x, double y, double length, double width, double headingDegrees) {
    Road.Place place = new Road.Place(x, y, StrictMath.toRadians(headingDegrees));
    return new Body(place, length, width, 0.0, 1.5, 1f);
  }

  private static Body standing(ActorKind kind, double x, double y) {
    Actor.Size size = kind.size();
    Road.Place place = new Road.Place(x, y, 0);
    return new Body(place, size.length(), size.width(), size.bottom(), size.top(), 1f);
  }

  private static boolean hidden(Body body, Body... others) {
    List<Sight> sights = Arrays.stream(others).map(each -> Sight.of(each, EYE)).toList();
    return Sight.of(body, EYE).isHidden(sights, HEIGHT);
  }

  @ParameterizedTest
  @CsvSource({
    "CAR, CAR, true",
    "LORRY, CAR, true",
    "CAR, PEDESTRIAN, false",
    "CAR, LORRY, false",
    "GUARD_RAIL, CAR, false",
    "STEEL_PLATE, CAR, false",
    "BRIDGE, CAR, false",
    "OVERHEAD_SIGN, LORRY, false",
  })
  void onlyWhatIsNotLowerAndStandsOnTheRoadHides(ActorKind before, ActorKind behind, boolean is) {
    assertEquals(is, hidden(standing(behind, 70, 0), standing(before, 30, 0)));
    assertTrue(!hidden(standing(before, 30, 0), standing(behind, 70, 0)), "it is nearer");
  }

  @Test
  void onlyTheWholeOfItIsHidden() {
    Body far = box(60, 0, 4.5, 1.8, 0);
    assertTrue(!hidden(far));
    assertTrue(hidden(far, box(30, 0, 4.5, 1.8, 0)));
    assertTrue(!hidden(far, box(30, 0.6, 4.5, 1.8, 0)), "its right side is seen");
    assertTrue(!hidden(far, box(30, 3.5, 4.5, 1.8, 0)), "it is in another lane");
  }

  @Test
  void severalHideTogetherUnlessThereIsAGapBetweenThem() {
    Body far = box(60, 0, 4.5, 1.8, 0);
    assertTrue(hidden(far, box(30, 0.9, 4.5, 1.8, 0), box(34, -0.7, 0.5, 1.6, 0)));
    assertTrue(!hidden(far, box(30, 1.1, 4.5, 1.8, 0), box(30, -1.1, 4.5, 1.8, 0)));
  }

  @Test
  void longOneBesideTheEgoIsBeforeWhatIsBehindItHoweverFarItReaches() {
    Body rail = box(20, 3, 60, 0.3, 0);
    assertTrue(hidden(box(30, 6, 4.5, 1.8, 0), rail));
    assertTrue(!hidden(box(10, 0, 4.5, 1.8, 0), rail));
    assertTrue(!hidden(box(40, 0, 4.5, 1.8, 0), box(-10, 0, 4.5, 30, 0)), "it is behind the eye");
  }

  /** Compares with single lines of sight as an independent method. */
  @Test
  void isHiddenWhereNoLineOfSightGetsThere() {
    Random random = new Random(7);
    int found = 0;
    for (int i = 0; i < 300; i++) {
      List<Body> boxes = apart(random);
      for (Body body : boxes) {
        Body[] others = boxes.stream().filter(each -> !each.equals(body)).toArray(Body[]::new);
        boolean seen = seen(body, others);
        assertEquals(!seen, hidden(body, others), () -> body + " behind " + boxes);
        found += seen ? 0 : 1;
      }
    }
    assertTrue(found > 100, found + " are hidden");
  }

  private static List<Body> apart(Random random) {
    List<Body> boxes = new ArrayList<>();
    while (boxes.size() < 6) {
      double x = 4 + 30 * random.nextDouble();
      double y = -10 + 20 * random.nextDouble();
      double length = 0.5 + 5 * random.nextDouble();
      Body next = box(x, y, length, 0.5 + 2 * random.nextDouble(), 360 * random.nextDouble());
      if (boxes.stream().allMatch(each -> each.separation(next) > 0.0)) {
        boxes.add(next);
      }
    }
    return boxes;
  }

  /**
   * Returns whether a body is visible; lines beside all corners decide, since visible parts end at
   * corners.
   */
  private static boolean seen(Body body, Body... others) {
    return Stream.concat(Stream.of(body), Arrays.stream(others))
        .flatMapToDouble(SightTest::besideCorners)
        .anyMatch(
            direction -> {
              double distance = distance(body, direction);
              return Double.isFinite(distance)
                  && Arrays.stream(others).allMatch(each -> distance(each, direction) > distance);
            });
  }

  private static DoubleStream besideCorners(Body body) {
    return IntStream.range(0, 4)
        .mapToObj(index -> corner(body, index))
        .mapToDouble(at -> Math.atan2(at[1], at[0]))
        .flatMap(direction -> DoubleStream.of(direction - BESIDE, direction + BESIDE));
  }

  /** Returns the distance to the nearest of the four sides that a ray crosses. */
  private static double distance(Body body, double direction) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int side = 0; side < 4; side++) {
      double[] from = corner(body, side);
      double[] to = corner(body, (side + 1) % 4);
      double dx = Math.cos(direction);
      double dy = Math.sin(direction);
      double one = dx * from[1] - dy * from[0];
      double other = dx * to[1] - dy * to[0];
      if (one * other < 0) {
        double part = one / (one - other);
        double x = from[0] + part * (to[0] - from[0]);
        double y = from[1] + part * (to[1] - from[1]);
        double along = x * dx + y * dy;
        nearest = along > 0 ? Math.min(nearest, along) : nearest;
      }
    }
    return nearest;
  }

  private static double[] corner(Body body, int index) {
    double along = (index == 0 || index == 3 ? 1 : -1) * body.length() / 2;
    double aside = (index < 2 ? 1 : -1) * body.width() / 2;
    double cos = Math.cos(body.place().heading());
    double sin = Math.sin(body.place().heading());
    return new double[] {
      body.place().x() + along * cos - aside * sin, body.place().y() + along * sin + aside * cos
    };
  }
}
