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
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * The time from a stimulus to what is based on it, along the activation graph: an activation's
 * outputs are based on all that it read from nodes before it; what it reads from itself or from
 * later nodes is feedback and not followed ({@link ActivationOrder}). Where paths of different
 * length join, the oldest stimulus counts.
 *
 * <p>The reaction time counts the first output that is based on a stimulus (first-to-first, as in
 * the maximum reaction time); the data age counts every output. Both end when the activation does
 * and its outputs can be seen.
 *
 * <p>A time is the sum of its hops: how old each sample on the way was when it was read, and how
 * long its reader took from there to the next sample ({@link MessageFlow}).
 */
public final class ChainLatency {

  /** An activation of a node. */
  private record Step(String node, int position, Activation activation) {}

  /**
   * What an activation is based on: the oldest stimulus behind it, and the way from there. Where
   * several ways lead there, it is the one whose sample came last.
   *
   * @param origin when the stimulus was, in ns
   * @param topic that of the sample that led to this activation; empty if none did
   * @param since when that sample could be seen, in ns; that of the stimulus if none did
   * @param before the activation whose sample led to this one; null if the stimulus did
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
   * What a node contributes to a latency, in ns: the hop to it, and what it makes of the sample.
   *
   * @param topic that of the hop; empty if the node's activation is the stimulus
   * @param waiting how old the sample was at the node's start
   * @param execution from its start to the moment at which its sample could be seen by the next
   *     node; to its end for the last one
   */
  public record Part(String topic, String node, long waiting, long execution) {}

  /**
   * A time from a stimulus to what is based on it.
   *
   * @param time in ns
   * @param parts what it consists of, in the order of the data; they sum up to it
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

  private final RunLog log;
  private final Set<String> first;
  private final Map<String, Integer> positions;
  private final Map<SampleId, Passage> writers = new HashMap<>();

  private ChainLatency(RunLog log, Set<String> first, Map<String, Integer> positions) {
    this.log = log;
    this.first = first;
    this.positions = positions;
  }

  /**
   * Reaction times from the samples of a sensor to the commands that are based on them.
   *
   * @param source the sensor's topic, whichever nodes read it
   * @param target the command's topic
   * @return latencies in ns, in the order of the commands
   */
  public static List<Long> reactions(RunLog log, String source, String target) {
    Set<String> readers =
        log.nodes().keySet().stream()
            .filter(node -> reads(log, node).contains(source))
            .collect(Collectors.toSet());
    ChainLatency latency = new ChainLatency(log, readers, ActivationOrder.of(log, readers));
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
   * The times between two nodes: from each sample that comes to the first one from outside, or from
   * its activation if none does, to the outputs of the last one.
   *
   * @param first the node whose inputs start the time
   * @param last the node whose outputs end it; its activation if it writes nothing at all
   * @param dataAge whether every output counts, not only the first one based on a sample
   * @return none if nothing that the last node did is based on an input of the first
   */
  public static List<Latency> between(RunLog log, String first, String last, boolean dataAge) {
    List<Latency> latencies = new ArrayList<>();
    Map<String, Integer> positions = ActivationOrder.of(log, Set.of(first));
    for (String stimulus : stimuli(log, first, positions.keySet())) {
      ChainLatency latency = new ChainLatency(log, Set.of(first), positions);
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

  /** The topics that a node reads and no node behind it writes; an empty name if there is none. */
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

  /** Whether an activation of the last node is one that counts. */
  private boolean ends(Step step) {
    return !step.activation().writes().isEmpty()
        || log.nodes().get(step.node()).stream().allMatch(each -> each.writes().isEmpty());
  }

  /** All activations, each after those whose samples it can have read. */
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
   * Notes what the outputs of an activation are based on.
   *
   * @param stimulus the topic whose samples the first node is stimulated by; empty for its
   *     activation
   * @return how the oldest stimulus came to the activation; null if none did
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
        long time = log.time(read);
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

  /** Whether one stimulus is older than another, or the same one that took a longer way. */
  private static boolean isBehind(Passage one, Passage other) {
    if (one.origin() != other.origin()) {
      return one.origin() < other.origin();
    }
    return one.since() > other.since();
  }
}
