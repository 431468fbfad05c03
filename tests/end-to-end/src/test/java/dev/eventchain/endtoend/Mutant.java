package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

/**
 * A component with a safety-relevant defect.
 *
 * @param id the name in tests
 * @param does a description of its behaviour
 * @param component the name of the component, the one that is changed unless a change names another
 * @param changes the texts that are replaced, each of which stands exactly once in its component
 * @param scenario the one that fails it
 * @param criterion the beginning of the text of the failed criterion; empty if it is equivalent
 * @param equivalent the reason why no requirement distinguishes it from the original; empty if one
 *     does
 */
record Mutant(
    String id,
    String does,
    String component,
    List<Change> changes,
    String scenario,
    String criterion,
    String equivalent) {

  private static final Set<String> KEYS =
      Set.of("id", "does", "component", "change", "scenario", "criterion", "equivalent");

  private static final Set<String> CHANGE_KEYS = Set.of("component", "replace", "by");

  /** A text of a component and its replacement. */
  record Change(String component, String replace, String by) {}

  /**
   * Reads the mutants of a file.
   *
   * @throws IllegalArgumentException if an entry has neither a failing criterion nor a reason for
   *     equivalence, or both, or an unknown key
   */
  static List<Mutant> read(Path file) throws IOException {
    Map<?, ?> content =
        new Yaml(new SafeConstructor(new LoaderOptions())).load(Files.readString(file));
    return ((List<?>) content.get("mutants")).stream().map(each -> of((Map<?, ?>) each)).toList();
  }

  private static Mutant of(Map<?, ?> entry) {
    refuseOthers(entry, KEYS);
    String criterion = optional(entry, "criterion").orElse("");
    String equivalent = optional(entry, "equivalent").orElse("");
    // An empty beginning would match every failed criterion.
    if (criterion.isBlank() == equivalent.isBlank()) {
      throw new IllegalArgumentException("either a criterion or why it is equivalent: " + entry);
    }
    String component = text(entry, "component");
    List<Change> changes =
        ((List<?>) entry.get("change"))
            .stream().map(each -> change((Map<?, ?>) each, component)).toList();
    return new Mutant(
        text(entry, "id"),
        text(entry, "does"),
        component,
        changes,
        text(entry, "scenario"),
        criterion,
        equivalent);
  }

  /** Returns software of others, for one scenario: as a mutant that no requirement refuses. */
  static Mutant variant(Map<?, ?> entry, String scenario) {
    refuseOthers(entry, Set.of("id", "does", "change"));
    List<Change> changes =
        ((List<?>) entry.get("change")).stream().map(each -> change((Map<?, ?>) each, "")).toList();
    return new Mutant(
        text(entry, "id"),
        text(entry, "does"),
        changes.get(0).component(),
        changes,
        scenario,
        "",
        "within the requirements");
  }

  /** Returns the component of a change: the mutant's unless the change names another one. */
  private static Change change(Map<?, ?> entry, String component) {
    refuseOthers(entry, CHANGE_KEYS);
    return new Change(
        optional(entry, "component").orElse(component), text(entry, "replace"), text(entry, "by"));
  }

  private static void refuseOthers(Map<?, ?> entry, Set<String> keys) {
    if (!keys.containsAll(entry.keySet())) {
      throw new IllegalArgumentException("one of the keys is not known: " + entry);
    }
  }

  private static Optional<String> optional(Map<?, ?> entry, String key) {
    return entry.containsKey(key) ? Optional.of(text(entry, key)) : Optional.empty();
  }

  private static String text(Map<?, ?> entry, String key) {
    if (!(entry.get(key) instanceof String text)) {
      throw new IllegalArgumentException(key + " is no text: " + entry);
    }
    return text;
  }

  /** Applies the changes to a folder of components. */
  void putInto(Path components) {
    try {
      for (Change change : changes) {
        Path file = components.resolve(change.component() + ".py");
        String text = Files.readString(file);
        assertEquals(1, text.split(Pattern.quote(change.replace()), -1).length - 1, this::toString);
        Files.writeString(file, text.replace(change.replace(), change.by()));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public String toString() {
    return id + " (" + does + ")";
  }
}
