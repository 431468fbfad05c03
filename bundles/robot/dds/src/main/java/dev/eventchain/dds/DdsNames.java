package dev.eventchain.dds;

import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Mapping of ROS 2 names to DDS names (design.ros2.org, "Topic and Service name mapping to DDS").
 */
final class DdsNames {

  private static final String TOPIC = "rt";
  private static final Pattern TYPE = Pattern.compile("((?:\\w+::)+)dds_::(\\w+)_");

  private DdsNames() {}

  /**
   * Returns the DDS name of a topic.
   *
   * @throws IllegalArgumentException if it is not a full name such as {@code /scan}
   */
  static String topic(String topic) {
    if (!topic.startsWith("/") || !RosNames.isTopic(topic)) {
      throw new IllegalArgumentException(
          "'" + topic + "' is not the full name of a topic, such as /scan.");
    }
    return TOPIC + topic;
  }

  /** Returns the DDS name of a type: {@code sensor_msgs::msg::dds_::LaserScan_}. */
  static String type(MessageType type) {
    int slash = type.name().lastIndexOf('/');
    return type.name().substring(0, slash).replace("/", "::")
        + "::dds_::"
        + type.name().substring(slash + 1)
        + "_";
  }

  /** Returns the full ROS 2 name of a DDS topic; empty if it is not a topic of ROS 2. */
  static Optional<String> rosTopic(String name) {
    return name.startsWith(TOPIC + "/")
        ? Optional.of(name.substring(TOPIC.length()))
        : Optional.empty();
  }

  /** Returns the ROS 2 name of a DDS type; its DDS name if it is not a type of ROS 2. */
  static String rosType(String name) {
    Matcher matcher = TYPE.matcher(name);
    return matcher.matches() ? matcher.group(1).replace("::", "/") + matcher.group(2) : name;
  }
}
