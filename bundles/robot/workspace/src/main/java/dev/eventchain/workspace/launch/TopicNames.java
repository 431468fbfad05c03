package dev.eventchain.workspace.launch;

import dev.eventchain.messages.RosNames;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Full names of topics in a node, by its namespace, name and remappings (design.ros2.org, "Topic
 * and Service name mapping to DDS" and "Remapping Names").
 *
 * @param namespace begins with a slash; empty if it is not known
 * @param name empty if it is not known
 */
public record TopicNames(Optional<String> namespace, Optional<String> name, List<Remap> remaps) {

  /** A rule for names: what is called {@code from} in the node is {@code to} outside. */
  public record Remap(String from, String to) {}

  /** Returns the full name of a topic; empty if it depends on what is not known, or is no name. */
  public Optional<String> resolve(String topic) {
    Optional<String> full = expand(topic);
    for (Remap remap : remaps) {
      if (full.isPresent() && full.equals(expand(remap.from()))) {
        return expand(remap.to());
      }
    }
    return full;
  }

  /** Returns the full names by the names that the node uses, as far as they are known. */
  public Map<String, String> remappings() {
    Map<String, String> found = new LinkedHashMap<>();
    for (Remap remap : remaps) {
      if (expand(remap.from()).isPresent()) {
        expand(remap.to()).ifPresent(to -> found.putIfAbsent(remap.from(), to));
      }
    }
    return found;
  }

  /** Returns the full name of a topic before remapping. */
  private Optional<String> expand(String topic) {
    if (!RosNames.isTopic(topic)) {
      return Optional.empty();
    }
    if (topic.startsWith("/")) {
      return Optional.of(topic);
    }
    if (RosNames.isPrivate(topic)) {
      return namespace.flatMap(space -> name.map(it -> join(join(space, it), topic.substring(2))));
    }
    return namespace.map(space -> join(space, topic));
  }

  /** Returns a name in a namespace; an absolute one stays as it is. */
  public static String join(String namespace, String name) {
    if (name.startsWith("/")) {
      return name;
    }
    return (namespace.endsWith("/") ? namespace : namespace + "/") + name;
  }
}
