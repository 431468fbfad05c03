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
 * Takes part in a domain: makes writers and readers of topics, and announces them as ROS 2 does.
 * Thread-safe. After {@link #close}, it and all that it made throw an {@link
 * IllegalStateException}.
 */
public final class DdsParticipant implements AutoCloseable {

  /** The ports of domains with higher numbers do not exist (RTPS 2.5, 9.6.2.3). */
  public static final int HIGHEST_DOMAIN = 232;

  private static final Pattern TAG = Pattern.compile("[A-Za-z0-9_.-]{1,64}");

  /** As rmw_cyclonedds announces a node outside security enclaves. */
  private static final String USER_DATA = "enclave=/;";

  private record Topic(MessageType type, int handle) {}

  /**
   * A writer or a reader of another participant.
   *
   * @param writes whether it is a writer
   * @param topic the full name in ROS 2, {@code /scan}
   * @param type the full name in ROS 2, {@code sensor_msgs/msg/LaserScan}, or that of DDS if it is
   *     no type of ROS 2
   * @param qos as far as it decides whether samples flow
   * @param typeHash of the definition of the type, as {@link MessageType#hash} has it; empty if the
   *     other side does not tell (before Iron)
   * @param node the full name of its node; empty if the other side does not tell
   * @param participant whose it is: the same for all of one participant
   * @param id no other one has the same
   * @param handle what {@link DdsSample#publication} says of what a writer wrote
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
  private final List<AutoCloseable> endpoints = new ArrayList<>();
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
   * Takes part in a domain with a configuration of Cyclone DDS, in which nodes are announced as ROS
   * 2 does from Iron on.
   *
   * @throws IllegalArgumentException as {@link #on(DdsLibrary, int, String, String)}
   * @throws IllegalStateException as {@link #on(DdsLibrary, int, String, String)}
   */
  public static DdsParticipant on(DdsLibrary library, int domainId, String configuration) {
    return on(library, domainId, configuration, "");
  }

  /**
   * Takes part in a domain with a configuration of Cyclone DDS.
   *
   * @param domainId 0 to {@link #HIGHEST_DOMAIN}
   * @param configuration the XML of Cyclone DDS; all participants of this process in a domain have
   *     the same
   * @param distribution the release of ROS 2 of the other nodes, as {@code ROS_DISTRO} has it, on
   *     which the form of what they tell of each other depends; empty for the newest
   * @throws IllegalArgumentException if there is no such domain, or the configuration is refused
   * @throws IllegalStateException if the configuration is another one than that of this domain
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
   * Takes part in a domain that does not leave this machine.
   *
   * @param tag see {@link #loopbackConfiguration}
   * @throws IllegalArgumentException as {@link #on}, and for a bad tag
   * @throws IllegalStateException as {@link #on}
   */
  public static DdsParticipant loopback(DdsLibrary library, int domainId, String tag) {
    return on(library, domainId, loopbackConfiguration(tag));
  }

  /**
   * The configuration of {@link #loopback}, for processes that shall meet there: bound to the
   * loopback interface, which often has no multicast, so that up to 100 processes are found by
   * their ports.
   *
   * @param tag only processes with the same one meet: letters, digits, {@code _.-}, at most 64
   * @throws IllegalArgumentException for another tag
   */
  public static String loopbackConfiguration(String tag) {
    if (!TAG.matcher(tag).matches()) {
      throw new IllegalArgumentException(
          "'" + tag + "' is not a tag: up to 64 letters, digits, '_', '.' and '-'.");
    }
    return loopback("<Tag>" + tag + "</Tag>");
  }

  /**
   * The configuration of {@link #loopback} without a tag: it meets all on this machine that are on
   * the loopback interface.
   */
  public static String loopbackConfiguration() {
    return loopback("");
  }

  /** With more of the discovery's settings. */
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
   * Makes a writer.
   *
   * @param topic the full name in ROS 2, {@code /scan}
   * @throws IllegalArgumentException if the topic is not a full name, or this participant has it
   *     with another type
   */
  public synchronized DdsWriter writer(String topic, MessageType type, QosSettings qos) {
    DdsWriter writer =
        new DdsWriter(this, new Endpoint(cyclone, DdsNames.topic(topic), topic, type), qos);
    return added(writer, true, writer.gid());
  }

  /**
   * Makes a reader whose samples are taken with {@link DdsReader#take}.
   *
   * @throws IllegalArgumentException as {@link #writer}
   */
  public DdsReader reader(String topic, MessageType type, QosSettings qos) {
    return reader(topic, type, qos, Optional.empty());
  }

  /**
   * Makes a reader that hands over each sample, one after the other, in its own thread. What the
   * listener throws goes to that thread's handler of uncaught exceptions, and the next sample
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
        new DdsReader(this, new Endpoint(cyclone, DdsNames.topic(topic), topic, type), qos);
    added(reader, false, reader.gid());
    listener.ifPresent(reader::start);
    return reader;
  }

  private <E extends AutoCloseable> E added(E endpoint, boolean writer, byte[] gid) {
    endpoints.add(endpoint);
    graph.ifPresent(announced -> announced.add(writer, gid));
    return endpoint;
  }

  /**
   * Announces this participant as a node, with all its writers and readers, so that the tools of
   * ROS 2 list it.
   *
   * @param node a name in the root namespace, {@code eventchain_world}
   * @throws IllegalStateException if it is announced already
   */
  public synchronized void announce(String node) {
    requireOpen();
    if (graph.isPresent()) {
      throw new IllegalStateException("This participant is already announced.");
    }
    List<AutoCloseable> known = List.copyOf(endpoints);
    Graph announced = new Graph(this, cyclone, node);
    for (AutoCloseable endpoint : known) {
      if (endpoint instanceof DdsWriter writer) {
        announced.add(true, writer.gid());
      } else if (endpoint instanceof DdsReader reader) {
        announced.add(false, reader.gid());
      }
    }
    graph = Optional.of(announced);
  }

  /**
   * The writers and readers that others have on topics of ROS 2 in this domain, as far as they have
   * been found until now, in a fixed order.
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

  /** A topic by the name of DDS; one is made the first time. Holds the lock. */
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

  /** An endpoint is gone. */
  synchronized void removed(AutoCloseable endpoint, byte[] gid) {
    if (endpoints.remove(endpoint) && !closed) {
      graph.ifPresent(announced -> announced.remove(gid));
    }
  }

  /** Closes it with its writers and readers. Listeners that are at work are waited for. */
  @Override
  public void close() {
    List<AutoCloseable> open;
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      open = List.copyOf(endpoints);
    }
    // Without the lock, for which a listener may be waiting.
    for (AutoCloseable endpoint : open) {
      if (endpoint instanceof DdsWriter writer) {
        writer.close();
      } else if (endpoint instanceof DdsReader reader) {
        reader.close();
      }
    }
    cyclone.delete(handle);
    Domain.leave(cyclone, domain);
  }
}
