package dev.eventchain.retrieval;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Words of requirements, and the words of catalogues for the same things. */
final class Synonyms {

  private static final String RESOURCE = "synonyms.txt";

  /** Words to look for, by the words of a phrase with a blank between them. */
  private final Map<String, Set<String>> byPhrase = new LinkedHashMap<>();

  private Synonyms() {}

  /** Returns those of this bundle. */
  static Synonyms shipped() {
    Synonyms synonyms = new Synonyms();
    try (InputStream stream = Synonyms.class.getResourceAsStream(RESOURCE)) {
      new String(stream.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.isBlank() && !line.startsWith("#"))
          .forEach(synonyms::add);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return synonyms;
  }

  /** Returns none. */
  static Synonyms none() {
    return new Synonyms();
  }

  private void add(String line) {
    String[] sides = line.split("=>", 2);
    List<String> meant = Words.of(sides[1]);
    for (String phrase : sides[0].split(",", -1)) {
      byPhrase
          .computeIfAbsent(String.join(" ", Words.of(phrase)), key -> new LinkedHashSet<>())
          .addAll(meant);
    }
  }

  /** Returns what to look for besides the words of a text. */
  Set<String> of(List<String> words) {
    String text = " " + String.join(" ", words) + " ";
    Set<String> more = new LinkedHashSet<>();
    byPhrase.forEach(
        (phrase, meant) -> {
          if (text.contains(" " + phrase + " ")) {
            more.addAll(meant);
          }
        });
    words.forEach(more::remove);
    return more;
  }
}
