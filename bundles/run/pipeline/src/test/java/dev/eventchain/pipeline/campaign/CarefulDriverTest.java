package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests which cut-ins the suite of UN R157 takes for preventable against the driver of the
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

  private static End drive(double speed, double other, double aside, double distance) {
    double gap = distance;
    double ego = speed / 3.6;
    double ahead = other / 3.6;
    double across = LANE;
    double lateral = 0;
    double perceivedAt = Double.NaN;
    double criticalAt = Double.NaN;
    double braking = 0;
    for (double time = 0; time < 30; time += STEP) {
      lateral = across > 0 ? Math.min(aside, lateral + 2 * STEP) : 0;
      across = Math.max(0, across - lateral * STEP);
      perceivedAt = Double.isNaN(perceivedAt) && LANE - across >= 0.375 ? time : perceivedAt;
      boolean critical = time >= perceivedAt + 0.4 && ego > ahead && gap <= 2 * (ego - ahead);
      criticalAt = Double.isNaN(criticalAt) && critical ? time : criticalAt;
      if (time >= criticalAt + 0.75) {
        braking = Math.min(0.774 * 9.81, braking + 12.65 * STEP);
      }
      ego = Math.max(0, ego - braking * STEP);
      gap += (ahead - ego) * STEP;
      if (across < WIDTH && gap < 0) {
        return gap > -LENGTH / 10 ? End.HIT : End.BESIDE;
      }
    }
    return End.AVOIDED;
  }

  @Test
  void theCasesOfTheSuiteAreThoseThatTheDriverAvoids() {
    CampaignPlan plan =
        CampaignReader.read(Suites.file("un-r157-alks", folder)).stream()
            .filter(each -> each.part().equals(Optional.of("cut_in_driver")))
            .findFirst()
            .orElseThrow();
    Set<String> kept =
        new CaseList(plan)
            .cases().stream()
                .map(CampaignCase::values)
                .map(Object::toString)
                .collect(Collectors.toSet());
    int hit = 0;
    for (int speed = 20; speed <= 60; speed += 20) {
      for (int other = 10; other < speed; other += 20) {
        for (String aside : new String[] {"0.5", "1", "1.5"}) {
          for (int distance = 5; distance <= 50; distance += 5) {
            String values = "[%d, %d, %s, %d]".formatted(speed, other, aside, distance);
            End end = drive(speed, other, Double.parseDouble(aside), distance);
            if (kept.remove(values)) {
              assertEquals(End.AVOIDED, end, values);
            } else {
              assertTrue(end != End.AVOIDED, () -> values + " is avoided, too");
              hit++;
            }
          }
        }
      }
    }
    assertEquals(Set.of(), kept);
    assertTrue(hit > 50, "many cannot be prevented");
  }
}
