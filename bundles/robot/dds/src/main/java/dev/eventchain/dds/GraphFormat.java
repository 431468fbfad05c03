package dev.eventchain.dds;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;

/**
 * The messages in which participants tell of their nodes, on {@code ros_discovery_info}: the
 * identifiers in them have 24 bytes up to ROS 2 Humble, and 16 from Iron on.
 */
final class GraphFormat {

  /** Of DDS, without the padding of Humble. */
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
   * That of a release.
   *
   * @param distribution its name in lower case, as {@code ROS_DISTRO} has it; empty for the newest
   */
  static GraphFormat of(String distribution) {
    return new GraphFormat(BEFORE_IRON.contains(distribution) ? PADDED_SIZE : GUID_SIZE);
  }

  /** How many bytes an identifier has. */
  int size() {
    return size;
  }

  /** What a participant tells of its nodes. */
  MessageType participantType() {
    return type(PARTICIPANT);
  }

  /** A node of a participant. */
  MessageType nodeType() {
    return type(NODE);
  }

  private MessageType type(String name) {
    return catalog.find(name).orElseThrow();
  }

  /** The topic on which all tell of their nodes. */
  Endpoint endpoint(Cyclone cyclone) {
    return new Endpoint(cyclone, TOPIC, TOPIC, participantType());
  }

  /** An identifier of DDS as a message. */
  MessageValue gid(byte[] guid) {
    return MessageValue.of(type(GID)).set("data", Arrays.copyOf(guid, size));
  }

  /** The identifier of DDS in a message. */
  static byte[] guid(Object gid) {
    return Arrays.copyOf((byte[]) ((MessageValue) gid).get("data"), GUID_SIZE);
  }
}
