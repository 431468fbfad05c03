package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests which cases the suite of UN R157 takes for preventable against the driver of the
 * regulation, driven in small steps.
 */
class CarefulDriverTest {

  private static final double STEP = 0.0005;
  private static final double LENGTH = 4.3;
  private static final double WIDTH = 1.9;
  private static final double LANE = 3.5;

  @TempDir Path folder;

  /** Outcome of a cut-in for the driver. */
  private enum End {
    AVOIDED,
    HIT,
    /** The ego was beside the other one, or past it, when that came into its way. */
    BESIDE
  }

  /** The driver, who brakes a while after something became critical that was perceived before. */
  private static final class Driver {
    private double speed;
    private double perceivedAt = Double.NaN;
    private double criticalAt = Double.NaN;
    private double braking;

    Driver(double speed) {
      this.speed = speed;
    }

    /** Drives a step; returns the way. */
    double step(double time, boolean isSeen, boolean isCritical) {
      perceivedAt = Double.isNaN(perceivedAt) && isSeen ? time + 0.4 : perceivedAt;
      criticalAt =
          Double.isNaN(criticalAt) && time >= perceivedAt && isCritical ? time : criticalAt;
      if (time >= criticalAt + 0.75) {
        braking = Math.min(0.774 * 9.81, braking + 12.65 * STEP);
      }
      speed = Math.max(0, speed - braking * STEP);
      return speed * STEP;
    }
  }

  private static End cutIn(double speed, double other, double aside, double distance) {
    double gap = distance;
    Driver ego = new Driver(speed / 3.6);
    double ahead = other / 3.6;
    double across = LANE;
    double lateral = 0;
    for (double time = 0; time < 30; time += STEP) {
      lateral = across > 0 ? Math.min(aside, lateral + 2 * STEP) : 0;
      across = Math.max(0, across - lateral * STEP);
      boolean isCritical = ego.speed > ahead && gap <= 2 * (ego.speed - ahead);
      gap += ahead * STEP - ego.step(time, LANE - across >= 0.375, isCritical);
      if (across < WIDTH && gap < 0) {
        return gap > -LENGTH / 10 ? End.HIT : End.BESIDE;
      }
    }
    return End.AVOIDED;
  }

  /** The one ahead leaves the lane 1 m before another one that stands there. */
  private static End cutOut(double speed, double aside, double headway) {
    double other = speed / 3.6;
    Driver ego = new Driver(other);
    double across = 0;
    double lateral = 0;
    double ahead = 0;
    while (across < WIDTH) {
      lateral = Math.min(aside, lateral + 3 * STEP);
      across += lateral * STEP;
      ahead += other * STEP;
    }
    double gap = other * headway + LENGTH + ahead + 1;
    across = 0;
    lateral = 0;
    for (double time = 0; time < 30; time += STEP) {
      lateral = Math.min(aside, lateral + 3 * STEP);
      across += lateral * STEP;
      gap -= ego.step(time, across >= 0.375, gap <= 2 * ego.speed);
      if (gap < 0) {
        return End.HIT;
      }
    }
    return End.AVOIDED;
  }

  private static End behindABrakingOne(double speed, double deceleration, double headway) {
    double other = speed / 3.6;
    Driver ego = new Driver(other);
    double gap = other * headway;
    for (double time = 0; time < 30; time += STEP) {
      other = Math.max(0, other - deceleration * STEP);
      gap += other * STEP - ego.step(time, deceleration > 5, gap <= 2 * ego.speed);
      if (gap < 0) {
        return End.HIT;
      }
    }
    return End.AVOIDED;
  }

  /** Returns the values of the cases of a campaign of the suite. */
  private Set<String> kept(String campaign) {
    CampaignPlan plan =
        CampaignReader.read(Suites.file("un-r157-alks", folder)).stream()
            .filter(each -> each.part().equals(Optional.of(campaign)))
            .findFirst()
            .orElseThrow();
    return new CaseList(plan)
        .cases().stream()
            .map(CampaignCase::values)
            .map(Object::toString)
            .collect(Collectors.toSet());
  }

  /** Returns whether the suite has a case, which it has to have if the driver avoids it. */
  private static boolean isLeftOut(Set<String> kept, String values, End end) {
    boolean isKept = kept.remove(values);
    assertEquals(end == End.AVOIDED, isKept, () -> values + " is " + end);
    return !isKept;
  }

  @Test
  void theCutInsOfTheSuiteAreThoseThatTheDriverAvoids() {
    Set<String> kept = kept("cut_in_driver");
    int left = 0;
    for (int speed = 20; speed <= 60; speed += 20) {
      for (int other = 10; other < speed; other += 20) {
        for (String aside : new String[] {"0.5", "1", "1.5"}) {
          for (int distance = 5; distance <= 50; distance += 5) {
            String values =
                String.format(Locale.ROOT, "[%d, %d, %s, %d]", speed, other, aside, distance);
            End end = cutIn(speed, other, Double.parseDouble(aside), distance);
            left += isLeftOut(kept, values, end) ? 1 : 0;
          }
        }
      }
    }
    assertEquals(Set.of(), kept);
    assertTrue(left > 50, "many cannot be prevented");
  }

  @Test
  void theCutOutsOfTheSuiteAreThoseThatTheDriverAvoids() {
    Set<String> kept = kept("cut_out_driver");
    int left = 0;
    for (int speed = 20; speed <= 50; speed += 15) {
      for (String aside : new String[] {"0.5", "1", "1.5"}) {
        for (String headway : new String[] {"0.4", "0.7", "1", "1.5"}) {
          String values = String.format(Locale.ROOT, "[%d, %s, %s]", speed, aside, headway);
          End end = cutOut(speed, Double.parseDouble(aside), Double.parseDouble(headway));
          left += isLeftOut(kept, values, end) ? 1 : 0;
        }
      }
    }
    assertEquals(Set.of(), kept);
    assertTrue(left >= 4, "some cannot be prevented");
  }

  @Test
  void theBrakingVehiclesOfTheSuiteAreThoseThatTheDriverDoesNotHit() {
    Set<String> kept = kept("deceleration_driver");
    int left = 0;
    for (int speed = 20; speed <= 60; speed += 20) {
      for (String deceleration : new String[] {"6", "8", "9.81"}) {
        for (String headway : new String[] {"1.2", "1.6", "2"}) {
          String values = String.format(Locale.ROOT, "[%d, %s, %s]", speed, deceleration, headway);
          End end =
              behindABrakingOne(
                  speed, Double.parseDouble(deceleration), Double.parseDouble(headway));
          left += isLeftOut(kept, values, end) ? 1 : 0;
        }
      }
    }
    assertEquals(Set.of(), kept);
    assertTrue(left >= 8, "some cannot be prevented");
  }
}
