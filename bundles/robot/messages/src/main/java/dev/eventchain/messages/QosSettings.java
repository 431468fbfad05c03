package dev.eventchain.messages;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Quality of service that a publisher offers or a subscription requests, as far as it decides
 * whether they match (OMG DDS 1.4, 2.2.3). Profiles have the names and values of {@code
 * rmw/qos_profiles.h}.
 *
 * @param deadline the longest time between two samples; empty if unbounded
 * @param lease the longest silence before a publisher loses its liveliness; empty if unbounded
 * @param depth the number of samples kept with {@link History#KEEP_LAST}; it does not affect
 *     matching
 */
public record QosSettings(
    Reliability reliability,
    Durability durability,
    History history,
    int depth,
    Optional<Duration> deadline,
    Liveliness liveliness,
    Optional<Duration> lease) {

  /** Retransmission of lost samples; stronger policies come later. */
  public enum Reliability {
    /** Lost samples are not sent again. */
    BEST_EFFORT,
    /** Lost samples are sent again. */
    RELIABLE,
    /** The policy that the middleware is configured for. */
    SYSTEM_DEFAULT,
    /** The policy that suits the remote endpoints that exist when the endpoint is created. */
    BEST_AVAILABLE
  }

  /** Delivery of earlier samples to late subscriptions; stronger policies come later. */
  public enum Durability {
    /** Late subscriptions get no earlier samples. */
    VOLATILE,
    /** Late subscriptions get the samples that the publisher still keeps. */
    TRANSIENT_LOCAL,
    /** The policy that the middleware is configured for. */
    SYSTEM_DEFAULT,
    /** The policy that suits the remote endpoints that exist when the endpoint is created. */
    BEST_AVAILABLE
  }

  /** Samples that are kept. */
  public enum History {
    /** The last samples. */
    KEEP_LAST,
    /** All samples. */
    KEEP_ALL,
    /** The policy that the middleware is configured for. */
    SYSTEM_DEFAULT
  }

  /** Assertion of a publisher's liveliness; stronger policies come later. */
  public enum Liveliness {
    /** By its process. Every implementation of rmw uses this policy where none is set. */
    AUTOMATIC,
    /** By the publisher itself, for this topic. */
    MANUAL_BY_TOPIC,
    /** The policy that suits the remote endpoints that exist when the endpoint is created. */
    BEST_AVAILABLE
  }

  /**
   * A policy for which an offer does not satisfy a request.
   *
   * @param policy by its DDS name: reliability, durability, deadline, liveliness, lease duration
   * @param offered the kind, or a time in ms, "50.5 ms", or {@link #NO_TIME}; requested as well
   * @param decided false if it depends on the middleware's configuration or on the time of
   *     discovery
   */
  public record Incompatibility(String policy, String offered, String requested, boolean decided) {}

  /** Name of an unbounded time. */
  public static final String NO_TIME = "none";

  private static final String SYSTEM_DEFAULT = "system_default";

  private static final QosSettings DEFAULT =
      new QosSettings(
          Reliability.RELIABLE,
          Durability.VOLATILE,
          History.KEEP_LAST,
          10,
          Optional.empty(),
          Liveliness.AUTOMATIC,
          Optional.empty());

  private static final Map<String, QosSettings> NAMED =
      Collections.unmodifiableMap(
          new TreeMap<>(
              Map.of(
                  "default",
                  DEFAULT,
                  "services_default",
                  DEFAULT,
                  "parameters",
                  DEFAULT.withDepth(1000),
                  "parameter_events",
                  DEFAULT.withDepth(1000),
                  "sensor_data",
                  DEFAULT.withReliability(Reliability.BEST_EFFORT).withDepth(5),
                  "action_status_default",
                  DEFAULT.withDurability(Durability.TRANSIENT_LOCAL).withDepth(1),
                  SYSTEM_DEFAULT,
                  DEFAULT
                      .withReliability(Reliability.SYSTEM_DEFAULT)
                      .withDurability(Durability.SYSTEM_DEFAULT)
                      .withHistory(History.SYSTEM_DEFAULT)
                      .withDepth(0),
                  "best_available",
                  DEFAULT
                      .withReliability(Reliability.BEST_AVAILABLE)
                      .withDurability(Durability.BEST_AVAILABLE)
                      .withLiveliness(Liveliness.BEST_AVAILABLE))));

  /** Returns the settings that apply by default: the profile {@code default}. */
  public static QosSettings defaults() {
    return DEFAULT;
  }

  /**
   * Returns a profile by its name in lower case, {@code sensor_data}; empty if ROS 2 has no such
   * profile.
   */
  public static Optional<QosSettings> named(String name) {
    return Optional.ofNullable(NAMED.get(name));
  }

  /** Returns the names of the profiles. */
  public static SortedSet<String> names() {
    return new TreeSet<>(NAMED.keySet());
  }

  /** Returns a copy with another reliability. */
  public QosSettings withReliability(Reliability value) {
    return new QosSettings(value, durability, history, depth, deadline, liveliness, lease);
  }

  /** Returns a copy with another durability. */
  public QosSettings withDurability(Durability value) {
    return new QosSettings(reliability, value, history, depth, deadline, liveliness, lease);
  }

  /** Returns a copy with another history. */
  public QosSettings withHistory(History value) {
    return new QosSettings(reliability, durability, value, depth, deadline, liveliness, lease);
  }

  /** Returns a copy with another depth. */
  public QosSettings withDepth(int value) {
    return new QosSettings(reliability, durability, history, value, deadline, liveliness, lease);
  }

  /** Returns a copy with a deadline. */
  public QosSettings withDeadline(Duration value) {
    return new QosSettings(
        reliability, durability, history, depth, Optional.of(value), liveliness, lease);
  }

  /** Returns a copy with another liveliness. */
  public QosSettings withLiveliness(Liveliness value) {
    return new QosSettings(reliability, durability, history, depth, deadline, value, lease);
  }

  /** Returns a copy with a lease duration. */
  public QosSettings withLease(Duration value) {
    return new QosSettings(
        reliability, durability, history, depth, deadline, liveliness, Optional.of(value));
  }

  /**
   * Returns the policies for which an offer does not satisfy a request, in the order of the table
   * in DDS. An offer satisfies a request for the same or a weaker policy. With {@code
   * SYSTEM_DEFAULT} and {@code BEST_AVAILABLE} this cannot always be decided.
   */
  public static List<Incompatibility> incompatibilities(
      QosSettings offered, QosSettings requested) {
    List<Incompatibility> found = new ArrayList<>();
    compare(
        "reliability",
        offered.reliability,
        requested.reliability,
        Reliability.BEST_EFFORT,
        Reliability.RELIABLE,
        found);
    compare(
        "durability",
        offered.durability,
        requested.durability,
        Durability.VOLATILE,
        Durability.TRANSIENT_LOCAL,
        found);
    // A profile with "best available" policies adapts its times, too.
    boolean decided = offered.liveliness != Liveliness.BEST_AVAILABLE;
    compare("deadline", offered.deadline, requested.deadline, decided, found);
    compare(
        "liveliness",
        offered.liveliness,
        requested.liveliness,
        Liveliness.AUTOMATIC,
        Liveliness.MANUAL_BY_TOPIC,
        found);
    compare("lease duration", offered.lease, requested.lease, decided, found);
    return List.copyOf(found);
  }

  private static <E extends Enum<E>> void compare(
      String policy, E offered, E requested, E weak, E strong, List<Incompatibility> found) {
    if (offered == strong || requested == weak) {
      return; // the strongest is offered, or the weakest requested: the other side does not matter
    }
    boolean decided = offered == weak && requested == strong;
    found.add(new Incompatibility(policy, offered.name(), requested.name(), decided));
  }

  private static void compare(
      String policy,
      Optional<Duration> offered,
      Optional<Duration> requested,
      boolean decided,
      List<Incompatibility> found) {
    if (requested.isPresent()
        && (offered.isEmpty() || offered.get().compareTo(requested.get()) > 0)) {
      found.add(new Incompatibility(policy, text(offered), text(requested), decided));
    }
  }

  /** Returns a time in ms as text. */
  private static String text(Optional<Duration> time) {
    if (time.isEmpty()) {
      return NO_TIME;
    }
    return new BigDecimal(time.get().toNanos())
            .movePointLeft(6)
            .stripTrailingZeros()
            .toPlainString()
        + " ms";
  }
}
