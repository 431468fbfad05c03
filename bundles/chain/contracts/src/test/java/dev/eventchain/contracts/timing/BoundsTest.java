package dev.eventchain.contracts.timing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bounds against published numbers, and against schedules by brute force. */
class BoundsTest {

  private static final int[] PERIODS = {2, 3, 4, 5, 6, 8, 10, 12};

  /** Ticks that hold a hyperperiod of these periods many times over. */
  private static final long TICKS = 700;

  /** The longest way of a message, longer than most periods. */
  private static final int LONGEST_WAY = 15;

  private static long bound(LatencyType type, Method method, List<Task> path) {
    return PathLatency.of(type, path).bounds().stream()
        .filter(bound -> bound.method() == method)
        .mapToLong(Bound::time)
        .findFirst()
        .orElseThrow();
  }

  private static List<Long> numbers(String text) {
    return List.of(text.split(" ", -1)).stream().map(Long::valueOf).toList();
  }

  /** The published sums for 2, 10, 100 (124 in one tool) are below what happens. */
  @ParameterizedTest
  @CsvSource({
    "100 10 2, 212, 224",
    "2 10 100, 212, 224",
    "10 5 10, 40, 50",
    "5 2, 13, 14",
    "3 4 6, 21, 26"
  })
  void logicalExecutionTimes(String periods, long exact, long summed) {
    List<Task> path = new ArrayList<>();
    numbers(periods).forEach(it -> path.add(Task.logical("T" + path.size(), it, 0)));
    assertEquals(exact, bound(LatencyType.REACTION, Method.LET, path));
    assertEquals(summed, bound(LatencyType.REACTION, Method.DAVARE, path));
    assertEquals(exact, PathLatency.of(LatencyType.REACTION, path).bound().orElseThrow().time());
    List<Long> executions = path.stream().map(task -> 1L).toList();
    TracedChain traced = new TracedChain(path, executions, 3_000, new Random(1));
    assertEquals(exact, traced.reaction());
  }

  /** Rate-monotonic tasks on one processor, released together. */
  @ParameterizedTest
  @CsvSource({"16 8 4, 39, 39, 29, 26", "4 8 16, 39, 35, 23, 23"})
  void priorities(String periods, long davare, long duerr, long kloda, long simulated) {
    List<Task> path = new ArrayList<>();
    List<Long> executions = new ArrayList<>();
    for (long period : numbers(periods)) {
      long execution = period == 4 ? 1 : period == 8 ? 2 : 3;
      int number = period == 4 ? 0 : period == 8 ? 1 : 2;
      OptionalLong response =
          ResponseTimes.of(List.of(demand(4, 1), demand(8, 2), demand(16, 3))).get(number).bound();
      executions.add(execution);
      path.add(
          Task.periodic("T" + period, period, response.orElseThrow())
              .withPhase(0)
              .on("ecu", (int) -period));
    }
    assertEquals(davare, bound(LatencyType.REACTION, Method.DAVARE, path));
    assertEquals(duerr, bound(LatencyType.REACTION, Method.DUERR, path));
    assertEquals(kloda, bound(LatencyType.REACTION, Method.KLODA, path));
    Random always = worst();
    assertEquals(simulated, new TracedChain(path, executions, 400, always).reaction());
  }

  private static ResponseTimes.Demand demand(long period, long execution) {
    return demand(period, execution, (int) -period);
  }

  private static ResponseTimes.Demand demand(long period, long execution, int priority) {
    return new ResponseTimes.Demand(
        OptionalLong.of(period), OptionalLong.of(execution), OptionalInt.of(priority));
  }

  /** Returns a source by which each job takes its worst case. */
  private static Random worst() {
    return new Random(0) {
      private static final long serialVersionUID = 1L;

      @Override
      public int nextInt(int limit) {
        return limit - 1;
      }
    };
  }

  private static int length(Random random) {
    return 1 + random.nextInt(5);
  }

  private static long period(Random random) {
    return PERIODS[random.nextInt(PERIODS.length)];
  }

  @Property
  void logicalExecutionTimesAreExact(@ForAll long seed) {
    Random random = new Random(seed);
    List<Task> path = new ArrayList<>();
    for (int i = length(random); i > 0; i--) {
      long period = period(random);
      addWay(random, path, new ArrayList<>());
      path.add(Task.logical("T" + i, period, random.nextInt((int) period)));
    }
    List<Long> executions = path.stream().map(task -> task.response().orElseThrow()).toList();
    TracedChain traced = new TracedChain(path, executions, TICKS, worst());
    assertEquals(traced.reaction(), bound(LatencyType.REACTION, Method.LET, path));
    assertEquals(traced.dataAge(), bound(LatencyType.DATA_AGE, Method.LET, path));
  }

  /** Adds the way of the messages between two tasks to some of them. */
  private static void addWay(Random random, List<Task> path, List<Long> executions) {
    if (!path.isEmpty() && random.nextBoolean()) {
      long longest = 1L + random.nextInt(LONGEST_WAY);
      path.add(Task.onMessage("way " + path.size(), longest));
      executions.add(longest);
    }
  }

  /**
   * Random tasks: of timers on one to three processors, of messages, of logical times, with
   * messages that are on their way for random times.
   */
  @Property
  void noScheduleExceedsABound(@ForAll long seed) {
    Random random = new Random(seed);
    List<Long> executions = new ArrayList<>();
    List<Task> path = List.of();
    while (path.isEmpty()) {
      executions.clear();
      path = schedulable(random, executions);
    }
    TracedChain traced = new TracedChain(path, executions, TICKS, random);
    PathLatency reaction = PathLatency.of(LatencyType.REACTION, path);
    PathLatency age = PathLatency.of(LatencyType.DATA_AGE, path);
    assertTrue(reaction.bound().isPresent() && age.bound().isPresent());
    long reacted = traced.reaction();
    long aged = traced.dataAge();
    reaction.bounds().forEach(it -> assertTrue(reacted <= it.time(), it::toString));
    age.bounds().forEach(it -> assertTrue(aged <= it.time(), it::toString));
  }

  /** Draws tasks; returns none if a processor has too many of them. */
  private static List<Task> schedulable(Random random, List<Long> executions) {
    int kinds = random.nextInt(4);
    int processors = 1 + random.nextInt(3);
    Map<String, List<ResponseTimes.Demand>> demands = new HashMap<>();
    List<Task> path = new ArrayList<>();
    for (int i = length(random); i > 0; i--) {
      long period = period(random);
      long execution = 1L + random.nextInt(3);
      addWay(random, path, executions);
      executions.add(execution);
      String processor = "ecu" + random.nextInt(processors);
      int priority = 10 * random.nextInt(3) + i;
      int kind = kinds > 1 ? 0 : random.nextInt(3);
      if (kind == 1 && !path.isEmpty()) {
        path.add(Task.onMessage("T" + i, execution));
      } else if (kind == 2) {
        path.add(Task.logical("T" + i, period, random.nextInt((int) period)));
      } else {
        demands
            .computeIfAbsent(processor, none -> new ArrayList<>())
            .add(demand(period, execution, priority));
        long phase = random.nextInt((int) period);
        Task task = Task.periodic("T" + i, period, execution).withPhase(phase);
        path.add(task.on(processor, priority));
      }
    }
    path.replaceAll(task -> answering(task, demands.get(task.placement().processor())));
    return path.stream().allMatch(it -> it.response().isPresent()) ? path : List.of();
  }

  /** Returns a task of a timer with its response time among those on its processor. */
  private static Task answering(Task task, List<ResponseTimes.Demand> demands) {
    if (task.trigger() != Trigger.PERIODIC) {
      return task;
    }
    int priority = task.placement().priority().orElseThrow();
    int number = 0;
    while (demands.get(number).priority().getAsInt() != priority) {
      number++;
    }
    OptionalLong response = ResponseTimes.of(demands).get(number).bound();
    return new Task(
        task.name(), task.trigger(), task.period(), task.phase(), response, 0, task.placement());
  }

  @Test
  void messagesAddTheirTimeOnly() {
    Task sensor = Task.periodic("sensor", 50, 5);
    Task wire = Task.onMessage("wire", 3);
    Task filter = Task.onMessage("filter", 4);
    Task brake = Task.periodic("brake", 20, 2);
    Bound reaction = davare(LatencyType.REACTION, List.of(sensor, wire, filter, brake));
    assertEquals(50 + 5 + 3 + 4 + 20 + 2, reaction.time());
    assertEquals(
        List.of(
            new Bound.Share("sensor", 50, 5),
            new Bound.Share("wire", 0, 3),
            new Bound.Share("filter", 0, 4),
            new Bound.Share("brake", 20, 2)),
        reaction.shares());
    assertEquals(
        5 + 3 + 4 + 50 + 2,
        davare(LatencyType.DATA_AGE, List.of(sensor, wire, filter, brake)).time());
    assertEquals(3 + 20 + 2, davare(LatencyType.REACTION, List.of(wire, brake)).time());
  }

  /**
   * The worst of three cases by hand: a message that leaves at 10 arrives at 11, and is read at 12.
   */
  @Test
  void logicalExecutionTimesCountTheWay() {
    List<Task> path =
        List.of(Task.logical("A", 5, 0), Task.onMessage("way", 1), Task.logical("B", 2, 0));
    assertEquals(14, bound(LatencyType.REACTION, Method.LET, path));
    assertEquals(5 + 5 + 1 + 2 + 2, bound(LatencyType.REACTION, Method.DAVARE, path));
  }

  /** A message on its way to a task of the same processor has not been read before it is there. */
  @Test
  void prioritiesDoNotHelpMessagesOnTheirWay() {
    Task first = Task.periodic("first", 10, 2).withPhase(0).on("ecu", 2);
    Task second = Task.periodic("second", 10, 3).withPhase(0).on("ecu", 1);
    List<Task> path = List.of(first, Task.onMessage("way", 1), second);
    assertEquals(10 + 2 + 1 + 10 + 3, bound(LatencyType.REACTION, Method.DUERR, path));
    assertEquals(10 + 10 + 3, bound(LatencyType.REACTION, Method.KLODA, path));
    assertEquals(10 + 10 + 3, bound(LatencyType.REACTION, Method.DUERR, List.of(first, second)));
    assertEquals(10 + 3, bound(LatencyType.REACTION, Method.KLODA, List.of(first, second)));
  }

  private static Bound davare(LatencyType type, List<Task> path) {
    return PathLatency.of(type, path).bound().orElseThrow();
  }

  @Test
  void withoutANumberThereIsNoBound() {
    Task unknown =
        new Task(
            "fusion",
            Trigger.SPORADIC,
            OptionalLong.empty(),
            OptionalLong.empty(),
            OptionalLong.empty(),
            0,
            new Task.Placement("", OptionalInt.empty()));
    PathLatency latency =
        PathLatency.of(LatencyType.REACTION, List.of(Task.periodic("radar", 50, 5), unknown));
    assertEquals(List.of(), latency.bounds());
    assertEquals(
        List.of(new Gap("fusion", Gap.Kind.PERIOD), new Gap("fusion", Gap.Kind.RESPONSE)),
        latency.gaps());
    assertEquals(55, latency.known());
    PathLatency age =
        PathLatency.of(LatencyType.DATA_AGE, List.of(Task.periodic("radar", 50, 5), unknown));
    assertEquals(5, age.known());
    PathLatency first = PathLatency.of(LatencyType.REACTION, List.of(unknown));
    assertEquals(List.of(new Gap("fusion", Gap.Kind.RESPONSE)), first.gaps());
  }

  @Test
  void periodsAreTradedAgainstTheMaximum() {
    List<PathLatency> paths =
        List.of(
            PathLatency.of(
                LatencyType.REACTION,
                List.of(Task.periodic("camera", 50, 10), Task.periodic("brake", 20, 15))),
            PathLatency.of(
                LatencyType.REACTION,
                List.of(Task.periodic("radar", 40, 1), Task.periodic("brake", 20, 15))));
    Map<String, Sensitivity.Effect> effects = Sensitivity.of(LatencyType.REACTION, paths, 100);
    assertEquals(new Sensitivity.Effect(50, 19, OptionalLong.of(55)), effects.get("camera"));
    assertEquals(new Sensitivity.Effect(20, 5, OptionalLong.of(25)), effects.get("brake"));
    assertEquals(new Sensitivity.Effect(40, 0, OptionalLong.of(64)), effects.get("radar"));
    assertEquals(
        OptionalLong.empty(),
        Sensitivity.of(LatencyType.REACTION, paths, 39).get("brake").largest());
  }

  /** The end of a data age does not depend on how often the last task is executed. */
  @Test
  void periodWithoutEffectIsNotNamed() {
    List<Task> path = List.of(Task.periodic("camera", 50, 10), Task.periodic("brake", 20, 2));
    assertEquals(
        Set.of("camera"),
        Sensitivity.of(
                LatencyType.DATA_AGE, List.of(PathLatency.of(LatencyType.DATA_AGE, path)), 100)
            .keySet());
  }

  @Test
  void theSlowestOfAllPathsCounts() {
    TaskGraph graph = new TaskGraph();
    for (String name : List.of("camera", "radar", "fusion", "brake")) {
      graph.add(Task.periodic(name, name.equals("radar") ? 100 : 10, 1));
    }
    graph.connect("camera", "fusion");
    graph.connect("camera", "radar");
    graph.connect("radar", "fusion");
    graph.connect("fusion", "brake");
    graph.connect("brake", "camera");
    graph.connect("brake", "fusion");
    List<Long> times =
        graph.between(LatencyType.REACTION, "camera", "brake").orElseThrow().stream()
            .map(path -> path.bound().orElseThrow().time())
            .toList();
    assertEquals(List.of(33L, 134L), times);
    graph.add(Task.periodic("lamp", 10, 1));
    assertEquals(List.of(), graph.between(LatencyType.REACTION, "brake", "lamp").orElseThrow());
  }

  @Test
  void tooManyPathsAreNotKnown() {
    TaskGraph graph = new TaskGraph();
    graph.add(Task.periodic("0", 10, 1));
    for (int i = 1; i < 12; i++) {
      graph.add(Task.periodic(i + "a", 10, 1));
      graph.add(Task.periodic(i + "b", 10, 1));
      graph.add(Task.periodic("" + i, 10, 1));
      for (String way : List.of("a", "b")) {
        graph.connect("" + (i - 1), i + way);
        graph.connect(i + way, "" + i);
      }
    }
    assertEquals(512, graph.between(LatencyType.REACTION, "0", "9").orElseThrow().size());
    assertTrue(graph.between(LatencyType.REACTION, "0", "11").isEmpty());
  }

  @Test
  void aLongChainIsNotSearchedInDepth() {
    TaskGraph graph = new TaskGraph();
    for (int i = 0; i <= 100_000; i++) {
      graph.add(Task.periodic("" + i, 10, 1));
      if (i > 0) {
        graph.connect("" + (i - 1), "" + i);
      }
    }
    assertEquals(
        11, graph.between(LatencyType.REACTION, "500", "510").orElseThrow().get(0).path().size());
    assertTrue(graph.between(LatencyType.REACTION, "0", "100000").isEmpty());
  }
}
