package dev.eventchain.contracts.timing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.contracts.timing.ResponseTimes.Demand;
import dev.eventchain.contracts.timing.ResponseTimes.Outcome;
import dev.eventchain.contracts.timing.ResponseTimes.Response;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Response times against numbers by hand, and against schedules by brute force. */
class ResponseTimesTest {

  private static final int[] PERIODS = {3, 4, 5, 6, 8, 10, 12};

  private static Demand demand(long period, long execution, int priority) {
    return new Demand(
        OptionalLong.of(period), OptionalLong.of(execution), OptionalInt.of(priority));
  }

  private static Demand unordered(long period, long execution) {
    return new Demand(OptionalLong.of(period), OptionalLong.of(execution), OptionalInt.empty());
  }

  private static List<String> words(Demand... tasks) {
    return ResponseTimes.of(List.of(tasks)).stream()
        .map(it -> it.bound().isPresent() ? "" + it.bound().getAsLong() : it.outcome().name())
        .toList();
  }

  /**
   * Worked by hand. Third task: 5, then 5 + 1*3 + 1*3 = 11, 5 + 2*3 + 1*3 = 14, 5 + 2*3 + 2*3 = 17,
   * 5 + 3*3 + 2*3 = 20, and 5 + 3*3 + 2*3 = 20 again: all of its period.
   */
  @Test
  void threeTasksThatFillTheProcessor() {
    assertEquals(
        List.of("3", "6", "20"), words(demand(7, 3, 3), demand(12, 3, 2), demand(20, 5, 1)));
  }

  /**
   * Worked by hand. The task of 50 has 12, then 12 + 2*10 + 1*10 = 42, 12 + 2*10 + 2*10 = 52, which
   * is late, with a utilisation of 12/50 + 10/40 + 10/30, below 1.
   */
  @Test
  void lateTaskOnAProcessorThatIsNotFull() {
    assertEquals(
        List.of("LATE", "20", "10"),
        words(demand(50, 12, 1), demand(40, 10, 2), demand(30, 10, 3)));
    assertEquals(
        List.of("LATE", "10", "20"),
        words(demand(50, 12, 1), demand(40, 10, 3), demand(30, 10, 2)));
  }

  /** Without priorities, or with equal ones, any of them may go first: 1 + 2, and 2 + 1. */
  @Test
  void withoutAnOrderEachWaitsForAll() {
    assertEquals(List.of("3", "3"), words(unordered(4, 1), unordered(10, 2)));
    assertEquals(List.of("3", "3"), words(demand(4, 1, 7), demand(10, 2, 7)));
    assertEquals(List.of("1", "3"), words(demand(4, 1, 7), demand(10, 2, 6)));
    assertEquals(List.of("LATE", "6"), words(unordered(4, 1), unordered(10, 4)));
    assertEquals(List.of("3", "3"), words(demand(4, 1, 7), unordered(10, 2)));
  }

  @Test
  void unknownDemandIsNotNothing() {
    Demand unknown = new Demand(OptionalLong.of(10), OptionalLong.empty(), OptionalInt.of(2));
    assertEquals(
        List.of("1", "UNKNOWN", "UNKNOWN"), words(demand(4, 1, 3), unknown, demand(20, 1, 1)));
    assertEquals(List.of("UNKNOWN", "UNKNOWN"), words(unordered(4, 1), unknown));
    assertEquals(List.of(), words());
    assertEquals(List.of("5"), words(unordered(5, 5)));
    assertEquals(List.of("LATE"), words(unordered(5, 6)));
  }

  /** No sum overflows, and no number of steps takes long. */
  @Test
  void extremeTimesEnd() {
    long longest = Long.MAX_VALUE / 4;
    assertEquals(List.of("1", "LATE"), words(demand(1, 1, 2), demand(longest, longest, 1)));
    assertEquals(
        List.of("99999999", "UNKNOWN"),
        words(demand(100_000_000, 99_999_999, 2), demand(longest, 50_000_000, 1)));
  }

  /** Priorities of their own: exact, if all are released together; never above for other phases. */
  @Property
  void prioritiesAreExact(@ForAll long seed) {
    Random random = new Random(seed);
    List<Demand> tasks = tasks(random, true);
    List<Response> bounds = ResponseTimes.of(tasks);
    Schedule together = new Schedule(tasks, new long[tasks.size()], random, Policy.PRIORITIES);
    long[] longest = together.longest(true);
    for (int i = 0; i < longest.length; i++) {
      Response bound = bounds.get(i);
      long period = tasks.get(i).period().getAsLong();
      if (bound.outcome() == Outcome.BOUNDED) {
        assertEquals(bound.bound().getAsLong(), longest[i], () -> tasks.toString());
      } else {
        assertTrue(longest[i] > period, () -> tasks.toString());
      }
    }
    neverAbove(
        tasks, bounds, new Schedule(tasks, phases(tasks, random), random, Policy.PRIORITIES));
  }

  /** Any order, interrupted or not, and an executor with polling points. */
  @Property
  void noOrderExceedsTheBound(@ForAll long seed) {
    Random random = new Random(seed);
    List<Demand> tasks = tasks(random, false);
    List<Response> bounds = ResponseTimes.of(tasks);
    for (Policy policy : List.of(Policy.ANY, Policy.ANY_TO_THE_END, Policy.EXECUTOR)) {
      neverAbove(tasks, bounds, new Schedule(tasks, phases(tasks, random), random, policy));
    }
  }

  private static void neverAbove(List<Demand> tasks, List<Response> bounds, Schedule schedule) {
    long[] longest = schedule.longest(false);
    for (int i = 0; i < longest.length; i++) {
      long most = bounds.get(i).bound().orElse(Long.MAX_VALUE);
      assertTrue(longest[i] <= most, () -> tasks + " " + bounds + " " + Arrays.toString(longest));
    }
  }

  private static List<Demand> tasks(Random random, boolean priorities) {
    List<Demand> tasks = new ArrayList<>();
    int count = 1 + random.nextInt(4);
    for (int i = 0; i < count; i++) {
      int period = PERIODS[random.nextInt(PERIODS.length)];
      int execution = 1 + random.nextInt(3);
      int priority = 10 * random.nextInt(3) + i;
      tasks.add(priorities ? demand(period, execution, priority) : unordered(period, execution));
    }
    return tasks;
  }

  private static long[] phases(List<Demand> tasks, Random random) {
    return tasks.stream().mapToLong(it -> random.nextInt((int) it.period().getAsLong())).toArray();
  }

  private enum Policy {
    /** The largest number goes first, and interrupts. */
    PRIORITIES,
    /** Any job goes on, at each tick. */
    ANY,
    /** Any job starts, and goes on to its end. */
    ANY_TO_THE_END,
    /** Jobs to their ends, of those that were ready when the last ones of the set had ended. */
    EXECUTOR
  }

  /** Schedule of one processor, tick by tick; the jobs of a task go in their order. */
  private static final class Schedule {

    /** Two hyperperiods of all periods. */
    private static final int TICKS = 240;

    private final List<Demand> tasks;
    private final long[] phases;
    private final Random random;
    private final Policy policy;
    private final List<List<long[]>> open = new ArrayList<>();
    private final List<Integer> polled = new ArrayList<>();
    private int going = -1;

    Schedule(List<Demand> tasks, long[] phases, Random random, Policy policy) {
      this.tasks = tasks;
      this.phases = phases;
      this.random = random;
      this.policy = policy;
      tasks.forEach(task -> open.add(new ArrayList<>()));
    }

    /** Returns the longest response times, those of jobs that have not ended included. */
    long[] longest(boolean worst) {
      long[] longest = new long[tasks.size()];
      for (int now = 0; now < TICKS; now++) {
        release(now, worst);
        int chosen = chosen();
        if (chosen >= 0) {
          going = chosen;
          long[] job = open.get(chosen).get(0);
          job[1]--;
          if (job[1] == 0) {
            longest[chosen] = Math.max(longest[chosen], now + 1 - job[0]);
            open.get(chosen).remove(0);
            going = -1;
          }
        }
      }
      for (int i = 0; i < longest.length; i++) {
        for (long[] job : open.get(i)) {
          longest[i] = Math.max(longest[i], TICKS - job[0]);
        }
      }
      return longest;
    }

    private void release(int now, boolean worst) {
      for (int i = 0; i < tasks.size(); i++) {
        long since = now - phases[i];
        int execution = (int) tasks.get(i).execution().getAsLong();
        if (since >= 0 && since % tasks.get(i).period().getAsLong() == 0) {
          boolean most = worst || random.nextInt(4) > 0;
          open.get(i).add(new long[] {now, most ? execution : 1 + random.nextInt(execution)});
        }
      }
    }

    private int chosen() {
      List<Integer> ready = new ArrayList<>();
      for (int i = 0; i < tasks.size(); i++) {
        if (!open.get(i).isEmpty()) {
          ready.add(i);
        }
      }
      if (ready.isEmpty()) {
        return -1;
      }
      return switch (policy) {
        case PRIORITIES -> highest(ready);
        case ANY -> ready.get(random.nextInt(ready.size()));
        case ANY_TO_THE_END -> going >= 0 ? going : ready.get(random.nextInt(ready.size()));
        case EXECUTOR -> going >= 0 ? going : polled(ready);
      };
    }

    private int highest(List<Integer> ready) {
      int highest = ready.get(0);
      for (int each : ready) {
        if (tasks.get(each).priority().getAsInt() > tasks.get(highest).priority().getAsInt()) {
          highest = each;
        }
      }
      return highest;
    }

    private int polled(List<Integer> ready) {
      if (polled.isEmpty()) {
        polled.addAll(ready);
      }
      return polled.remove(0);
    }
  }
}
