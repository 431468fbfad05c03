package dev.eventchain.dds;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;

/**
 * Formats of the messages on {@code ros_discovery_info}, by which participants announce their
 * nodes. Their identifiers have 24 bytes up to ROS 2 Humble, and 16 from Iron on.
 */
final class GraphFormat {

  /** Size of a DDS GUID, without the padding of Humble. */
  private static final int GUID_SIZE = 16;

  private static final int PADDED_SIZE = 24;
  private static final Set<String> BEFORE_IRON = Set.of("foxy", "galactic", "humble");

  private static final String TOPIC = "ros_discovery_info";
  private static final String GID = "rmw_dds_common/msg/Gid";
  private static final String NODE = "rmw_dds_common/msg/NodeEntitiesInfo";
  private static final String PARTICIPANT = "rmw_dds_common/msg/ParticipantEntitiesInfo";

  private final int size;
  private final MessageCatalog catalog;

  private GraphFormat(int size) {
    this.size = size;
    catalog = MessageCatalog.ofTexts(Map.of(GID, "char[" + size + "] data\n"));
  }

  /**
   * Returns the format of a ROS 2 release.
   *
   * @param distribution its name in lower case, as in {@code ROS_DISTRO}; empty for the newest
   */
  static GraphFormat of(String distribution) {
    return new GraphFormat(BEFORE_IRON.contains(distribution) ? PADDED_SIZE : GUID_SIZE);
  }

  /** Returns the size of an identifier in bytes. */
  int size() {
    return size;
  }

  /** Returns the type of the message about the nodes of a participant. */
  MessageType participantType() {
    return type(PARTICIPANT);
  }

  /** Returns the type of the entry for one node. */
  MessageType nodeType() {
    return type(NODE);
  }

  private MessageType type(String name) {
    return catalog.find(name).orElseThrow();
  }

  /** Returns the topic on which participants announce their nodes. */
  DdsTopic topic(Cyclone cyclone) {
    return new DdsTopic(cyclone, TOPIC, TOPIC, participantType());
  }

  /** Returns the message for a DDS GUID. */
  MessageValue gid(byte[] guid) {
    return MessageValue.of(type(GID)).set("data", Arrays.copyOf(guid, size));
  }

  /** Returns the DDS GUID in a message. */
  static byte[] guid(Object gid) {
    return Arrays.copyOf((byte[]) ((MessageValue) gid).get("data"), GUID_SIZE);
  }
}
