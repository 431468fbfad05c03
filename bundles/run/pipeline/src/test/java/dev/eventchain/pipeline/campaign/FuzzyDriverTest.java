package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests which cut-ins and cut-outs the suite of UN R157 takes for preventable against the driver of
 * the Fuzzy Safety Model (Mattas et al. 2020), with the figures of JRC-FSM, who looks every 0.1 s.
 */
class FuzzyDriverTest {

  private static final double STEP = 0.0005;
  private static final double SAMPLE = 0.1;
  private static final double LENGTH = 4.3;
  private static final double WIDTH = 1.9;
  private static final double LANE = 3.5;
  private static final double REACTION = 0.75;

  @TempDir Path folder;

  /** A cut-in that goes on in small steps, with speeds in m/s and distances in m. */
  private static final class CutIn {
    private final double other;
    private final double aside;
    private double speed;
    private double gap;
    private double across = LANE;
    private double lateral;
    private double before = Double.NaN;
    private double reaction = REACTION;
    private double braking;
    private double applied;

    CutIn(double speed, double other, double aside, double distance) {
      this.speed = speed / 3.6;
      this.other = other / 3.6;
      this.aside = aside;
      this.gap = distance;
    }

    /** Looks at the other one, and decides how hard to brake until the next sample. */
    void look() {
      double acceleration = Double.isNaN(before) ? 0 : (speed - before) / SAMPLE;
      before = speed;
      double critical = critical(acceleration);
      double proactive = proactive();
      applied = 0;
      if (gap < -LENGTH || passes() || critical + proactive == 0) {
        return;
      }
      if (reaction > 0) {
        reaction -= SAMPLE;
        return;
      }
      double wanted = critical > 0 ? 4 + 2 * critical : 4 * proactive;
      braking = Math.min(braking + 12.65 * SAMPLE, Math.min(0.774 * 9.81, wanted));
      applied = braking;
    }

    private boolean passes() {
      if (across <= WIDTH) {
        return false;
      }
      double passing = speed == other ? 1e9 : (gap + 2 * LENGTH) / (speed - other);
      return lateral <= 0 || (across - WIDTH) / lateral > passing + SAMPLE;
    }

    private double proactive() {
      double reacting = REACTION * speed - other * other / 14;
      return between(gap - 2, reacting + speed * speed / 12, reacting + speed * speed / 8 + 2);
    }

    private double critical(double acceleration) {
      double closing = speed - other;
      double expected = Math.max(acceleration, -4);
      double later = closing + REACTION * expected;
      if (closing <= 0) {
        return 0;
      }
      if (later < 0) {
        return gap < closing * closing / Math.abs(2 * acceleration) ? 1 : 0;
      }
      double reacting = REACTION * (closing + REACTION * expected / 2);
      return between(gap, reacting + later * later / 12, reacting + later * later / 8);
    }

    private static double between(double distance, double unsafe, double safe) {
      return Math.max(0, Math.min(1, (distance - safe) / (unsafe - safe)));
    }

    void go() {
      speed = Math.max(0, speed - applied * STEP);
      lateral = across > 0 ? Math.min(aside, lateral + 2 * STEP) : 0;
      across = Math.max(0, across - lateral * STEP);
      gap += (other - speed) * STEP;
    }

    boolean isHit() {
      return across < WIDTH && gap < 0;
    }
  }

  /** Returns whether the driver avoids it who looks for the first time after a number of steps. */
  private static boolean avoids(CutIn cutIn, int first) {
    int sample = (int) Math.round(SAMPLE / STEP);
    for (int i = 0; i < 30 / STEP; i++) {
      if (i >= first && (i - first) % sample == 0) {
        cutIn.look();
      }
      cutIn.go();
      if (cutIn.isHit()) {
        return false;
      }
    }
    return true;
  }

  private Set<String> kept(String part) {
    return CampaignReader.read(Suites.file("un-r157-alks", folder)).stream()
        .filter(each -> each.part().equals(Optional.of(part)))
        .flatMap(plan -> new CaseList(plan).cases().stream())
        .map(CampaignCase::values)
        .map(Object::toString)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void theCutInsOfTheSuiteAreThoseThatTheFuzzyModelAvoids() {
    Set<String> avoided = new TreeSet<>();
    int hit = 0;
    for (int speed = 20; speed <= 60; speed += 20) {
      for (int other = 10; other < speed; other += 20) {
        for (String aside : new String[] {"0.5", "1", "1.5"}) {
          for (int distance = 5; distance <= 50; distance += 5) {
            double lateral = Double.parseDouble(aside);
            boolean soon = avoids(new CutIn(speed, other, lateral, distance), 0);
            boolean late = avoids(new CutIn(speed, other, lateral, distance), 100);
            String values =
                String.format(Locale.ROOT, "[%d, %d, %s, %d]", speed, other, aside, distance);
            assertEquals(soon, late, () -> values + " depends on when the driver looks");
            hit += soon ? 0 : 1;
            if (soon) {
              avoided.add(values);
            }
          }
        }
      }
    }
    assertEquals(avoided, kept("cut_in_fuzzy"));
    assertTrue(hit > 30, "some cannot be prevented");
  }

  /** Returns one who drives towards what stands, from the moment at which it is seen. */
  private static CutIn standing(double speed, double distance) {
    CutIn standing = new CutIn(speed, 0, 0, distance);
    standing.across = 0;
    return standing;
  }

  @Test
  void theCutOutsOfTheSuiteAreThoseThatTheFuzzyModelAvoids() {
    Set<String> avoided = new TreeSet<>();
    int hit = 0;
    for (int speed = 20; speed <= 60; speed += 20) {
      for (String aside : new String[] {"0.5", "1", "1.5"}) {
        for (String headway : new String[] {"0.4", "0.7", "1", "1.5"}) {
          double lateral = Double.parseDouble(aside);
          // Out of the way, 1.9 m aside, 1 m before the other one, which is then 5.3 m ahead of its
          // rear; seen when it is 0.375 m aside. It begins with 3 m/s2.
          double seen = (WIDTH - 0.375) / lateral + Double.parseDouble(headway);
          double distance = speed / 3.6 * seen + LENGTH + 1;
          boolean soon = avoids(standing(speed, distance), 0);
          boolean late = avoids(standing(speed, distance), 199);
          String values = String.format(Locale.ROOT, "[%d, %s, %s]", speed, aside, headway);
          assertEquals(soon, late, () -> values + " depends on when the driver looks");
          hit += soon ? 0 : 1;
          if (soon) {
            avoided.add(values);
          }
        }
      }
    }
    assertEquals(avoided, kept("cut_out_fuzzy"));
    assertEquals(5, hit, "some cannot be prevented");
  }

  /** The formula of the suite: reaction, jerk, and the hardest braking of the model. */
  @Test
  void theFuzzyModelNeedsTheDistanceOfAClosedForm() {
    for (int speed = 20; speed <= 60; speed += 10) {
      double meters = speed / 3.6;
      for (int first : new int[] {0, 199}) {
        double reaction = 0.8 + first * STEP;
        double closed =
            (reaction + 0.4) * meters - 0.19 + (meters - 1.265) * (meters - 1.265) / (2 * 6);
        assertTrue(avoids(standing(speed, closed + 0.25), first), speed + " km/h, " + first);
        assertTrue(!avoids(standing(speed, closed), first), speed + " km/h, " + first);
      }
    }
  }
}
