package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests where a car that does not brake would meet the others in cases of Euro NCAP's suites. */
class ProtocolGeometryTest {

  private static final double WIDTH = 1.8;
  private static final double CLOSE = 0.01;

  /** The time at which they meet in {@code euro-ncap-2023-vru}, in s. */
  private static final double VULNERABLE = 6;

  /** The same for cars that stand or are slower, in {@code euro-ncap-2026-ccr}. */
  private static final double CARS = 5;

  /** The distance of the point that is met from the middle of a pedestrian, backwards, in m. */
  private static final double HIP = 0.06;

  /** The distance of a bicycle's crank from its middle, forwards, in m. */
  private static final double CRANK = 0.015;

  @TempDir Path folder;

  /**
   * Asserts that the car reaches the other one at a time, and where.
   *
   * @param point the point to meet, from the middle of the other one to its front, in m
   * @param across its position left of the car's middle, by the values of a case, in m
   */
  private void assertMet(
      String suite, String part, double time, double point, ToDoubleFunction<CampaignCase> across) {
    for (SuiteCases.Case one : SuiteCases.of(suite, part, folder)) {
      CampaignCase each = one.values();
      Actor other = one.situation().actors().get(0);
      double speed = each.values().get(0).doubleValue() / 3.6;
      String words = one.words();
      assertEquals(speed * time, other.rear(time), CLOSE, words);
      double met = other.across(time) + point * Math.sin(other.direction());
      assertEquals(across.applyAsDouble(each), met, CLOSE, words);
    }
  }

  /** Asserts likewise of a bicyclist, and where it begins, and that nothing hides it. */
  private void assertCrosses(String part, int side, double pace) {
    for (SuiteCases.Case each : SuiteCases.of("euro-ncap-2023-vru", part, folder)) {
      String words = each.words();
      double speed = each.values().values().get(0).doubleValue() / 3.6;
      World world = new World(each.situation(), new Trace(Map.of(), each.situation().road()));
      Actor other = world.actors().get(0);
      assertEquals(side * (VULNERABLE * pace + CRANK), other.across(0), CLOSE, words);
      assertFalse(each.situation().road().isFurnished(), words);
      world.advanceTo(World.nanoseconds(VULNERABLE - 0.01));
      assertTrue(world.trace().impactSpeed().isEmpty(), words);
      world.advanceTo(World.nanoseconds(VULNERABLE + 1));
      assertEquals(
          StrictMath.hypot(speed, pace), world.trace().impactSpeed().orElseThrow(), CLOSE, words);
      double met = other.across(VULNERABLE) - side * CRANK;
      assertEquals(0, met, CLOSE, words);
      assertEquals(VULNERABLE * speed, other.rear(VULNERABLE), CLOSE, words);
    }
  }

  private static double part(CampaignCase each) {
    return WIDTH * (each.values().get(1).doubleValue() - 50) / 100;
  }

  @Test
  void pedestriansAreMetWithThePartOfTheWidthThatTheProtocolSays() {
    // Seen from the right, from where they come.
    assertMet("euro-ncap-2023-vru", "cpna", VULNERABLE, -HIP, ProtocolGeometryTest::part);
    assertMet("euro-ncap-2023-vru", "cpfa", VULNERABLE, -HIP, each -> 0);
    assertMet("euro-ncap-2023-vru", "cpla", VULNERABLE, 0, each -> 0);
  }

  /** They cross a plane, from the right with 15 km/h and from the left with 20 km/h. */
  @Test
  void bicyclistsAreMetInTheMiddle() {
    assertCrosses("cbna", -1, 15 / 3.6);
    assertCrosses("cbfa", 1, 20 / 3.6);
    assertMet("euro-ncap-2023-vru", "cbla", VULNERABLE, 0, each -> 0);
  }

  @Test
  void slowerCarsAreMetWithThePartOfTheWidthThatTheProtocolSays() {
    assertMet("euro-ncap-2026-ccr", "ccrs", CARS, 0, ProtocolGeometryTest::part);
    assertMet("euro-ncap-2026-ccr", "ccrm", CARS, 0, ProtocolGeometryTest::part);
  }
}
