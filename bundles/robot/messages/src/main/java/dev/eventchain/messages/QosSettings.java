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
 * The quality of service that a publisher offers or a subscriber requests, as far as it decides
 * whether samples flow between them (OMG DDS 1.4, 2.2.3). Profiles have the names and values of
 * {@code rmw/qos_profiles.h}.
 *
 * @param deadline the longest time between two samples; empty for any time
 * @param lease how long a publisher may be silent before it counts as gone; empty for any time
 * @param depth how many samples are kept with {@link History#KEEP_LAST}; it decides nothing here
 */
public record QosSettings(
    Reliability reliability,
    Durability durability,
    History history,
    int depth,
    Optional<Duration> deadline,
    Liveliness liveliness,
    Optional<Duration> lease) {

  /** Whether lost samples are sent again; the stronger a policy, the later it stands. */
  public enum Reliability {
    /** They are not. */
    BEST_EFFORT,
    /** They are. */
    RELIABLE,
    /** What the middleware is configured to do. */
    SYSTEM_DEFAULT,
    /** What suits the other sides that exist when the endpoint is made. */
    BEST_AVAILABLE
  }

  /** Whether late subscribers get earlier samples; the stronger a policy, the later it stands. */
  public enum Durability {
    /** They do not. */
    VOLATILE,
    /** They get what the publisher still keeps. */
    TRANSIENT_LOCAL,
    /** What the middleware is configured to do. */
    SYSTEM_DEFAULT,
    /** What suits the other sides that exist when the endpoint is made. */
    BEST_AVAILABLE
  }

  /** Which samples are kept. */
  public enum History {
    /** The last ones. */
    KEEP_LAST,
    /** All. */
    KEEP_ALL,
    /** What the middleware is configured to do. */
    SYSTEM_DEFAULT
  }

  /** How a publisher shows that it is alive; the stronger a policy, the later it stands. */
  public enum Liveliness {
    /** Its process does. Every implementation of rmw takes this where nothing is set. */
    AUTOMATIC,
    /** It does itself, for this topic. */
    MANUAL_BY_TOPIC,
    /** What suits the other sides that exist when the endpoint is made. */
    BEST_AVAILABLE
  }

  /**
   * A policy for which an offer does not satisfy a request.
   *
   * @param policy as DDS calls it: reliability, durability, deadline, liveliness, lease duration
   * @param offered the kind, or a time in ms, "50.5 ms", or {@link #NO_TIME}; requested as well
   * @param decided false where it depends on the middleware's configuration or on the moment
   */
  public record Incompatibility(String policy, String offered, String requested, boolean decided) {}

  /** How a time is called that is not bounded. */
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

  /** What holds where nothing is said: the profile {@code default}. */
  public static QosSettings defaults() {
    return DEFAULT;
  }

  /** A profile by its name in lower case, {@code sensor_data}; empty if ROS 2 has none such. */
  public static Optional<QosSettings> named(String name) {
    return Optional.ofNullable(NAMED.get(name));
  }

  /** The names of the profiles. */
  public static SortedSet<String> names() {
    return new TreeSet<>(NAMED.keySet());
  }

  /** The same with another reliability. */
  public QosSettings withReliability(Reliability value) {
    return new QosSettings(value, durability, history, depth, deadline, liveliness, lease);
  }

  /** The same with another durability. */
  public QosSettings withDurability(Durability value) {
    return new QosSettings(reliability, value, history, depth, deadline, liveliness, lease);
  }

  /** The same with another history. */
  public QosSettings withHistory(History value) {
    return new QosSettings(reliability, durability, value, depth, deadline, liveliness, lease);
  }

  /** The same with another depth. */
  public QosSettings withDepth(int value) {
    return new QosSettings(reliability, durability, history, value, deadline, liveliness, lease);
  }

  /** The same with a deadline. */
  public QosSettings withDeadline(Duration value) {
    return new QosSettings(
        reliability, durability, history, depth, Optional.of(value), liveliness, lease);
  }

  /** The same with another liveliness. */
  public QosSettings withLiveliness(Liveliness value) {
    return new QosSettings(reliability, durability, history, depth, deadline, value, lease);
  }

  /** The same with a lease duration. */
  public QosSettings withLease(Duration value) {
    return new QosSettings(
        reliability, durability, history, depth, deadline, liveliness, Optional.of(value));
  }

  /**
   * The policies for which an offer does not satisfy a request, in the order of DDS's table: an
   * offer satisfies a request that asks for the same or less. With {@code SYSTEM_DEFAULT} and
   * {@code BEST_AVAILABLE} that cannot always be told.
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
    // A profile that takes the best it can have adapts its times, too.
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
      return; // the most is offered, or the least requested: the other side does not matter
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

  /** A time as people write it, in ms. */
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
