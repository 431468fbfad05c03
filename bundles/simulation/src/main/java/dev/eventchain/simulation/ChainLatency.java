package dev.eventchain.simulation;

import dev.eventchain.simulation.RunLog.Activation;
import dev.eventchain.simulation.RunLog.SampleId;
import java.util.ArrayList;
import java.util.Comparator;
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
 */
final class ChainLatency {

  /** An activation of a node. */
  private record Step(String node, int position, Activation activation) {}

  /** What a written sample is based on: the oldest stimulus behind it, and when that was. */
  private record Origin(int writer, long time) {}

  private static final long NOTHING = -1;

  private final RunLog log;
  private final Set<String> first;
  private final Map<String, Integer> positions;
  private final Map<SampleId, Origin> origins = new HashMap<>();

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
  static List<Long> reactions(RunLog log, String source, String target) {
    Set<String> readers =
        log.nodes().keySet().stream()
            .filter(node -> reads(log, node).contains(source))
            .collect(Collectors.toSet());
    ChainLatency latency = new ChainLatency(log, readers, ActivationOrder.of(log, readers));
    List<Long> latencies = new ArrayList<>();
    Set<Long> answered = new HashSet<>();
    for (Step step : latency.steps()) {
      long origin = latency.follow(step, source);
      boolean commands =
          step.activation().writes().stream().anyMatch(sample -> sample.topic().equals(target));
      if (commands && origin != NOTHING && answered.add(origin)) {
        latencies.add(step.activation().end() - origin);
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
   * @return times in ns; empty if nothing that the last node did is based on an input of the first
   */
  static List<Long> between(RunLog log, String first, String last, boolean dataAge) {
    List<Long> latencies = new ArrayList<>();
    Map<String, Integer> positions = ActivationOrder.of(log, Set.of(first));
    for (String stimulus : stimuli(log, first, positions.keySet())) {
      ChainLatency latency = new ChainLatency(log, Set.of(first), positions);
      Set<Long> answered = new HashSet<>();
      for (Step step : latency.steps()) {
        long origin = latency.follow(step, stimulus);
        if (origin != NOTHING
            && step.node().equals(last)
            && latency.ends(step)
            && (answered.add(origin) || dataAge)) {
          latencies.add(step.activation().end() - origin);
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
   * @return when the oldest stimulus was, in ns
   */
  private long follow(Step step, String stimulus) {
    long oldest = NOTHING;
    boolean starts = first.contains(step.node());
    if (starts && stimulus.isEmpty()) {
      oldest = step.activation().start();
    }
    for (SampleId read : step.activation().reads()) {
      long found = NOTHING;
      Origin origin = origins.get(read);
      if (starts && read.topic().equals(stimulus)) {
        found = log.time(read);
      } else if (!starts && origin != null && origin.writer() < step.position()) {
        found = origin.time();
      }
      if (found != NOTHING && (oldest == NOTHING || found < oldest)) {
        oldest = found;
      }
    }
    if (oldest != NOTHING) {
      for (SampleId sample : step.activation().writes()) {
        origins.put(sample, new Origin(step.position(), oldest));
      }
    }
    return oldest;
  }
}
