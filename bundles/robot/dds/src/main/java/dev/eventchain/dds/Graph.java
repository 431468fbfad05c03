package dev.eventchain.dds;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * Tells other participants which node the endpoints of this one belong to (rmw_dds_common). Used
 * with the lock of the participant.
 */
final class Graph {

  private static final String TOPIC = "ros_discovery_info";
  private static final String GID = "rmw_dds_common/msg/Gid";
  private static final String NODE = "rmw_dds_common/msg/NodeEntitiesInfo";
  private static final String PARTICIPANT = "rmw_dds_common/msg/ParticipantEntitiesInfo";

  /** Since Iron; in Humble an identifier has 24 bytes. */
  private static final String GID_TEXT = "uint8[16] data\n";

  static final QosSettings QOS =
      QosSettings.named("default")
          .orElseThrow()
          .withDurability(QosSettings.Durability.TRANSIENT_LOCAL)
          .withDepth(1);

  private static final MessageCatalog CATALOG = MessageCatalog.ofTexts(Map.of(GID, GID_TEXT));
  private final String node;
  private final byte[] participantGid;
  private final DdsWriter writer;
  private final List<byte[]> writers = new ArrayList<>();
  private final List<byte[]> readers = new ArrayList<>();

  Graph(DdsParticipant participant, Cyclone cyclone, String node) {
    this.node = node;
    Endpoint endpoint = endpoint(cyclone);
    participantGid = endpoint.gid(participant.handle());
    writer = new DdsWriter(participant, endpoint, QOS);
    publish();
  }

  void add(boolean isWriter, byte[] gid) {
    (isWriter ? writers : readers).add(gid);
    publish();
  }

  void remove(byte[] gid) {
    writers.removeIf(other -> Arrays.equals(other, gid));
    readers.removeIf(other -> Arrays.equals(other, gid));
    publish();
  }

  private void publish() {
    MessageValue entities =
        MessageValue.of(type(NODE))
            .set("node_namespace", "/")
            .set("node_name", node)
            .set("reader_gid_seq", gids(readers))
            .set("writer_gid_seq", gids(writers));
    MessageValue message =
        MessageValue.of(type(PARTICIPANT))
            .set("gid", gid(participantGid))
            .set("node_entities_info_seq", List.of(entities));
    writer.write(CdrCodec.encode(message));
  }

  private List<MessageValue> gids(List<byte[]> endpoints) {
    return endpoints.stream().map(this::gid).toList();
  }

  private MessageValue gid(byte[] bytes) {
    return MessageValue.of(type(GID)).set("data", bytes);
  }

  /** The topic on which all tell of their nodes. */
  static Endpoint endpoint(Cyclone cyclone) {
    return new Endpoint(cyclone, TOPIC, TOPIC, participantType());
  }

  /** What a participant tells of its nodes. */
  static MessageType participantType() {
    return type(PARTICIPANT);
  }

  private static MessageType type(String name) {
    return CATALOG.find(name).orElseThrow();
  }
}
