package dev.eventchain.messages;

import dev.eventchain.diagnostics.ResourceText;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/**
 * Texts of the standard types by name. There is one resource for each release of ROS 2; that of a
 * later one has what is new or different in it.
 */
final class StandardTypes {

  private static final Map<RosDistribution, Map<String, String>> STATED = stated();
  private static final Map<RosDistribution, Map<String, String>> TEXTS = texts();

  private StandardTypes() {}

  /** Returns the texts of all standard types of a release. */
  static Map<String, String> of(RosDistribution distribution) {
    return TEXTS.get(distribution);
  }

  /**
   * Returns the names of the types that a release does not have as {@link RosDistribution#DEFAULT}
   * has them.
   */
  static Set<String> different(RosDistribution distribution) {
    return distribution == RosDistribution.DEFAULT ? Set.of() : STATED.get(distribution).keySet();
  }

  private static Map<RosDistribution, Map<String, String>> stated() {
    Map<RosDistribution, Map<String, String>> stated = new EnumMap<>(RosDistribution.class);
    for (RosDistribution distribution : RosDistribution.values()) {
      Map<String, String> texts = new HashMap<>();
      for (String part : text(distribution.id() + ".msgs").split(MessageCatalog.SEPARATOR, -1)) {
        int end = part.indexOf('\n');
        String name = part.substring(MessageCatalog.HEADING.length(), end).strip();
        texts.put(name, part.substring(end + 1));
      }
      stated.put(distribution, texts);
    }
    return stated;
  }

  private static Map<RosDistribution, Map<String, String>> texts() {
    Map<RosDistribution, Map<String, String>> texts = new EnumMap<>(RosDistribution.class);
    for (RosDistribution distribution : RosDistribution.values()) {
      Map<String, String> all = new HashMap<>(STATED.get(RosDistribution.DEFAULT));
      all.putAll(STATED.get(distribution));
      texts.put(distribution, all);
    }
    return texts;
  }

  private static String text(String resource) {
    return ResourceText.of(MessageCatalog.class, resource);
  }
}
