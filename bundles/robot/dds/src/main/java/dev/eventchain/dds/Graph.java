package dev.eventchain.dds;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Announces to other participants the node of this participant's endpoints (rmw_dds_common). Used
 * with the lock of the participant.
 */
final class Graph {

  static final QosSettings QOS =
      QosSettings.named("default")
          .orElseThrow()
          .withDurability(QosSettings.Durability.TRANSIENT_LOCAL)
          .withDepth(1);

  private final GraphFormat format;
  private final String node;
  private final byte[] participantGid;
  private final DdsWriter writer;
  private final List<byte[]> writers = new ArrayList<>();
  private final List<byte[]> readers = new ArrayList<>();

  Graph(DdsParticipant participant, Cyclone cyclone, String node) {
    this.node = node;
    format = participant.graphFormat();
    DdsTopic topic = format.topic(cyclone);
    participantGid = topic.gid(participant.handle());
    writer = new DdsWriter(participant, topic, QOS);
    publish();
  }

  void add(DdsEndpoint endpoint) {
    (endpoint.side() == Side.WRITER ? writers : readers).add(endpoint.gid());
    publish();
  }

  void remove(DdsEndpoint endpoint) {
    byte[] gid = endpoint.gid();
    writers.removeIf(other -> Arrays.equals(other, gid));
    readers.removeIf(other -> Arrays.equals(other, gid));
    publish();
  }

  private void publish() {
    writer.write(encode(format, participantGid, node, readers, writers));
  }

  /** Returns the message that announces the one node of a participant. */
  static byte[] encode(
      GraphFormat format,
      byte[] participant,
      String node,
      List<byte[]> readers,
      List<byte[]> writers) {
    MessageValue entities =
        MessageValue.of(format.nodeType())
            .set("node_namespace", "/")
            .set("node_name", node)
            .set("reader_gid_seq", gids(format, readers))
            .set("writer_gid_seq", gids(format, writers));
    MessageValue message =
        MessageValue.of(format.participantType())
            .set("gid", format.gid(participant))
            .set("node_entities_info_seq", List.of(entities));
    return CdrCodec.encode(message);
  }

  private static List<MessageValue> gids(GraphFormat format, List<byte[]> endpoints) {
    return endpoints.stream().map(format::gid).toList();
  }
}
