package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests that a budget allows the same trials in whatever order they end. */
class TrialRoundTest {

  private static final List<Double> SECONDS = List.of(3.0, 1.0, 4.0, 1.5, 9.0, 2.0);

  private static TrialRound<Double> round(int always, double budget) {
    return new TrialRound<>(SECONDS, Double::doubleValue, always, budget);
  }

  private static List<Double> leftOutInOrder(int always, double budget) {
    TrialRound<Double> round = round(always, budget);
    for (int i = 0; i < round.size(); i++) {
      if (round.begin(i).isPresent()) {
        round.end(i);
      }
    }
    return round.leftOut();
  }

  @Test
  void thoseThatBeginWithinTheBudgetBelongToIt() {
    assertEquals(List.of(1.5, 9.0, 2.0), leftOutInOrder(0, 8));
    assertEquals(List.of(9.0, 2.0), leftOutInOrder(0, 8.5));
    assertEquals(List.of(1.0, 4.0, 1.5, 9.0, 2.0), leftOutInOrder(0, 0.1));
  }

  @Test
  void anEndlessBudgetLeavesOutNone() {
    assertEquals(List.of(), leftOutInOrder(0, Double.POSITIVE_INFINITY));
  }

  @Test
  void theFirstOnesBelongToItInAnyCaseAndTheirTimeCounts() {
    assertEquals(List.of(1.5, 9.0, 2.0), leftOutInOrder(3, 1));
  }

  @Test
  void theSameOnesBelongToItHoweverManyAreDrivenAtTheSameTime() {
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      TrialRound<Double> round = round(1, 8.2);
      List<Integer> running = new ArrayList<>();
      for (int next = 0; next < round.size() || !running.isEmpty(); ) {
        if (next < round.size() && (running.isEmpty() || random.nextBoolean())) {
          int number = next++;
          round.begin(number).ifPresent(trial -> running.add(number));
        } else {
          Collections.shuffle(running, random);
          round.end(running.remove(0));
        }
      }
      assertEquals(List.of(9.0, 2.0), round.leftOut(), "seed " + seed);
    }
  }

  @Test
  void oneThatIsClearlyLeftOutIsNotDriven() {
    TrialRound<Double> round = round(0, 3);
    assertTrue(round.begin(1).isPresent());
    round.end(0);
    assertTrue(round.begin(1).isEmpty());
  }
}
