package dev.eventchain.dds;

import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;

/** How names of ROS 2 stand in DDS (design.ros2.org, "Topic and Service name mapping to DDS"). */
final class DdsNames {

  private static final String TOPIC = "rt";

  private DdsNames() {}

  /**
   * The name of a topic.
   *
   * @throws IllegalArgumentException if it is no full name: {@code /scan}
   */
  static String topic(String topic) {
    if (!topic.startsWith("/") || !RosNames.isTopic(topic)) {
      throw new IllegalArgumentException(
          "'" + topic + "' is not the full name of a topic, such as /scan.");
    }
    return TOPIC + topic;
  }

  /** The name of a type: {@code sensor_msgs::msg::dds_::LaserScan_}. */
  static String type(MessageType type) {
    int slash = type.name().lastIndexOf('/');
    return type.name().substring(0, slash).replace("/", "::")
        + "::dds_::"
        + type.name().substring(slash + 1)
        + "_";
  }
}
