package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.ptr.LongByReference;
import com.sun.jna.ptr.PointerByReference;
import dev.eventchain.dds.DdsParticipant.Peer;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Discovered endpoints of other participants in a domain: their writers and readers ({@code
 * DCPSPublication}, {@code DCPSSubscription}), and the nodes of these ({@code ros_discovery_info}).
 */
final class Discovery {

  /** Pseudo handles of built-in topics. */
  private static final int PUBLICATIONS = 0x7fff0003;

  private static final int SUBSCRIPTIONS = 0x7fff0004;

  /** Mask for any sample state and view state, but only alive instances. */
  private static final int ALIVE = 0x1F;

  private static final int FIRST_ROOM = 256;
  private static final long INFORMATION_SIZE = 64;
  private static final long VALID = 12;
  private static final long INSTANCE = 24;

  /** {@code dds_builtintopic_endpoint_t}. */
  private static final int GUID_SIZE = 16;

  private static final long OWNER = 16;
  private static final long TOPIC = 40;
  private static final long TYPE = 48;
  private static final long POLICIES = 56;
  private static final String HASH = "typehash=";

  private final Cyclone cyclone;
  private final GraphFormat format;
  private final byte[] own;
  private final int writers;
  private final int readers;
  private final DdsReader graph;

  /** Node names by endpoint, as last announced by each participant. */
  private final Map<String, Map<String, String>> nodes = new HashMap<>();

  private int room = FIRST_ROOM;

  /** Joins the discovery of a participant. */
  Discovery(DdsParticipant participant, Cyclone cyclone) {
    this.cyclone = cyclone;
    format = participant.graphFormat();
    DdsTopic topic = format.topic(cyclone);
    own = topic.gid(participant.handle());
    graph = new DdsReader(participant, topic, Graph.QOS.withHistory(History.KEEP_ALL));
    writers = reader(participant, PUBLICATIONS);
    readers = reader(participant, SUBSCRIPTIONS);
    boolean known =
        read(readers, (at, handle) -> List.of(isGraph(at))).stream()
            .anyMatch(Boolean::booleanValue);
    if (!known) {
      throw new IllegalStateException(
          "The built-in topics of Cyclone DDS have an unexpected structure.");
    }
  }

  private boolean isGraph(Pointer pointer) {
    return DdsEndpoint.hex(pointer.getByteArray(0, GUID_SIZE)).equals(DdsEndpoint.hex(graph.gid()))
        && text(pointer, TOPIC).equals(graph.topic());
  }

  private int reader(DdsParticipant participant, int topic) {
    return Codes.check(
        cyclone,
        cyclone.createReader(participant.handle(), topic, null, null),
        "discover other endpoints");
  }

  private static String text(Pointer pointer, long offset) {
    return pointer.getPointer(offset).getString(0, StandardCharsets.UTF_8.name());
  }

  /** Returns the endpoints of other participants on ROS 2 topics, grouped by topic. */
  synchronized List<Peer> peers() {
    readGraph();
    List<Peer> peers = new ArrayList<>(read(writers, (at, handle) -> peer(true, at, handle)));
    peers.addAll(read(readers, (at, handle) -> peer(false, at, handle)));
    peers.sort(Peer.ORDER);
    return List.copyOf(peers);
  }

  private interface Reading<T> {
    List<T> of(Pointer endpoint, long handle);
  }

  private <T> List<T> read(int reader, Reading<T> reading) {
    while (true) {
      Memory pointers = new Memory((long) room * Long.BYTES);
      pointers.clear(); // a null pointer makes the library lend its own memory
      Memory information = new Memory(room * INFORMATION_SIZE);
      int count =
          Codes.check(
              cyclone,
              cyclone.readMask(reader, pointers, information, room, room, ALIVE),
              "discover other endpoints");
      List<T> found = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        long offset = i * INFORMATION_SIZE;
        if (information.getByte(offset + VALID) != 0) {
          Pointer endpoint = pointers.getPointer((long) i * Long.BYTES);
          found.addAll(reading.of(endpoint, information.getLong(offset + INSTANCE)));
        }
      }
      if (count > 0) {
        Codes.check(cyclone, cyclone.returnLoan(reader, pointers, count), "return memory");
      }
      if (count < room) {
        return found;
      }
      room *= 2;
    }
  }

  private List<Peer> peer(boolean writes, Pointer endpoint, long handle) {
    byte[] owner = endpoint.getByteArray(OWNER, GUID_SIZE);
    Optional<String> topic = DdsNames.rosTopic(text(endpoint, TOPIC));
    if (DdsEndpoint.hex(owner).equals(DdsEndpoint.hex(own)) || topic.isEmpty()) {
      return List.of();
    }
    String id = DdsEndpoint.hex(endpoint.getByteArray(0, GUID_SIZE));
    Pointer qos = endpoint.getPointer(POLICIES);
    String node = nodes.getOrDefault(DdsEndpoint.hex(owner), Map.of()).getOrDefault(id, "");
    String type = DdsNames.rosType(text(endpoint, TYPE));
    return List.of(
        new Peer(
            writes,
            topic.get(),
            type,
            settings(qos),
            hash(qos),
            node,
            DdsEndpoint.hex(owner),
            id,
            handle));
  }

  /** Returns the policies that decide whether endpoints match. */
  private QosSettings settings(Pointer qos) {
    int[] kind = new int[1];
    long[] time = new long[1];
    boolean reliable = cyclone.qgetReliability(qos, kind, time) != 0 && kind[0] != 0;
    boolean kept = cyclone.qgetDurability(qos, kind) != 0 && kind[0] != 0;
    long deadline = cyclone.qgetDeadline(qos, time) != 0 ? time[0] : Long.MAX_VALUE;
    boolean manual = cyclone.qgetLiveliness(qos, kind, time) != 0 && kind[0] != 0;
    return new QosSettings(
        reliable ? Reliability.RELIABLE : Reliability.BEST_EFFORT,
        kept ? Durability.TRANSIENT_LOCAL : Durability.VOLATILE,
        History.KEEP_ALL,
        0,
        time(deadline),
        manual ? Liveliness.MANUAL_BY_TOPIC : Liveliness.AUTOMATIC,
        time(time[0] > 0 ? time[0] : Long.MAX_VALUE));
  }

  private static Optional<Duration> time(long nanos) {
    return nanos == Long.MAX_VALUE ? Optional.empty() : Optional.of(Duration.ofNanos(nanos));
  }

  /** Returns the hash of the endpoint's type definition; empty before Iron. */
  private String hash(Pointer qos) {
    PointerByReference value = new PointerByReference();
    LongByReference size = new LongByReference();
    if (cyclone.qgetUserdata(qos, value, size) == 0 || value.getValue() == null) {
      return "";
    }
    byte[] data = value.getValue().getByteArray(0, Math.toIntExact(size.getValue()));
    cyclone.free(value.getValue());
    String text = new String(data, StandardCharsets.UTF_8);
    return List.of(text.split(";")).stream()
        .filter(pair -> pair.startsWith(HASH))
        .map(pair -> pair.substring(HASH.length()))
        .findFirst()
        .orElse("");
  }

  private void readGraph() {
    graph.take().forEach(sample -> nodes.putAll(namesByEndpoint(format, sample.bytes())));
  }

  /**
   * Returns the node names by endpoint of the participant that announced them; empty for another
   * release of ROS 2, whose node names cannot be read.
   */
  static Map<String, Map<String, String>> namesByEndpoint(GraphFormat format, byte[] bytes) {
    MessageValue said;
    try {
      said = CdrCodec.decode(format.participantType(), bytes);
    } catch (IllegalArgumentException e) {
      return Map.of();
    }
    Map<String, String> byEndpoint = new HashMap<>();
    for (Object each : (List<?>) said.get("node_entities_info_seq")) {
      MessageValue node = (MessageValue) each;
      String namespace = node.get("node_namespace").toString();
      String name = (namespace.endsWith("/") ? namespace : namespace + "/") + node.get("node_name");
      for (String ends : List.of("reader_gid_seq", "writer_gid_seq")) {
        ((List<?>) node.get(ends))
            .forEach(gid -> byEndpoint.put(DdsEndpoint.hex(GraphFormat.guid(gid)), name));
      }
    }
    return Map.of(DdsEndpoint.hex(GraphFormat.guid(said.get("gid"))), byEndpoint);
  }
}
