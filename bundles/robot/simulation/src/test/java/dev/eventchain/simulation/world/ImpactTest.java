package dev.eventchain.simulation.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests contacts of boxes along the whole way, for any sizes, places and directions. */
class ImpactTest {

  private static final long SECOND = 1_000_000_000L;

  private static Actor actor(
      ActorKind kind, double gap, double across, double headingDegrees, double speed) {
    return sized(kind, kind.size(), gap, across, headingDegrees, speed);
  }

  private static Actor sized(
      ActorKind kind,
      Actor.Size size,
      double gap,
      double across,
      double headingDegrees,
      double speed) {
    return new Actor(
        kind.id(),
        kind,
        size,
        gap,
        StrictMath.toRadians(headingDegrees),
        new SpeedProfile(speed, List.of()),
        new LateralProfile(across, List.of()));
  }

  private static World after(double seconds, double speed, Actor... actors) {
    World world = new World(EgoVehicle.withSpeed(speed), List.of(actors));
    world.advanceTo(World.nanoseconds(seconds));
    return world;
  }

  @ParameterizedTest
  @ValueSource(doubles = {30, 60, 120, 250})
  void nothingIsDrivenThroughHoweverShort(double kmh) {
    Actor.Size post = new Actor.Size(0.01, 0.01, 0, 1);
    Actor standing = sized(ActorKind.PEDESTRIAN, post, 40.123, 0.7, 0, 0);
    World world = after(10, kmh / 3.6, standing);
    assertTrue(world.impacted());
    assertEquals(40.123 / (kmh / 3.6), World.seconds(world.now()), 1e-6);
    assertEquals(kmh / 3.6, world.trace().impactSpeed().orElseThrow(), 1e-6);
    assertEquals("the ego's front hit pedestrian", world.trace().impact());
  }

  @ParameterizedTest
  @CsvSource({"1.79,true", "1.81,false", "-1.79,true", "-1.81,false"})
  void lateralOffsetDecides(double offset, boolean hit) {
    assertEquals(hit, after(5, 20, actor(ActorKind.CAR, 30, offset, 0, 5)).impacted());
  }

  @Test
  void whatHangsHighOrLiesFlatIsNoObstacle() {
    World world =
        after(
            8,
            20,
            actor(ActorKind.BRIDGE, 40, 0, 0, 0),
            actor(ActorKind.OVERHEAD_SIGN, 60, 0, 0, 0),
            actor(ActorKind.STEEL_PLATE, 80, 0, 0, 0));
    assertFalse(world.impacted());
    assertTrue(world.trace().minimalGap().isEmpty());
    Actor.Size low = new Actor.Size(0.3, 6, 1.4, 3);
    assertTrue(after(8, 20, sized(ActorKind.OVERHEAD_SIGN, low, 40, 0, 0, 0)).impacted());
  }

  @Test
  void whoIsHitFromBehindHasHitNobodyAndItIsSaid() {
    World world = after(6, 10, actor(ActorKind.LORRY, -30, 0, 0, 15));
    assertFalse(world.impacted());
    Contact contact = world.trace().fromBehind().get(0);
    assertEquals("lorry hit the ego's rear", contact.words());
    assertEquals(5, contact.speed(), 1e-9);
    // Its nearest end, which is its front or its rear, is at -30 m: the lorry reaches to -18 m.
    assertEquals((30 - 12 - 4.5) / 5, World.seconds(contact.time()), 1e-6);
    assertEquals(60, world.station().along(), 1e-6, "the ego goes on");
    assertEquals(List.of(), world.actors());
  }

  @Test
  void pedestrianIsHitByTheFrontOrRunsIntoTheSide() {
    World front = after(6, 10, actor(ActorKind.PEDESTRIAN, 30, -3, 90, 1));
    assertEquals("the ego's front hit pedestrian", front.trace().impact());
    assertEquals(StrictMath.hypot(10, 1), front.trace().impactSpeed().orElseThrow(), 1e-6);
    World runsIn = after(6, 2, actor(ActorKind.PEDESTRIAN, 1, -3.5, 90, 2));
    assertEquals("pedestrian hit the ego's right side", runsIn.trace().impact());
  }

  @Test
  void comingVehicleIsHitWithBothSpeeds() {
    World world = after(6, 10, actor(ActorKind.CAR, 100, 0.5, 180, 20));
    assertTrue(world.impacted());
    assertEquals(30, world.trace().impactSpeed().orElseThrow(), 1e-6);
    assertEquals(100.0 / 30, World.seconds(world.now()), 1e-6);
    Trace.State start = world.trace().states().get(0);
    assertEquals(30, start.gap() / start.timeToCollision(), 1e-6);
  }

  /** Compares with the geometry of java.awt, evaluated every half a millisecond. */
  @Test
  void impactsAreThoseOfAnotherGeometry() {
    Random random = new Random(12);
    int hits = 0;
    for (int i = 0; i < 60; i++) {
      Actor actor =
          sized(
              ActorKind.CAR,
              new Actor.Size(0.2 + 8 * random.nextDouble(), 0.2 + 3 * random.nextDouble(), 0, 2),
              5 + 30 * random.nextDouble(),
              -8 + 16 * random.nextDouble(),
              -180 + 360 * random.nextDouble(),
              10 * random.nextDouble());
      double speed = 5 + 15 * random.nextDouble();
      double expected = touchedAfter(actor, speed);
      World world = after(4, speed, actor);
      double found =
          world.impacted()
              ? World.seconds(world.now())
              : world.trace().fromBehind().stream()
                  .mapToDouble(contact -> World.seconds(contact.time()))
                  .findFirst()
                  .orElse(4);
      assertEquals(expected, found, 6e-4, "case " + i);
      hits += expected < 4 ? 1 : 0;
    }
    assertTrue(hits > 10 && hits < 50, hits + " hits");
  }

  private static double touchedAfter(Actor actor, double speed) {
    for (int step = 0; step < 8000; step++) {
      double seconds = step * 5e-4;
      Body body = actor.body(Road.straight(), seconds);
      double middle = speed * seconds - Shape.USUAL.length() / 2;
      boolean near = Math.hypot(body.place().x() - middle, body.place().y()) < 9;
      if (near) {
        Area overlap = area(middle, 0, 0, Shape.USUAL.length(), Shape.USUAL.width());
        overlap.intersect(
            area(
                body.place().x(),
                body.place().y(),
                body.place().heading(),
                body.length(),
                body.width()));
        if (!overlap.isEmpty()) {
          return seconds;
        }
      }
    }
    return 4;
  }

  private static Area area(double x, double y, double heading, double length, double width) {
    AffineTransform transform = AffineTransform.getTranslateInstance(x, y);
    transform.rotate(heading);
    return new Area(
        transform.createTransformedShape(
            new Rectangle2D.Double(-length / 2, -width / 2, length, width)));
  }

  @Test
  void cutInIsAheadFromTheMomentOnAtWhichItIsInThePath() {
    Actor cutsIn =
        new Actor(
            "car",
            ActorKind.CAR,
            ActorKind.CAR.size(),
            15,
            0,
            new SpeedProfile(10, List.of()),
            new LateralProfile(3.5, List.of(new LateralProfile.Change(1, 0, 2))));
    World world = new World(EgoVehicle.withSpeed(10), List.of(cutsIn));
    world.advanceTo(SECOND);
    assertTrue(world.trace().minimalGap().isEmpty());
    world.advanceTo(5 * SECOND);
    assertEquals(15, world.trace().end().gap(), 1e-9);
    assertFalse(world.impacted());
    double most = 0;
    for (double time = 1; time < 4; time += 0.01) {
      double change = cutsIn.across(time + 0.005) - cutsIn.across(time - 0.005);
      assertEquals(cutsIn.speedAcross(time), change / 0.01, 0.02, "the rate is that of the place");
      most = Math.max(most, -cutsIn.speedAcross(time));
    }
    assertEquals(2, most, 1e-3);
  }
}
