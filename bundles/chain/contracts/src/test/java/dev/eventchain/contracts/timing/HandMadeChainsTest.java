package dev.eventchain.contracts.timing;

import static dev.eventchain.contracts.timing.LatencyType.DATA_AGE;
import static dev.eventchain.contracts.timing.LatencyType.REACTION;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

/**
 * Small chains whose bounds were worked out on paper from the published formulas. T is a period, R
 * a worst-case response time.
 */
class HandMadeChainsTest {

  private static void check(LatencyType type, long expected, Method method, Task... path) {
    Bound bound = PathLatency.of(type, List.of(path)).bound().orElseThrow();
    assertEquals(expected, bound.time());
    assertEquals(method, bound.method());
  }

  private static long of(LatencyType type, Method method, Task... path) {
    return PathLatency.of(type, List.of(path)).bounds().stream()
        .filter(bound -> bound.method() == method)
        .mapToLong(Bound::time)
        .findFirst()
        .orElseThrow();
  }

  private static Task sporadic(String name, long separation, long response) {
    return new Task(
        name,
        Trigger.SPORADIC,
        OptionalLong.of(separation),
        OptionalLong.empty(),
        OptionalLong.of(response),
        0,
        Task.Placement.UNKNOWN);
  }

  /** Three rates: 10+3 + 20+5 + 50+8; data are read after 10+3 and 20+5, and used for 8. */
  @Test
  void differentRatesAddUp() {
    Task[] path = {Task.periodic("a", 10, 3), Task.periodic("b", 20, 5), Task.periodic("c", 50, 8)};
    check(REACTION, 96, Method.DAVARE, path);
    check(DATA_AGE, 46, Method.DAVARE, path);
  }

  /** A writer of higher priority has ended before: T1 + R2 + T2 = 10 + 10 + 40, age R2 + T1. */
  @Test
  void aWriterOfHigherPriorityDoesNotDelay() {
    Task fast = Task.periodic("a", 10, 2).on("ecu", 2);
    Task slow = Task.periodic("b", 40, 10).on("ecu", 1);
    check(REACTION, 60, Method.DUERR, fast, slow);
    check(DATA_AGE, 20, Method.DUERR, fast, slow);
    check(REACTION, 62, Method.DAVARE, slow, fast);
    check(DATA_AGE, 52, Method.DAVARE, slow, fast);
  }

  /** The ways of messages undo that: 10 + (2 + 5) + 20 + 6. */
  @Test
  void aMessageOnItsWayDelays() {
    Task fast = Task.periodic("a", 10, 2).on("ecu", 2);
    Task slow = Task.periodic("b", 20, 6).on("ecu", 1);
    check(REACTION, 43, Method.DAVARE, fast, Task.onMessage("way", 5), slow);
  }

  /**
   * Released together, on one processor: the releases at 0, 10 and 20 are read at 0, 15 and 30, so
   * that the worst is 10 + (30 - 20) + 6. For any phases it is 10 + 6 + 15, without priorities 33.
   */
  @Test
  void knownPhasesNarrowABound() {
    Task fast = Task.periodic("a", 10, 2).withPhase(0).on("ecu", 2);
    Task slow = Task.periodic("b", 15, 6).withPhase(0).on("ecu", 1);
    check(REACTION, 26, Method.KLODA, fast, slow);
    assertEquals(31, of(REACTION, Method.DUERR, fast, slow));
    assertEquals(33, of(REACTION, Method.DAVARE, fast, slow));
  }

  /**
   * Logical execution times, T 4 and 6, the second one released at 2, 8, 14: what the first one
   * reads at 0, 4 and 8 leaves at 14, 14 and 20, 18, 14 and 16 after the release before it. At 2
   * the second one reads what the first one read at -4, for which it answers until 8.
   */
  @Test
  void logicalExecutionTimesWithPhases() {
    Task first = Task.logical("a", 4, 0);
    Task second = Task.logical("b", 6, 2);
    check(REACTION, 18, Method.LET, first, second);
    check(DATA_AGE, 12, Method.LET, first, second);
    assertEquals(20, of(REACTION, Method.DAVARE, first, second));
  }

  /** What messages activate adds its response time to the task before it: 20+4+7 + 50+10+3. */
  @Test
  void tasksThatMessagesActivateDoNotSample() {
    Task[] path = {
      Task.periodic("a", 20, 4),
      Task.onMessage("b", 7),
      Task.periodic("c", 50, 10),
      Task.onMessage("d", 3)
    };
    check(REACTION, 94, Method.DAVARE, path);
    check(DATA_AGE, 44, Method.DAVARE, path);
  }

  /** An event from outside starts a sporadic task at once; as a reader it may wait for the next. */
  @Test
  void sporadicTasksWaitAsReadersOnly() {
    Task timer = Task.periodic("timer", 20, 4);
    check(REACTION, 5 + 20 + 4, Method.DAVARE, sporadic("s", 100, 5), timer);
    check(REACTION, 20 + 4 + 100 + 5, Method.DAVARE, timer, sporadic("s", 100, 5));
  }

  /** Of 10+1 + 20+2 + 5+1 and 10+1 + 100+3 + 5+1, the slower one counts. */
  @Test
  void theSlowestWayOfAForkCounts() {
    TaskGraph graph = new TaskGraph();
    graph.add(Task.periodic("a", 10, 1));
    graph.add(Task.periodic("b", 20, 2));
    graph.add(Task.periodic("c", 100, 3));
    graph.add(Task.periodic("d", 5, 1));
    for (String middle : List.of("b", "c")) {
      graph.connect("a", middle);
      graph.connect(middle, "d");
    }
    graph.connect("d", "a"); // feedback
    List<Long> times =
        graph.between(REACTION, "a", "d").orElseThrow().stream()
            .map(path -> path.bound().orElseThrow().time())
            .sorted()
            .toList();
    assertEquals(List.of(39L, 120L), times);
  }

  /** One thread without priorities: each callback may wait for all others, 2 + 3 + 4. */
  @Test
  void callbacksOfOneExecutorWaitForEachOther() {
    List<ResponseTimes.Demand> all =
        List.of(
            demand(20, 2, OptionalInt.empty()),
            demand(30, 3, OptionalInt.empty()),
            demand(40, 4, OptionalInt.empty()));
    List<Long> responses = responses(all);
    assertEquals(List.of(9L, 9L, 9L), responses);
    check(
        REACTION,
        20 + 9 + 30 + 9,
        Method.DAVARE,
        Task.periodic("a", 20, responses.get(0)),
        Task.periodic("b", 30, responses.get(1)));
  }

  /**
   * (C, T) = (1,4) (2,6) (3,13) by rates: R1 = 1; R2 = 2 + 1; R3 = 3 + ceil(10/4) + 2 ceil(10/6) =
   * 10. From fast to slow, 4 + 6 + 13 + 10; from slow to fast, the sum of all T and R.
   */
  @Test
  void interruptedTasksByTheirRates() {
    List<Long> responses =
        responses(
            List.of(
                demand(4, 1, OptionalInt.of(3)),
                demand(6, 2, OptionalInt.of(2)),
                demand(13, 3, OptionalInt.of(1))));
    assertEquals(List.of(1L, 3L, 10L), responses);
    Task fast = Task.periodic("a", 4, responses.get(0)).on("ecu", 3);
    Task middle = Task.periodic("b", 6, responses.get(1)).on("ecu", 2);
    Task slow = Task.periodic("c", 13, responses.get(2)).on("ecu", 1);
    check(REACTION, 33, Method.DUERR, fast, middle, slow);
    check(REACTION, 37, Method.DAVARE, slow, middle, fast);
    assertEquals(20, of(DATA_AGE, Method.DUERR, fast, middle, slow));
  }

  /** A processor that is asked for more than it has bounds nothing: 3/4 + 3/8 > 1. */
  @Test
  void tooMuchWorkHasNoBound() {
    List<ResponseTimes.Response> found =
        ResponseTimes.of(List.of(demand(4, 3, OptionalInt.of(2)), demand(8, 3, OptionalInt.of(1))));
    assertEquals(ResponseTimes.Outcome.BOUNDED, found.get(0).outcome());
    assertEquals(ResponseTimes.Outcome.LATE, found.get(1).outcome());
  }

  /** Without the worst case of one task there is no bound, but what it is at least: 10+3 + 20. */
  @Test
  void anUnknownWorstCaseIsNotZero() {
    Task unknown =
        new Task(
            "b",
            Trigger.PERIODIC,
            OptionalLong.of(20),
            OptionalLong.empty(),
            OptionalLong.empty(),
            0,
            Task.Placement.UNKNOWN);
    PathLatency latency = PathLatency.of(REACTION, List.of(Task.periodic("a", 10, 3), unknown));
    assertTrue(latency.bound().isEmpty());
    assertEquals(33, latency.known());
    assertEquals(List.of(new Gap("b", Gap.Kind.RESPONSE)), latency.gaps());
  }

  private static ResponseTimes.Demand demand(long period, long execution, OptionalInt priority) {
    return new ResponseTimes.Demand(OptionalLong.of(period), OptionalLong.of(execution), priority);
  }

  private static List<Long> responses(List<ResponseTimes.Demand> all) {
    return ResponseTimes.of(all).stream().map(it -> it.bound().orElseThrow()).toList();
  }
}
