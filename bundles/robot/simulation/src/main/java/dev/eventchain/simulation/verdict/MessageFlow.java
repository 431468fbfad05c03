package dev.eventchain.simulation.verdict;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * How messages got from their writers to their readers, in one scenario or in all of them. Times
 * are in ms of the time of the scenario.
 *
 * <p>A latency along the chain ({@link ScenarioVerdict.Latency}) is the sum of its hops: of each
 * sample on the way, how old it was when its reader started ({@link Hop#age}), and how long that
 * took to publish the next one ({@link Processing}). Where no sample is used twice, each age is a
 * {@link Hop#waiting}.
 *
 * @param hops by the components that read, in chain order, and then those to the vehicle
 * @param processing one for each component, in chain order
 * @param topics those of the hops
 */
public record MessageFlow(List<Hop> hops, List<Processing> processing, List<Topic> topics) {

  /** Who reads or writes a topic where it is not a component; no component can have this name. */
  public static final String VEHICLE = "the vehicle";

  /** Copies the lists. */
  public MessageFlow {
    hops = List.copyOf(hops);
    processing = List.copyOf(processing);
    topics = List.copyOf(topics);
  }

  /**
   * A topic on the way from one that writes it to one that reads it. What the vehicle reads, and
   * what a component reads that was never activated, is not known: all of it is empty then.
   *
   * @param writer a component's name, or {@link #VEHICLE}
   * @param reader a component's name, or {@link #VEHICLE}
   * @param waiting of each sample that was read, from its publication to the start of the
   *     activation that read it first; empty if none was
   * @param age at each start of an activation, how old the sample was that it read, whether it was
   *     its first reading or not; empty if it never read one
   * @param samples what became of the samples; empty if that is not known
   * @param tooOld at how many of these starts the sample was older than the model allows; empty if
   *     the model states no limit, or nothing was read
   * @param late how many samples came later after the one before them than the deadline of the
   *     topic's quality of service; empty if none is stated, or there are not two samples
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

    /** Words for it: {@code /scan from A to B}. */
    public String words() {
      return topic + " from " + writer + " to " + reader;
    }
  }

  /**
   * What became of the samples that one published, at one that reads them.
   *
   * @param published all of them; the others sum up to it
   * @param read those that at least one activation read
   * @param neverRead those that no activation read, although one started when they could be seen: a
   *     later one had taken their place in a history or at the component's input, or they did not
   *     arrive
   * @param unreadAtEnd those that came after the last activation had started
   */
  public record Samples(long published, long read, long neverRead, long unreadAtEnd) {}

  /**
   * How often a number that the model states was exceeded.
   *
   * @param limit the number, in ms
   * @param times how often
   * @param of how often it could have been; at least 1
   */
  public record Exceeded(double limit, long times, long of) {}

  /**
   * How long a component took from the start of an activation to what it published.
   *
   * @param time of each sample that it published; empty if it published nothing
   */
  public record Processing(String node, Optional<Measurements.Statistics> time) {}

  /**
   * The messages of a topic.
   *
   * @param published those that could be seen by others; empty if none was seen, and none of the
   *     components that write it was ever activated
   * @param dropped those that the bench lost on purpose, which are not among the published ones;
   *     empty where the vehicle does not provide the topic
   * @param lost those that got lost on the way, summed up over all that should have received them;
   *     empty where the driver does not count
   */
  public record Topic(
      String name, OptionalLong published, OptionalLong dropped, OptionalLong lost) {}
}
