package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.Actor;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Names of entities: those of the scenario, but without what has a meaning in references and
 * expressions, and each one once, also if capitals do not count.
 */
final class EntityNames {

  /** The vehicle under test, as it is usual. */
  static final String EGO = "Ego";

  private final Map<String, String> names = new HashMap<>();
  private final Map<String, String> words = new HashMap<>();
  private final Set<String> taken = new HashSet<>();

  EntityNames(List<Actor> actors) {
    taken.add(EGO.toLowerCase(Locale.ROOT));
    words.put(EGO, EGO);
    actors.forEach(actor -> names.put(actor.name(), unused(plain(actor.name()))));
    Set<String> known = new HashSet<>(Set.of(EGO));
    for (Actor actor : actors) {
      String name = of(actor.name());
      String word = name.replaceAll("[^A-Za-z0-9_]", "_").replaceFirst("^(?=[0-9])", "_");
      while (!known.add(word)) {
        word += "_";
      }
      words.put(name, word);
    }
  }

  private static String plain(String name) {
    return name.strip().replaceAll("[^\\p{L}\\p{N}_. -]", "_");
  }

  private String unused(String name) {
    String free = name;
    for (int number = 2; !taken.add(free.toLowerCase(Locale.ROOT)); number++) {
      free = name + " " + number;
    }
    return free;
  }

  /** Returns the name of an actor's entity. */
  String of(String actor) {
    return names.get(actor);
  }

  /** Returns the name of a parameter about an entity. */
  String parameter(String entity, String quantity) {
    return words.get(entity) + "_" + quantity;
  }
}
