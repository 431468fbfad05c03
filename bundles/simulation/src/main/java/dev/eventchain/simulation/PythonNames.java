package dev.eventchain.simulation;

import java.util.Locale;
import java.util.Set;

/** What the generated nodes are called in Python, by the rules of {@code templates/ros2-python}. */
final class PythonNames {

  private static final Set<String> RESERVED =
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
          "yield",
          "self",
          "rclpy",
          "main",
          "__debug__");

  private PythonNames() {}

  /** The nearest identifier: ASCII letters, digits and underscores, no reserved word. */
  static String identifier(String name) {
    String ascii =
        (name == null ? "" : name).replaceAll("[^A-Za-z0-9_]", "_").replaceAll("^__+", "_");
    String started = ascii.matches("[A-Za-z_].*") ? ascii : "_" + ascii;
    return RESERVED.contains(started) ? started + "_" : started;
  }

  /** The module of a node, without its package. */
  static String nodeModule(String node) {
    return identifier(node).toLowerCase(Locale.ROOT) + "_node";
  }

  /** The class of a node. */
  static String nodeClass(String node) {
    return identifier(node) + "_node";
  }
}
