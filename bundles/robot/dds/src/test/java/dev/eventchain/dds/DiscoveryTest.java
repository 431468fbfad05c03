package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.dds.DdsParticipant.Peer;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Discovery and announcement of endpoints. */
class DiscoveryTest {

  private static final QosSettings QOS = QosSettings.named("default").orElseThrow();
  private static final MessageType FLOAT = RandomMessages.type("std_msgs/msg/Float32");

  /**
   * Creates an isolated writer and reader of one topic per tag, and returns the final number of
   * matches of each.
   */
  private static List<Integer> matches(List<String> tags, int expected) {
    List<DdsParticipant> participants = new ArrayList<>();
    try {
      List<DdsWriter> writers = new ArrayList<>();
      List<DdsReader> readers = new ArrayList<>();
      for (String tag : tags) {
        DdsParticipant participant = Wire.onTheWire(tag);
        participants.add(participant);
        writers.add(participant.writer("/a", FLOAT, QOS));
        readers.add(participant.reader("/a", FLOAT, QOS));
      }
      List<Integer> matches = new ArrayList<>();
      for (DdsWriter writer : writers) {
        assertTrue(writer.waitForMatches(expected, Wire.PATIENCE));
      }
      for (DdsReader reader : readers) {
        assertTrue(reader.waitForMatches(expected, Wire.PATIENCE));
      }
      writers.forEach(writer -> matches.add(writer.matched()));
      readers.forEach(reader -> matches.add(reader.matched()));
      return matches;
    } finally {
      participants.forEach(DdsParticipant::close);
    }
  }

  @Test
  void runsWithDifferentTagsDoNotMeet() {
    String one = Wire.newTag();
    String other = Wire.newTag();
    assertEquals(
        List.of(4, 4, 4, 4, 4, 4, 4, 4), matches(List.of(one, one, one, one), 4), "the same tag");
    assertEquals(List.of(2, 2, 2, 2, 2, 2, 2, 2), matches(List.of(one, other, one, other), 2));
  }

  @Test
  void othersAreSeenWithTheirNodesTypesAndQualityOfService() throws Exception {
    String tag = Wire.newTag();
    QosSettings kept =
        QosSettings.named("sensor_data")
            .orElseThrow()
            .withDurability(QosSettings.Durability.TRANSIENT_LOCAL);
    QosSettings timed = QOS.withDeadline(Duration.ofMillis(70)).withLease(Duration.ofSeconds(3));
    try (DdsParticipant world = Wire.onTheWire(tag)) {
      assertEquals(List.of(), world.peers());
      world.writer("/own", FLOAT, QOS);
      try (DdsParticipant other = Wire.onTheWire(tag)) {
        other.announce("brake");
        other.reader("/scan", FLOAT, kept);
        DdsWriter force = other.writer("/force", FLOAT, timed);
        List<Peer> peers = seen(world, 2);
        assertEquals(
            List.of("false /scan", "true /force"),
            peers.stream().map(each -> each.writes() + " " + each.topic()).sorted().toList());
        for (Peer peer : peers) {
          assertEquals("/brake", peer.node());
          assertEquals("std_msgs/msg/Float32", peer.type());
          assertEquals(FLOAT.hash(), peer.typeHash());
          QosSettings expected = peer.writes() ? timed : kept;
          assertEquals(expected.withHistory(QosSettings.History.KEEP_ALL).withDepth(0), peer.qos());
        }
        try (DdsReader reader = world.reader("/force", FLOAT, QOS)) {
          assertTrue(reader.waitForMatches(1, Wire.PATIENCE));
          assertTrue(force.waitForMatches(1, Wire.PATIENCE));
          force.write(CdrCodec.encode(MessageValue.of(FLOAT)));
          assertEquals(
              peers.get(0).handle(), reader.take(Wire.PATIENCE).get(0).publication(), "/force");
        }
      }
      assertEquals(List.of(), seen(world, 0));
    }
  }

  /** Waits for this number of remote endpoints, all with their nodes. */
  private static List<Peer> seen(DdsParticipant participant, int count) throws Exception {
    long end = System.nanoTime() + Wire.PATIENCE.toNanos();
    List<Peer> peers = participant.peers();
    while (System.nanoTime() < end
        && (peers.size() != count || peers.stream().anyMatch(each -> each.node().isEmpty()))) {
      Thread.sleep(2);
      peers = participant.peers();
    }
    return peers;
  }

  @Test
  void nodesOfHumbleAndOfTheWorldKnowEachOther() throws Exception {
    String tag = Wire.newTag();
    try (DdsParticipant world = Wire.onTheWire(tag, "humble");
        DdsParticipant other = Wire.onTheWire(tag, "humble")) {
      world.announce("eventchain_world");
      world.writer("/scan", FLOAT, QOS);
      other.announce("brake");
      other.reader("/scan", FLOAT, QOS);
      assertEquals("/brake", seen(world, 1).get(0).node());
      assertEquals("/eventchain_world", seen(other, 1).get(0).node());
    }
  }

  @Test
  void theWorldIsAnnouncedAsANodeWithItsEndpoints() {
    String tag = Wire.newTag();
    MessageCatalog catalog =
        MessageCatalog.ofTexts(Map.of("rmw_dds_common/msg/Gid", "uint8[16] data\n"));
    MessageType type = catalog.find("rmw_dds_common/msg/ParticipantEntitiesInfo").orElseThrow();
    try (DdsParticipant world = Wire.onTheWire(tag);
        DdsParticipant observer = Wire.onTheWire(tag)) {
      DdsWriter writer = world.writer("/scan", FLOAT, QOS);
      world.announce("eventchain_world");
      DdsReader reader = world.reader("/brake", FLOAT, QOS);
      DdsReader graph =
          new DdsReader(
              observer,
              new DdsTopic(
                  Wire.library().cyclone(), "ros_discovery_info", "ros_discovery_info", type),
              QOS.withDurability(QosSettings.Durability.TRANSIENT_LOCAL));
      MessageValue seen = last(graph, type);
      MessageValue node = node(seen);
      assertEquals("/", node.get("node_namespace"));
      assertEquals("eventchain_world", node.get("node_name"));
      assertGids(List.of(writer.gid()), node.get("writer_gid_seq"));
      assertGids(List.of(reader.gid()), node.get("reader_gid_seq"));
      byte[] participant = (byte[]) seen.get("gid.data");
      assertEquals(16, participant.length);
      // The GUID of an endpoint starts with that of its participant.
      assertArrayEquals(
          java.util.Arrays.copyOf(participant, 12), java.util.Arrays.copyOf(writer.gid(), 12));
      writer.close();
      node = node(last(graph, type));
      assertGids(List.of(), node.get("writer_gid_seq"));
      assertGids(List.of(reader.gid()), node.get("reader_gid_seq"));
      graph.close();
    }
  }

  private static MessageValue last(DdsReader graph, MessageType type) {
    List<DdsSample> samples = graph.take(Wire.PATIENCE);
    return CdrCodec.decode(type, samples.get(samples.size() - 1).bytes());
  }

  private static MessageValue node(MessageValue participant) {
    List<?> nodes = (List<?>) participant.get("node_entities_info_seq");
    assertEquals(1, nodes.size());
    return (MessageValue) nodes.get(0);
  }

  private static void assertGids(List<byte[]> expected, Object gids) {
    List<?> found = (List<?>) gids;
    assertEquals(expected.size(), found.size());
    for (int i = 0; i < expected.size(); i++) {
      assertArrayEquals(expected.get(i), (byte[]) ((MessageValue) found.get(i)).get("data"));
    }
  }
}
