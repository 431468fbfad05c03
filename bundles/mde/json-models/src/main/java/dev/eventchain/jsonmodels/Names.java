package dev.eventchain.jsonmodels;

/** Names in messages to people. */
public final class Names {

  private Names() {}

  /** Returns a name without line breaks and control characters of terminals. */
  public static String printable(String name) {
    return name.replaceAll("\\p{Cntrl}", "\uFFFD");
  }

  /** Returns the rule for values of a property of event-chain descriptions, or an empty text. */
  public static String ruleOf(String property) {
    return switch (property) {
      case "topic" ->
          "Topics are names separated by slashes, without two underscores in a row:"
              + " /carla/ego_vehicle/lidar.";
      case "message_type" -> "Write it with its package: sensor_msgs/msg/LaserScan.";
      case "field" -> "Fields are names separated by dots: header.stamp.sec.";
      default -> "";
    };
  }
}
