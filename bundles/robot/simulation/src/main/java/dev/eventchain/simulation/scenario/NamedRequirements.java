package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The requirements that a scenario and its criteria name. A criterion tests those that it names
 * itself; one that names none tests those of the scenario's list that no other criterion names. The
 * criteria of every scenario are conditions for all of them. A criterion can also say which words
 * of a requirement it judges, under {@code judges}; it tests these requirements.
 *
 * <p>Entries of a list have a key {@code requirements}; criteria with keys of their own are found
 * in a section of that name, by their keys.
 */
public final class NamedRequirements {

  private static final String KEY = "requirements";
  private static final String JUDGES = "judges";

  private final boolean read;
  private final List<String> ofScenario;
  private final Set<String> ofCriteria = new LinkedHashSet<>();
  private final Map<String, SourceLocation> places = new LinkedHashMap<>();
  private final SourceLocation place;
  private final List<JudgedWords> judged = new ArrayList<>();
  private final Map<String, Optional<ObjectReader>> byKey = new HashMap<>();

  private NamedRequirements(boolean read, List<String> ofScenario, SourceLocation place) {
    this.read = read;
    this.ofScenario = List.copyOf(ofScenario);
    this.place = place;
    ofScenario.forEach(id -> places.put(id, place));
  }

  /** Returns a reader of criteria that cannot name requirements. */
  public static NamedRequirements none() {
    return new NamedRequirements(false, List.of(), SourceLocation.NONE);
  }

  /** Reads the list of a scenario. */
  static NamedRequirements ofScenario(ObjectReader scenario) {
    SourceLocation place = scenario.has(KEY) ? scenario.atKey(KEY) : scenario.location();
    return new NamedRequirements(true, scenario.texts(KEY), place);
  }

  /**
   * Reads the requirements that an entry of a list names or judges; empty if it names none.
   *
   * @param criterion the location of the criterion
   */
  List<String> ofEntry(ObjectReader entry, SourceLocation criterion) {
    if (!read) {
      return List.of();
    }
    Set<String> ids = new LinkedHashSet<>(named(entry, KEY));
    ids.addAll(judged(entry, JUDGES, criterion));
    return List.copyOf(ids);
  }

  /** Reads the requirements that a criterion with a key of its own names or judges. */
  List<String> ofKey(ObjectReader accept, String key) {
    if (!read) {
      return List.of();
    }
    Set<String> ids = new LinkedHashSet<>();
    section(accept, KEY).ifPresent(part -> ids.addAll(named(part, key)));
    section(accept, JUDGES).ifPresent(part -> ids.addAll(judged(part, key, accept.atKey(key))));
    return List.copyOf(ids);
  }

  /** Reads the words of requirements that a criterion judges. */
  private List<String> judged(ObjectReader section, String key, SourceLocation criterion) {
    Optional<ObjectReader> words = section.object(key);
    List<String> ids = words.map(ObjectReader::names).orElse(List.of());
    for (String id : ids) {
      ObjectReader part = words.get();
      for (String each : quoted(part, id)) {
        judged.add(new JudgedWords(criterion, id, each, part.at(id)));
      }
      places.putIfAbsent(id, part.atKey(id));
    }
    ofCriteria.addAll(ids);
    return ids;
  }

  private static List<String> quoted(ObjectReader words, String id) {
    if (words.value(id).filter(JsonNode::isArray).isEmpty()) {
      return List.of(words.requiredText(id));
    }
    List<String> several = words.texts(id);
    if (several.isEmpty() || several.stream().anyMatch(String::isBlank)) {
      words.find(ScenarioRules.VALUE_RANGE, "This quotes no words.", words.at(id));
    }
    return several;
  }

  /** Returns the words of requirements that criteria judge, in the order of reading. */
  List<JudgedWords> judged() {
    return List.copyOf(judged);
  }

  private List<String> named(ObjectReader section, String key) {
    List<String> ids = section.texts(key).stream().distinct().toList();
    if (section.value(key).filter(JsonNode::isArray).filter(JsonNode::isEmpty).isPresent()) {
      section.find(
          ScenarioRules.VALUE_RANGE, "This names no requirement; leave it out.", section.at(key));
    }
    ids.forEach(id -> places.putIfAbsent(id, section.atKey(key)));
    ofCriteria.addAll(ids);
    return ids;
  }

  /** Reports requirements of criteria that do not exist. Must be called last. */
  void refuseOthers(ObjectReader accept) {
    if (read) {
      section(accept, KEY).ifPresent(ObjectReader::refuseOthers);
      section(accept, JUDGES).ifPresent(ObjectReader::refuseOthers);
    }
  }

  private Optional<ObjectReader> section(ObjectReader accept, String key) {
    return byKey.computeIfAbsent(key, accept::object);
  }

  /** Returns all ids: the scenario's list, and then what only criteria name. */
  List<String> all() {
    Set<String> all = new LinkedHashSet<>(ofScenario);
    all.addAll(ofCriteria);
    return List.copyOf(all);
  }

  /** Returns the places where they are named first; for none, that of the scenario's list. */
  Places places() {
    return new Places(Map.copyOf(places), place);
  }

  /**
   * Places in a scenario's file.
   *
   * @param of each requirement
   * @param list of the scenario's list, or of the scenario without one
   */
  record Places(Map<String, SourceLocation> of, SourceLocation list) {}

  /** Returns the criteria with the requirements that they test. */
  List<Expectation> distributed(List<Expectation> criteria) {
    List<String> left = new ArrayList<>(ofScenario);
    left.removeAll(ofCriteria);
    List<Expectation> distributed = new ArrayList<>();
    for (Expectation each : criteria) {
      List<String> own = each.requirements().isEmpty() ? left : each.requirements();
      distributed.add(each.testing(each.isOfEveryScenario() ? all() : own));
    }
    return distributed;
  }
}
