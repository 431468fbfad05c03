package dev.eventchain.simulation.measure;

import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;

/**
 * Latency from a stimulus to the outputs based on it, along the activation graph. The outputs of an
 * activation are based on all that it read from nodes before it; samples from itself or later nodes
 * are feedback and not followed ({@link ActivationOrder}). Where paths of different length join,
 * the oldest stimulus counts.
 *
 * <p>The reaction time counts the first output that is based on a stimulus (first-to-first, as in
 * the maximum reaction time); the data age counts every output. Both end with the activation, when
 * its outputs are published.
 *
 * <p>A latency is the sum of its hops: the age of each sample on the path when it was read, and the
 * time from there to its reader's next sample ({@link MessageFlow}).
 */
public final class ChainLatency {

  /** An activation of a node. */
  private record Step(String node, int position, Activation activation) {}

  /**
   * Path from the oldest stimulus of an activation to it; of several paths, the one whose sample
   * came last.
   *
   * @param origin time of the stimulus, in ns
   * @param topic topic of the sample that led to this activation; empty if none did
   * @param since publication time of that sample, in ns; that of the stimulus if there is none
   * @param before the activation that wrote that sample; null if it is the stimulus
   */
  private record Passage(Step step, long origin, String topic, long since, Passage before) {

    long end() {
      return step.activation().end();
    }

    long time() {
      return end() - origin;
    }
  }

  /**
   * Part of a node in a latency, in ns: the hop to it, and its processing of the sample.
   *
   * @param topic the topic of the hop; empty if the node's activation is the stimulus
   * @param waiting age of the sample at the node's start; of a stimulus, with what counts before it
   * @param execution from its start to the publication of its sample; to its end for the last node
   */
  public record Part(String topic, String node, long waiting, long execution) {}

  /**
   * Latency from a stimulus to an output based on it.
   *
   * @param time in ns
   * @param parts its parts, in the order of the data; they add up to it
   */
  public record Latency(long time, List<Part> parts) {

    private static Latency of(Passage passage) {
      Deque<Part> parts = new ArrayDeque<>();
      long end = passage.end();
      for (Passage each = passage; each != null; each = each.before()) {
        long start = each.step().activation().start();
        String node = each.step().node();
        parts.addFirst(new Part(each.topic(), node, start - each.since(), end - start));
        end = each.since();
      }
      return new Latency(passage.time(), List.copyOf(parts));
    }
  }

  /**
   * Stimuli on which no output is based, from the first one on that has an output.
   *
   * @param count their number
   * @param untilLater the longest time from one of them to the first output that is based on a
   *     later stimulus, in ns; 0 if there is none
   * @param untilEnd the time from the first of those without such an output to the end, in ns; 0 if
   *     there is none
   */
  public record Unanswered(int count, long untilLater, long untilEnd) {

    /** No stimulus. */
    public static final Unanswered NONE = new Unanswered(0, 0, 0);

    private Unanswered and(Unanswered other) {
      return new Unanswered(
          count + other.count,
          Math.max(untilLater, other.untilLater),
          Math.max(untilEnd, other.untilEnd));
    }
  }

  private final RunLog log;
  private final Set<String> first;
  private final Map<String, Integer> positions;
  private final long before;
  private final Map<SampleId, Passage> writers = new HashMap<>();

  /**
   * Creates the latencies of a stimulus.
   *
   * @param before the time that counts before each of its samples, in ns
   */
  private ChainLatency(RunLog log, Set<String> first, Map<String, Integer> positions, long before) {
    this.log = log;
    this.first = first;
    this.positions = positions;
    this.before = before;
  }

  /**
   * Returns the reaction times from the samples of a sensor to the commands based on them.
   *
   * @param source the sensor's topic, for any reading node
   * @param target the command's topic
   * @return latencies in ns, in the order of the commands
   */
  public static List<Long> reactions(RunLog log, String source, String target) {
    Set<String> readers =
        log.nodes().keySet().stream()
            .filter(node -> reads(log, node).contains(source))
            .collect(Collectors.toSet());
    ChainLatency latency = new ChainLatency(log, readers, ActivationOrder.of(log, readers), 0);
    List<Long> latencies = new ArrayList<>();
    Set<Long> answered = new HashSet<>();
    for (Step step : latency.steps()) {
      Passage passage = latency.follow(step, source);
      boolean commands =
          step.activation().writes().stream().anyMatch(sample -> sample.topic().equals(target));
      if (commands && passage != null && answered.add(passage.origin())) {
        latencies.add(passage.time());
      }
    }
    return latencies;
  }

  /**
   * Returns the latencies between two nodes: from each external sample of the first one, or from
   * its activation if it has none, to the outputs of the last one.
   *
   * @param first the node whose inputs are the stimuli
   * @param last the node with the outputs; its activation counts if it writes nothing at all
   * @param dataAge true if every output counts, not only the first one based on a sample
   * @return empty if no output of the last node is based on an input of the first
   */
  public static List<Latency> between(RunLog log, String first, String last, boolean dataAge) {
    return between(log, first, last, dataAge, topic -> 0);
  }

  /**
   * Returns the latencies between two nodes likewise, from a time before the samples of some topics
   * on.
   *
   * @param before the time that counts before a sample of a topic, in ns
   */
  public static List<Latency> between(
      RunLog log, String first, String last, boolean dataAge, ToLongFunction<String> before) {
    List<Latency> latencies = new ArrayList<>();
    Map<String, Integer> positions = ActivationOrder.of(log, Set.of(first));
    for (String stimulus : stimuli(log, first, positions.keySet())) {
      ChainLatency latency =
          new ChainLatency(log, Set.of(first), positions, before.applyAsLong(stimulus));
      Set<Long> answered = new HashSet<>();
      for (Step step : latency.steps()) {
        Passage passage = latency.follow(step, stimulus);
        if (passage != null
            && step.node().equals(last)
            && latency.ends(step)
            && (answered.add(passage.origin()) || dataAge)) {
          latencies.add(Latency.of(passage));
        }
      }
    }
    return latencies;
  }

  /**
   * Returns the stimuli of a node that the outputs of another one left out. A reaction to what they
   * told takes until an output is based on a later one.
   *
   * @param end the time until which outputs are known, in ns
   */
  public static Unanswered unanswered(RunLog log, String first, String last, long end) {
    Map<String, Integer> positions = ActivationOrder.of(log, Set.of(first));
    Unanswered all = Unanswered.NONE;
    for (String stimulus : stimuli(log, first, positions.keySet())) {
      ChainLatency latency = new ChainLatency(log, Set.of(first), positions, 0);
      TreeMap<Long, Long> answers = new TreeMap<>();
      for (Step step : latency.steps()) {
        Passage passage = latency.follow(step, stimulus);
        if (passage != null && step.node().equals(last) && latency.ends(step)) {
          answers.merge(passage.origin(), passage.end(), Math::min);
        }
      }
      all = all.and(unanswered(latency.times(stimulus), answers, end));
    }
    return all;
  }

  /** Returns the times of all stimuli. */
  private List<Long> times(String stimulus) {
    return stimulus.isEmpty()
        ? first.stream()
            .flatMap(node -> log.nodes().getOrDefault(node, List.of()).stream())
            .map(Activation::start)
            .toList()
        : List.copyOf(log.publications().getOrDefault(stimulus, Map.of()).values());
  }

  /**
   * Compares stimuli with the first outputs that are based on them.
   *
   * @param answers the times of outputs by those of their stimuli
   */
  private static Unanswered unanswered(
      List<Long> times, NavigableMap<Long, Long> answers, long end) {
    TreeMap<Long, Long> earliest = new TreeMap<>();
    long next = Long.MAX_VALUE;
    for (Map.Entry<Long, Long> answer : answers.descendingMap().entrySet()) {
      next = Math.min(next, answer.getValue());
      earliest.put(answer.getKey(), next);
    }
    Unanswered all = Unanswered.NONE;
    for (long time : times) {
      if (!answers.isEmpty() && time > answers.firstKey() && !answers.containsKey(time)) {
        Map.Entry<Long, Long> later = earliest.higherEntry(time);
        all =
            all.and(
                later == null
                    ? new Unanswered(1, 0, end - time)
                    : new Unanswered(1, later.getValue() - time, 0));
      }
    }
    return all;
  }

  /**
   * Returns the topics that a node reads and no node behind it writes; an empty name if there is
   * none.
   */
  private static Set<String> stimuli(RunLog log, String first, Set<String> behind) {
    Set<String> topics = reads(log, first);
    log.nodes()
        .forEach(
            (node, activations) -> {
              if (behind.contains(node)) {
                activations.forEach(
                    each -> each.writes().forEach(written -> topics.remove(written.topic())));
              }
            });
    return topics.isEmpty() ? Set.of("") : topics;
  }

  private static Set<String> reads(RunLog log, String node) {
    return log.nodes().getOrDefault(node, List.of()).stream()
        .flatMap(each -> each.reads().stream())
        .map(SampleId::topic)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns whether an activation of the last node counts. */
  private boolean ends(Step step) {
    return !step.activation().writes().isEmpty()
        || log.nodes().get(step.node()).stream().allMatch(each -> each.writes().isEmpty());
  }

  /** Returns all activations, each after those whose samples it can have read. */
  private List<Step> steps() {
    List<Step> steps = new ArrayList<>();
    log.nodes()
        .forEach(
            (node, activations) -> {
              if (positions.containsKey(node)) {
                int position = positions.get(node);
                activations.forEach(each -> steps.add(new Step(node, position, each)));
              }
            });
    steps.sort(
        Comparator.comparingLong((Step step) -> step.activation().start())
            .thenComparingInt(Step::position)
            .thenComparing(Step::node));
    return steps;
  }

  /**
   * Records the stimuli of an activation's outputs.
   *
   * @param stimulus the topic with the stimuli of the first node; empty for its activation
   * @return the path from the oldest stimulus to the activation; null if there is none
   */
  private Passage follow(Step step, String stimulus) {
    Passage oldest = null;
    boolean starts = first.contains(step.node());
    if (starts && stimulus.isEmpty()) {
      long start = step.activation().start();
      oldest = new Passage(step, start, "", start, null);
    }
    for (SampleId read : step.activation().reads()) {
      Passage writer = writers.get(read);
      Passage found = null;
      if (starts && read.topic().equals(stimulus)) {
        long time = log.time(read) - before;
        found = new Passage(step, time, stimulus, time, null);
      } else if (!starts && writer != null && writer.step().position() < step.position()) {
        found = new Passage(step, writer.origin(), read.topic(), log.time(read), writer);
      }
      if (found != null && (oldest == null || isBehind(found, oldest))) {
        oldest = found;
      }
    }
    if (oldest != null) {
      for (SampleId sample : step.activation().writes()) {
        writers.put(sample, oldest);
      }
    }
    return oldest;
  }

  /** Returns whether one stimulus is older than another, or the same with a longer path. */
  private static boolean isBehind(Passage one, Passage other) {
    if (one.origin() != other.origin()) {
      return one.origin() < other.origin();
    }
    return one.since() > other.since();
  }
}
