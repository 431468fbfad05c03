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

/**
 * The time from a sensor sample to the first command that is based on it, along the activation
 * graph: an activation's outputs are based on all that it read from nodes before it in the chain;
 * what it reads from itself or from later nodes is feedback and not followed. Where paths of
 * different length join, the oldest sensor sample counts. A command that repeats an older sample
 * adds nothing: what counts is the reaction to each sample (first-to-first, as in the maximum
 * reaction time).
 */
final class ChainLatency {

  /** An activation of the node at a position in the chain. */
  private record Step(int position, Activation activation) {}

  /** What a written sample is based on: the oldest sensor sample behind it. */
  private record Origin(int writer, long sensorSample) {}

  private static final long NOTHING = -1;

  private ChainLatency() {}

  /**
   * Follows the graph.
   *
   * @param log what the nodes did, the nodes in chain order
   * @param source the sensor's topic
   * @param target the command's topic
   * @return latencies in ns, in the order of the commands
   */
  static List<Long> of(RunLog log, String source, String target) {
    Map<SampleId, Origin> origins = new HashMap<>();
    Set<Long> answered = new HashSet<>();
    List<Long> latencies = new ArrayList<>();
    for (Step step : steps(log)) {
      long origin = origin(step, origins, source);
      for (SampleId sample : step.activation().writes()) {
        origins.put(sample, new Origin(step.position(), origin));
        if (sample.topic().equals(target) && origin != NOTHING && answered.add(origin)) {
          latencies.add(log.time(sample) - log.time(new SampleId(source, origin)));
        }
      }
    }
    return latencies;
  }

  /** All activations, each after those whose samples it can have read. */
  private static List<Step> steps(RunLog log) {
    List<Step> steps = new ArrayList<>();
    int position = 0;
    for (List<Activation> activations : log.nodes().values()) {
      for (Activation activation : activations) {
        steps.add(new Step(position, activation));
      }
      position++;
    }
    steps.sort(
        Comparator.comparingLong((Step step) -> step.activation().start())
            .thenComparingInt(Step::position));
    return steps;
  }

  private static long origin(Step step, Map<SampleId, Origin> origins, String source) {
    long oldest = NOTHING;
    for (SampleId read : step.activation().reads()) {
      long found = NOTHING;
      Origin origin = origins.get(read);
      if (read.topic().equals(source)) {
        found = read.sequence();
      } else if (origin != null && origin.writer() < step.position()) {
        found = origin.sensorSample();
      }
      if (found != NOTHING && (oldest == NOTHING || found < oldest)) {
        oldest = found;
      }
    }
    return oldest;
  }
}
