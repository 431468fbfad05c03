package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.ObjectReader;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Criteria on something to which correct software need not come, such as full braking where partial
 * braking may be enough. Where it does not come, the criterion is not asked.
 *
 * <p>Entries of a list have a key {@code optional}; criteria with keys of their own are found in a
 * list of that name.
 */
final class OptionalCriteria {

  private static final String KEY = "optional";

  private final Set<SourceLocation> locations = new HashSet<>();
  private final Set<String> keys = new HashSet<>();
  private Optional<List<String>> named = Optional.empty();

  /** Reads whether an entry is optional. */
  void ofEntry(ObjectReader entry, SourceLocation criterion) {
    entry.requireTrue(KEY);
    if (entry.has(KEY)) {
      locations.add(criterion);
    }
  }

  /** Reads whether a criterion with a key of its own is optional. */
  void ofKey(ObjectReader accept, String key) {
    keys.add(key);
    if (named(accept).contains(key)) {
      locations.add(accept.atKey(key));
    }
  }

  private List<String> named(ObjectReader accept) {
    if (named.isEmpty()) {
      named = Optional.of(accept.texts(KEY));
    }
    return named.get();
  }

  /** Reports optional criteria that do not exist. Must be called last. */
  void refuseOthers(ObjectReader accept) {
    for (String key : named(accept)) {
      if (!keys.contains(key)) {
        accept.find(
            ScenarioRules.VALUE_RANGE,
            "There is no criterion '" + key + "' here that could be optional.",
            accept.at(KEY));
      }
    }
  }

  /** Returns the locations of the criteria that are optional. */
  Set<SourceLocation> locations() {
    return Set.copyOf(locations);
  }
}
