package dev.eventchain.messages;

import java.util.Locale;
import java.util.regex.Pattern;

/**
 * Names of ROS 2: topics, message types and the fields of messages (design.ros2.org, "Topic and
 * Service name mapping to DDS"; docs.ros.org, "About ROS 2 interfaces"). The only definition of
 * their syntax and equivalence in Java; {@code eventchain.ocl} states the same rules, and a test
 * compares them.
 */
public final class RosNames {

  private static final Pattern TOPIC =
      Pattern.compile("(/|~/)?[A-Za-z_][A-Za-z0-9_]*(/[A-Za-z_][A-Za-z0-9_]*)*");
  private static final Pattern TYPE =
      Pattern.compile("[a-z][a-z0-9]*(_[a-z0-9]+)*/(msg/)?[A-Z][A-Za-z0-9]*");
  private static final Pattern FIELD_PATH =
      Pattern.compile("[A-Za-z][A-Za-z0-9_]*(\\.[A-Za-z][A-Za-z0-9_]*)*");

  private RosNames() {}

  /**
   * Returns whether a text is a topic name: parts of letters, digits and underscores between
   * slashes, no digit first, no two underscores in a row; it may begin with {@code /} or {@code
   * ~/}.
   */
  public static boolean isTopic(String name) {
    return TOPIC.matcher(name).matches() && !name.contains("__");
  }

  /**
   * Returns whether a topic name is private, that is relative to each node: it begins with {@code
   * ~/}.
   */
  public static boolean isPrivate(String topic) {
    return topic.startsWith("~");
  }

  /**
   * Returns the ROS 2 node name of a component, in snake_case: {@code TTC_Calculation} is {@code
   * ttc_calculation} and {@code ObjectDetection} is {@code object_detection}.
   */
  public static String nodeName(String component) {
    return component
        .replaceAll("([a-z0-9])([A-Z])", "$1_$2")
        .replaceAll("([A-Z])([A-Z][a-z])", "$1_$2")
        .toLowerCase(Locale.ROOT)
        .replaceAll("_+", "_");
  }

  /**
   * Returns the full name of a topic for a node in the root namespace: {@code a/x} is {@code /a/x},
   * and {@code ~/x} is {@code /node/x}. A full name stays unchanged.
   *
   * @param node the name of the node in ROS 2, see {@link #nodeName}
   */
  public static String resolve(String topic, String node) {
    if (topic.startsWith("/")) {
      return topic;
    }
    return "/" + (isPrivate(topic) ? node + topic.substring(1) : topic);
  }

  /**
   * Returns whether a text is the name of a message type with its package, full or short: {@code
   * std_msgs/msg/Bool}, {@code std_msgs/Bool}.
   */
  public static boolean isMessageType(String name) {
    return TYPE.matcher(name).matches();
  }

  /** Returns whether a text is the full name of a message type. */
  static boolean isFullMessageType(String name) {
    return isMessageType(name) && name.contains("/msg/");
  }

  /**
   * Returns the full name of a message type: {@code std_msgs/Bool} is {@code std_msgs/msg/Bool}.
   */
  public static String fullMessageType(String name) {
    int slash = name.indexOf('/');
    boolean isShort = slash >= 0 && name.indexOf('/', slash + 1) < 0;
    return isShort ? name.substring(0, slash) + "/msg" + name.substring(slash) : name;
  }

  /** Returns whether a text is a field path: names separated by dots. */
  public static boolean isFieldPath(String path) {
    return FIELD_PATH.matcher(path).matches();
  }

  /**
   * Returns whether two paths are equal or one is a part of the other: {@code header} and {@code
   * header.stamp.sec}, {@code ranges} and {@code ranges[2]}.
   */
  public static boolean overlap(String one, String other) {
    String longer = one.length() >= other.length() ? one : other;
    String shorter = one.length() >= other.length() ? other : one;
    return longer.startsWith(shorter)
        && (longer.length() == shorter.length()
            || longer.charAt(shorter.length()) == '.'
            || longer.charAt(shorter.length()) == '[');
  }
}
