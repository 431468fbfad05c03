package dev.eventchain.modeler;

import java.util.Set;

/** Which names the generated Python can carry. */
final class Names {

  /** The keywords of Python 3, soft ones not among them (Python language reference, 2.3.1). */
  private static final Set<String> KEYWORDS =
      Set.of(
          "False",
          "None",
          "True",
          "and",
          "as",
          "assert",
          "async",
          "await",
          "break",
          "class",
          "continue",
          "def",
          "del",
          "elif",
          "else",
          "except",
          "finally",
          "for",
          "from",
          "global",
          "if",
          "import",
          "in",
          "is",
          "lambda",
          "nonlocal",
          "not",
          "or",
          "pass",
          "raise",
          "return",
          "try",
          "while",
          "with",
          "yield");

  private Names() {}

  /**
   * Whether a name is an ASCII identifier of Python that means nothing else: no keyword, not the
   * first argument of {@code execute()}, and not one of the names between double underscores that
   * the language keeps for itself.
   */
  static boolean isIdentifier(String name) {
    return name.matches("[A-Za-z_][A-Za-z0-9_]*")
        && !name.startsWith("__")
        && !name.equals("self")
        && !KEYWORDS.contains(name);
  }

  /** A name without the characters that would break a line or steer a terminal. */
  static String printable(String name) {
    return name.replaceAll("\\p{Cntrl}", "\uFFFD");
  }

  /** How the values of a property of event-chain descriptions must look. */
  static String ruleOf(String property) {
    return switch (property) {
      case "topic" -> "Topics are names with slashes between: /carla/ego_vehicle/lidar.";
      case "message_type" -> "Write it with its package: sensor_msgs/msg/LaserScan.";
      case "field" -> "Fields are names with dots between: header.stamp.sec.";
      default -> "";
    };
  }

  /** Whether a name is a ROS 2 topic: parts of letters, digits and underscores between slashes. */
  static boolean isTopic(String name) {
    return name.matches("/?[A-Za-z_][A-Za-z0-9_]*(/[A-Za-z_][A-Za-z0-9_]*)*");
  }

  /** Whether a name is a message type with its package, with or without {@code msg} between. */
  static boolean isMessageType(String name) {
    return name.matches("[a-z][a-z0-9_]*(/msg)?/[A-Z][A-Za-z0-9]*");
  }

  /** Whether a text is the path of a field: identifiers with dots between. */
  static boolean isFieldPath(String name) {
    return name.matches("[A-Za-z][A-Za-z0-9_]*(\\.[A-Za-z][A-Za-z0-9_]*)*");
  }
}
