package dev.eventchain.workspace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Names of the components that nodes are: {@code /front/time_to_collision} is Time_To_Collision.
 */
final class ComponentNames {

  private static final Set<String> KEYWORDS = Set.of("False", "None", "True");

  private ComponentNames() {}

  /** Returns the name of each node; that of its namespace is in front of it where needed. */
  static List<String> of(List<FoundNode> nodes) {
    List<String> names = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (FoundNode node : nodes) {
      String full = node.name().substring(1);
      String simple = capitalized(full.substring(full.lastIndexOf('/') + 1));
      String name = taken.contains(simple) ? capitalized(full.replace('/', '_')) : simple;
      String unique = KEYWORDS.contains(name) ? name + "_Node" : name;
      for (int i = 2; taken.contains(unique); i++) {
        unique = name + "_" + i;
      }
      taken.add(unique);
      names.add(unique);
    }
    return names;
  }

  private static String capitalized(String name) {
    return Arrays.stream(name.split("_", -1))
        .filter(part -> !part.isEmpty())
        .map(part -> part.substring(0, 1).toUpperCase(Locale.ROOT) + part.substring(1))
        .collect(Collectors.joining("_"));
  }
}
