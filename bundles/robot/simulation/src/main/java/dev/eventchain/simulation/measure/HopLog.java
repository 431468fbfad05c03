package dev.eventchain.simulation.measure;

import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Hops and processing times in the log of a scenario. Times are in ns. */
final class HopLog {

  /**
   * Samples of a hop.
   *
   * @param isKnown true if the reader was activated at least once, so that its reads are known
   * @param waiting age of each read sample at its first reading
   * @param ages age of the sample at each activation that read one
   * @param samples the fate of the samples; all zero if unknown
   */
  record Passed(
      boolean isKnown, List<Long> waiting, List<Long> ages, MessageFlow.Samples samples) {}

  private final RunLog log;
  private final Map<SampleId, String> writers = new HashMap<>();

  HopLog(RunLog log) {
    this.log = log;
    log.nodes()
        .forEach(
            (node, activations) ->
                activations.forEach(
                    each -> each.writes().forEach(sample -> writers.put(sample, node))));
  }

  /**
   * Returns whether a writer wrote a sample; samples without a writing activation are the
   * vehicle's.
   */
  private boolean isBy(String writer, SampleId sample) {
    return writers.getOrDefault(sample, MessageFlow.VEHICLE).equals(writer);
  }

  /** Returns the samples of a topic from a writer to a reader. */
  Passed passed(String topic, String writer, String reader) {
    List<Activation> activations = log.nodes().getOrDefault(reader, List.of());
    List<Long> waiting = new ArrayList<>();
    List<Long> ages = new ArrayList<>();
    Set<SampleId> read = new HashSet<>();
    for (Activation activation : activations) {
      for (SampleId sample : activation.reads()) {
        if (sample.topic().equals(topic) && isBy(writer, sample)) {
          long age = activation.start() - log.time(sample);
          ages.add(age);
          if (read.add(sample)) {
            waiting.add(age);
          }
        }
      }
    }
    if (activations.isEmpty()) {
      return new Passed(false, waiting, ages, new MessageFlow.Samples(0, 0, 0, 0));
    }
    long last = activations.get(activations.size() - 1).start();
    return new Passed(true, waiting, ages, samples(topic, writer, read, last));
  }

  private MessageFlow.Samples samples(
      String topic, String writer, Set<SampleId> read, long lastStart) {
    long published = 0;
    long unreadAtEnd = 0;
    for (Map.Entry<Long, Long> publication : log.publicationsOf(topic).entrySet()) {
      SampleId sample = new SampleId(topic, publication.getKey());
      if (isBy(writer, sample)) {
        published++;
        unreadAtEnd += publication.getValue() > lastStart && !read.contains(sample) ? 1 : 0;
      }
    }
    long neverRead = published - read.size() - unreadAtEnd;
    return new MessageFlow.Samples(published, read.size(), neverRead, unreadAtEnd);
  }

  /** Returns whether a node was activated at least once. */
  boolean isActive(String node) {
    return !log.nodes().getOrDefault(node, List.of()).isEmpty();
  }

  /** Returns the times between consecutive samples of a writer on a topic. */
  List<Long> gaps(String topic, String writer) {
    List<Long> times =
        log.publicationsOf(topic).entrySet().stream()
            .filter(each -> isBy(writer, new SampleId(topic, each.getKey())))
            .map(Map.Entry::getValue)
            .sorted()
            .toList();
    List<Long> gaps = new ArrayList<>();
    for (int i = 1; i < times.size(); i++) {
      gaps.add(times.get(i) - times.get(i - 1));
    }
    return gaps;
  }

  /** Returns the time from the start of its activation to the publication, for each sample. */
  List<Long> processing(String node) {
    return log.nodes().getOrDefault(node, List.of()).stream()
        .flatMap(each -> each.writes().stream().map(sample -> log.time(sample) - each.start()))
        .toList();
  }
}
