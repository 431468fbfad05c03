package dev.eventchain.dds;

import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.QosSettings;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/**
 * A participant of a DDS domain: creates writers and readers of topics, and announces them as ROS 2
 * does. Thread-safe. After {@link #close}, it and its endpoints throw an {@link
 * IllegalStateException}.
 */
public final class DdsParticipant implements AutoCloseable {

  /** The highest domain number for which ports exist (RTPS 2.5, 9.6.2.3). */
  public static final int HIGHEST_DOMAIN = 232;

  private static final Pattern TAG = Pattern.compile("[A-Za-z0-9_.-]{1,64}");

  /** User data with which rmw_cyclonedds announces a node outside security enclaves. */
  private static final String USER_DATA = "enclave=/;";

  private record Topic(MessageType type, int handle) {}

  /**
   * A writer or a reader of another participant.
   *
   * @param writes true for a writer, false for a reader
   * @param topic the full name in ROS 2, {@code /scan}
   * @param type the full name in ROS 2, {@code sensor_msgs/msg/LaserScan}, or the DDS name if it is
   *     not a type of ROS 2
   * @param qos the policies that decide whether endpoints match
   * @param typeHash hash of the type definition, see {@link MessageType#hash}; empty if not
   *     announced (before Iron)
   * @param node the full name of its node; empty if not announced
   * @param participant identifier of its participant
   * @param id unique identifier of the endpoint
   * @param handle value of {@link DdsSample#publication} for samples of this writer
   */
  public record Peer(
      boolean writes,
      String topic,
      String type,
      QosSettings qos,
      String typeHash,
      String node,
      String participant,
      String id,
      long handle) {

    static final Comparator<Peer> ORDER =
        Comparator.comparing(Peer::topic)
            .thenComparing(Peer::writes)
            .thenComparing(Peer::node)
            .thenComparing(Peer::id);
  }

  private final Cyclone cyclone;
  private final Domain domain;
  private final GraphFormat graphFormat;
  private final int handle;
  private final DynamicTypes types;
  private final Map<String, Topic> topics = new HashMap<>();
  private final List<DdsEndpoint> endpoints = new ArrayList<>();
  private Optional<Graph> graph = Optional.empty();
  private Optional<Discovery> discovery = Optional.empty();
  private boolean closed;

  private DdsParticipant(Cyclone cyclone, Domain domain, GraphFormat graphFormat) {
    this.cyclone = cyclone;
    this.domain = domain;
    this.graphFormat = graphFormat;
    handle =
        Policies.with(
            cyclone,
            USER_DATA,
            qos ->
                Codes.check(
                    cyclone,
                    cyclone.createParticipant(domain.id(), qos, null),
                    "take part in domain " + domain.id()));
    types = new DynamicTypes(cyclone, handle);
  }

  /**
   * Joins a domain with a configuration of Cyclone DDS. Nodes are announced as ROS 2 does from Iron
   * on.
   *
   * @throws IllegalArgumentException as {@link #on(DdsLibrary, int, String, String)}
   * @throws IllegalStateException as {@link #on(DdsLibrary, int, String, String)}
   */
  public static DdsParticipant on(DdsLibrary library, int domainId, String configuration) {
    return on(library, domainId, configuration, "");
  }

  /**
   * Joins a domain with a configuration of Cyclone DDS.
   *
   * @param domainId 0 to {@link #HIGHEST_DOMAIN}
   * @param configuration the XML of Cyclone DDS; the same for all participants of this process in a
   *     domain
   * @param distribution the ROS 2 release of the other nodes, as in {@code ROS_DISTRO}, which
   *     determines the format of their discovery messages; empty for the newest
   * @throws IllegalArgumentException if the domain does not exist, or the configuration is invalid
   * @throws IllegalStateException if this process uses the domain with another configuration
   */
  public static DdsParticipant on(
      DdsLibrary library, int domainId, String configuration, String distribution) {
    Domain domain = Domain.join(library.cyclone(), domainId, configuration);
    try {
      return new DdsParticipant(library.cyclone(), domain, GraphFormat.of(distribution));
    } catch (RuntimeException e) {
      Domain.leave(library.cyclone(), domain);
      throw e;
    }
  }

  /**
   * Joins a domain that does not leave this machine.
   *
   * @param tag see {@link #loopbackConfiguration}
   * @throws IllegalArgumentException as {@link #on}, and for an invalid tag
   * @throws IllegalStateException as {@link #on}
   */
  public static DdsParticipant loopback(DdsLibrary library, int domainId, String tag) {
    return on(library, domainId, loopbackConfiguration(tag));
  }

  /**
   * Returns the configuration of {@link #loopback}, for processes that communicate there. It is
   * bound to the loopback interface, which often has no multicast, so that up to 100 processes are
   * found by their ports.
   *
   * @param tag only processes with the same tag find each other: letters, digits, {@code _.-}, at
   *     most 64
   * @throws IllegalArgumentException for an invalid tag
   */
  public static String loopbackConfiguration(String tag) {
    if (!TAG.matcher(tag).matches()) {
      throw new IllegalArgumentException(
          "'" + tag + "' is not a tag: up to 64 letters, digits, '_', '.' and '-'.");
    }
    return loopback("<Tag>" + tag + "</Tag>");
  }

  /**
   * Returns the configuration of {@link #loopback} without a tag: it reaches every participant on
   * the loopback interface.
   */
  public static String loopbackConfiguration() {
    return loopback("");
  }

  /** Returns the loopback configuration with further discovery settings. */
  static String loopback(String discovery) {
    return "<CycloneDDS><Domain id=\"any\"><General><Interfaces>"
        + "<NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>"
        + "<AllowMulticast>false</AllowMulticast></General><Discovery>"
        + "<ParticipantIndex>auto</ParticipantIndex>"
        + "<MaxAutoParticipantIndex>99</MaxAutoParticipantIndex>"
        + "<Peers><Peer address=\"127.0.0.1\"/></Peers>"
        + discovery
        + "</Discovery></Domain></CycloneDDS>";
  }

  /**
   * Creates a writer.
   *
   * @param topic the full name in ROS 2, {@code /scan}
   * @throws IllegalArgumentException if the topic is not a full name, or this participant has it
   *     with another type
   */
  public synchronized DdsWriter writer(String topic, MessageType type, QosSettings qos) {
    DdsWriter writer =
        new DdsWriter(this, new DdsTopic(cyclone, DdsNames.topic(topic), topic, type), qos);
    return added(writer);
  }

  /**
   * Creates a reader whose samples are taken with {@link DdsReader#take}.
   *
   * @throws IllegalArgumentException as {@link #writer}
   */
  public DdsReader reader(String topic, MessageType type, QosSettings qos) {
    return reader(topic, type, qos, Optional.empty());
  }

  /**
   * Creates a reader that passes each sample to a listener, one at a time, in its own thread.
   * Exceptions of the listener go to that thread's handler of uncaught exceptions; the next sample
   * follows.
   *
   * @throws IllegalArgumentException as {@link #writer}
   */
  public DdsReader reader(
      String topic, MessageType type, QosSettings qos, Consumer<DdsSample> listener) {
    return reader(topic, type, qos, Optional.of(listener));
  }

  private synchronized DdsReader reader(
      String topic, MessageType type, QosSettings qos, Optional<Consumer<DdsSample>> listener) {
    DdsReader reader =
        new DdsReader(this, new DdsTopic(cyclone, DdsNames.topic(topic), topic, type), qos);
    added(reader);
    listener.ifPresent(reader::start);
    return reader;
  }

  private <E extends DdsEndpoint> E added(E endpoint) {
    endpoints.add(endpoint);
    graph.ifPresent(announced -> announced.add(endpoint));
    return endpoint;
  }

  /**
   * Announces this participant as a node, with all its writers and readers, so that the tools of
   * ROS 2 list it.
   *
   * @param node a name in the root namespace, {@code eventchain_world}
   * @throws IllegalStateException if it is already announced
   */
  public synchronized void announce(String node) {
    requireOpen();
    if (graph.isPresent()) {
      throw new IllegalStateException("This participant is already announced.");
    }
    List<DdsEndpoint> known = List.copyOf(endpoints);
    Graph announced = new Graph(this, cyclone, node);
    known.forEach(announced::add);
    graph = Optional.of(announced);
  }

  /**
   * Returns the writers and readers of other participants on ROS 2 topics of this domain that have
   * been discovered so far, in a fixed order.
   *
   * @throws IllegalStateException if this participant is, or gets, closed
   */
  public List<Peer> peers() {
    return discovery().peers();
  }

  private synchronized Discovery discovery() {
    requireOpen();
    if (discovery.isEmpty()) {
      discovery = Optional.of(new Discovery(this, cyclone));
    }
    return discovery.get();
  }

  /** Returns the topic with a DDS name, which is created on first use. Holds the lock. */
  synchronized int topic(String name, MessageType type) {
    requireOpen();
    Topic known = topics.get(name);
    if (known == null) {
      known = new Topic(type, types.topic(name, type));
      topics.put(name, known);
    } else if (!known.type.equals(type)) {
      throw new IllegalArgumentException(
          "Topic " + name + " has the type " + known.type + ", not " + type + ".");
    }
    return known.handle;
  }

  GraphFormat graphFormat() {
    return graphFormat;
  }

  int handle() {
    return handle;
  }

  synchronized void requireOpen() {
    if (closed) {
      throw new IllegalStateException("This participant is closed.");
    }
  }

  /** Forgets a closed endpoint. */
  synchronized void removed(DdsEndpoint endpoint) {
    if (endpoints.remove(endpoint) && !closed) {
      graph.ifPresent(announced -> announced.remove(endpoint));
    }
  }

  /** Closes it with its writers and readers. Waits for running listeners. */
  @Override
  public void close() {
    List<DdsEndpoint> open;
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      open = List.copyOf(endpoints);
    }
    // Without the lock, since a listener may be waiting for it.
    open.forEach(DdsEndpoint::close);
    cyclone.delete(handle);
    Domain.leave(cyclone, domain);
  }
}
