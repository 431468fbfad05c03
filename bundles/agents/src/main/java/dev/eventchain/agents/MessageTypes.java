package dev.eventchain.agents;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names of message types. */
final class MessageTypes {
  private static final Pattern NAME =
      Pattern.compile("([a-z][a-z0-9_]*)/(?:msg/)?([A-Z][A-Za-z0-9]*)");

  private MessageTypes() {}

  /**
   * A name in its full form, {@code sensor_msgs/msg/LaserScan}; empty if it is no name, or one
   * without a package.
   */
  static Optional<String> qualified(String name) {
    Matcher matcher = NAME.matcher(name);
    return matcher.matches()
        ? Optional.of(matcher.group(1) + "/msg/" + matcher.group(2))
        : Optional.empty();
  }
}
