package dev.eventchain.simulation.verdict;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * Flow of messages from their writers to their readers, in one scenario or in all of them. Times
 * are in ms of scenario time.
 *
 * <p>A latency along the chain ({@link ScenarioVerdict.Latency}) is the sum of its hops: for each
 * sample on the path, its age when its reader started ({@link Hop#age}), and the time until the
 * reader published the next one ({@link Processing}). Where no sample is used twice, each age is a
 * {@link Hop#waiting}.
 *
 * @param hops by the reading components, in chain order, and then those to the vehicle
 * @param processing one for each component, in chain order
 * @param topics those of the hops
 */
public record MessageFlow(List<Hop> hops, List<Processing> processing, List<Topic> topics) {

  /**
   * Name of the writer or reader of a topic that is not a component; no component can have this
   * name.
   */
  public static final String VEHICLE = "the vehicle";

  /** Copies the lists. */
  public MessageFlow {
    hops = List.copyOf(hops);
    processing = List.copyOf(processing);
    topics = List.copyOf(topics);
  }

  /**
   * A topic from one of its writers to one of its readers. The reads of the vehicle, and of a
   * component that was never activated, are unknown: all of them are empty then.
   *
   * @param writer a component's name, or {@link #VEHICLE}
   * @param reader a component's name, or {@link #VEHICLE}
   * @param waiting of each sample that was read, from its publication to the start of the
   *     activation that read it first; empty if there is none
   * @param age at each start of an activation, the age of the sample that it read, whether for the
   *     first time or not; empty if it never read one
   * @param samples the fate of the samples; empty if unknown
   * @param tooOld the number of these starts with a sample older than the model allows; empty if
   *     the model states no limit, or nothing was read
   * @param late the number of samples that missed the deadline of the topic's quality of service;
   *     empty if none is stated, or there are fewer than two samples
   */
  public record Hop(
      String topic,
      String writer,
      String reader,
      Optional<Measurements.Statistics> waiting,
      Optional<Measurements.Statistics> age,
      Optional<Samples> samples,
      Optional<Exceeded> tooOld,
      Optional<Exceeded> late) {

    /** Returns a description: {@code /scan from A to B}. */
    public String words() {
      return topic + " from " + writer + " to " + reader;
    }
  }

  /**
   * Fate of a writer's samples at one of their readers.
   *
   * @param published all of them, the sum of the others
   * @param read samples that at least one activation read
   * @param neverRead samples that no activation read, although one started after their publication:
   *     a later one had replaced them in a history or at the component's input, or they did not
   *     arrive
   * @param unreadAtEnd samples published after the last activation had started
   */
  public record Samples(long published, long read, long neverRead, long unreadAtEnd) {}

  /**
   * Number of times that a limit of the model was exceeded.
   *
   * @param limit the limit, in ms
   * @param times the number of times
   * @param of the number of possible times, at least 1
   */
  public record Exceeded(double limit, long times, long of) {}

  /**
   * Time of a component from the start of an activation to its publication.
   *
   * @param time of each published sample; empty if there is none
   */
  public record Processing(String node, Optional<Measurements.Statistics> time) {}

  /**
   * The messages of a topic.
   *
   * @param published messages visible to others; empty if none was seen, and none of the components
   *     that write it was ever activated
   * @param dropped messages that the bench lost on purpose, which do not count as published; empty
   *     where the vehicle does not provide the topic
   * @param lost messages lost on the way, summed over all their receivers; empty where the driver
   *     does not count
   */
  public record Topic(
      String name, OptionalLong published, OptionalLong dropped, OptionalLong lost) {}
}
