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
 * graph: an activation's outputs are based on all that it read. Where paths of different length
 * join, the oldest sensor sample counts. A command that repeats an older sample adds nothing: what
 * counts is the reaction to each sample (first-to-first, as in the maximum reaction time).
 */
final class ChainLatency {

  private static final long NOTHING = -1;

  private final RunLog log;
  private final String source;
  private final List<Activation> activations = new ArrayList<>();
  private final Set<SampleId> written = new HashSet<>();

  /** For each sample that an activation wrote: the oldest sensor sample behind it, or nothing. */
  private final Map<SampleId, Long> origins = new HashMap<>();

  private ChainLatency(RunLog log, String source) {
    this.log = log;
    this.source = source;
    log.nodes().values().forEach(activations::addAll);
    activations.sort(Comparator.comparingLong(Activation::start));
    activations.forEach(activation -> written.addAll(activation.writes()));
  }

  /**
   * Follows the graph.
   *
   * @param source the sensor's topic
   * @param target the command's topic
   * @return latencies in ns, in the order of the commands
   */
  static List<Long> of(RunLog log, String source, String target) {
    ChainLatency graph = new ChainLatency(log, source);
    graph.findOrigins();
    return graph.latencies(target);
  }

  /**
   * An activation can read only what was visible when it started, so its producers are met before
   * it; unless they start at the same instant and take no time, which a further round finds.
   */
  private void findOrigins() {
    List<Activation> open = activations;
    int before;
    do {
      before = open.size();
      List<Activation> later = new ArrayList<>();
      for (Activation activation : open) {
        if (isReady(activation)) {
          propagate(activation);
        } else {
          later.add(activation);
        }
      }
      open = later;
    } while (!open.isEmpty() && open.size() < before);
  }

  private boolean isReady(Activation activation) {
    return activation.reads().stream()
        .allMatch(read -> !written.contains(read) || origins.containsKey(read));
  }

  private void propagate(Activation activation) {
    long oldest = NOTHING;
    for (SampleId read : activation.reads()) {
      boolean sensed = read.topic().equals(source);
      long origin = sensed ? read.sequence() : origins.getOrDefault(read, NOTHING);
      if (origin != NOTHING && (oldest == NOTHING || origin < oldest)) {
        oldest = origin;
      }
    }
    for (SampleId sample : activation.writes()) {
      origins.put(sample, oldest);
    }
  }

  private List<Long> latencies(String target) {
    Set<Long> answered = new HashSet<>();
    List<Long> latencies = new ArrayList<>();
    for (Activation activation : activations) {
      for (SampleId command : activation.writes()) {
        long origin =
            command.topic().equals(target) ? origins.getOrDefault(command, NOTHING) : NOTHING;
        if (origin != NOTHING && answered.add(origin)) {
          latencies.add(log.time(command) - log.time(new SampleId(source, origin)));
        }
      }
    }
    return latencies;
  }
}
