package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

/**
 * A component that was changed so that somebody responsible for safety would fail it.
 *
 * @param id what tests call it
 * @param does how it behaves, in words
 * @param component the name of the component
 * @param changes the texts that are replaced, each of which stands exactly once in the component
 * @param scenario the one that fails it
 * @param criterion how the text of the criterion begins that fails it; empty if it is equivalent
 * @param equivalent why no requirement tells it from the original; empty if one does
 */
record Mutant(
    String id,
    String does,
    String component,
    List<Change> changes,
    String scenario,
    String criterion,
    String equivalent) {

  /** A text and what takes its place. */
  record Change(String replace, String by) {}

  /** Those of a file. */
  static List<Mutant> read(Path file) throws IOException {
    Map<?, ?> content =
        new Yaml(new SafeConstructor(new LoaderOptions())).load(Files.readString(file));
    return ((List<?>) content.get("mutants")).stream().map(each -> of((Map<?, ?>) each)).toList();
  }

  private static Mutant of(Map<?, ?> entry) {
    return new Mutant(
        text(entry, "id"),
        text(entry, "does"),
        text(entry, "component"),
        ((List<?>) entry.get("change"))
            .stream()
                .map(each -> (Map<?, ?>) each)
                .map(each -> new Change(text(each, "replace"), text(each, "by")))
                .toList(),
        text(entry, "scenario"),
        entry.containsKey("criterion") ? text(entry, "criterion") : "",
        entry.containsKey("equivalent") ? text(entry, "equivalent") : "");
  }

  private static String text(Map<?, ?> entry, String key) {
    if (!(entry.get(key) instanceof String text)) {
      throw new IllegalArgumentException(key + " is no text: " + entry);
    }
    return text;
  }

  /** Changes the component in a folder of components. */
  void putInto(Path components) {
    try {
      Path file = components.resolve(component + ".py");
      String text = Files.readString(file);
      for (Change change : changes) {
        assertEquals(1, text.split(Pattern.quote(change.replace()), -1).length - 1, this::toString);
        text =
            text.replaceFirst(
                Pattern.quote(change.replace()), Matcher.quoteReplacement(change.by()));
      }
      Files.writeString(file, text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public String toString() {
    return id + " (" + does + ")";
  }
}
