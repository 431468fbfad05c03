package dev.eventchain.openscenario.vocabulary;

import dev.eventchain.diagnostics.ResourceText;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the table of the vocabulary, whose head explains its notation. */
final class VocabularyReader {

  /** The end of a line: what is said about a name. */
  private static final Pattern FACT = Pattern.compile(" (since|default|now) (\\S+)");

  private final Map<String, ElementType> elements = new TreeMap<>();
  private final Map<String, Enumeration> enumerations = new TreeMap<>();

  private String name = "";
  private Version since = Version.FIRST;
  private boolean isEnumeration;
  private Map<String, AttributeType> attributes = new LinkedHashMap<>();
  private NavigableMap<Version, Content> contents = new TreeMap<>();
  private boolean hasText;
  private List<Enumeration.Literal> literals = new ArrayList<>();

  static Vocabulary read(String resource) {
    VocabularyReader reader = new VocabularyReader();
    ResourceText.of(VocabularyReader.class, resource)
        .lines()
        .filter(line -> !line.startsWith("#"))
        .forEach(reader::line);
    reader.end();
    return new Vocabulary(reader.elements, reader.enumerations);
  }

  private void line(String line) {
    Map<String, String> facts = new HashMap<>();
    Matcher fact = FACT.matcher(line);
    while (fact.find()) {
      facts.put(fact.group(1), fact.group(2));
    }
    String stated = FACT.matcher(line).replaceAll("");
    if (!line.startsWith(" ")) {
      end();
      begin(stated, facts);
    } else if (stated.startsWith("  @")) {
      attribute(stated.substring(3).split(" ", 2), facts);
    } else if (stated.startsWith("  = ")) {
      contents.put(version(facts), ContentReader.read(stated.substring(4)));
    } else if (isEnumeration) {
      String word = stated.strip();
      literals.add(new Enumeration.Literal(word, version(facts), facts.getOrDefault("now", word)));
    } else {
      hasText = true;
    }
  }

  private void begin(String stated, Map<String, String> facts) {
    since = Version.FIRST;
    since = version(facts);
    isEnumeration = stated.startsWith("enumeration ");
    name = stated.substring(stated.indexOf(' ') + 1);
    attributes = new LinkedHashMap<>();
    contents = new TreeMap<>();
    hasText = false;
    literals = new ArrayList<>();
  }

  private void end() {
    if (isEnumeration) {
      enumerations.put(name, new Enumeration(name, since, literals));
    } else if (!name.isEmpty()) {
      contents.putIfAbsent(since, ContentReader.read(""));
      Map<String, String> children = new LinkedHashMap<>();
      for (Content content : contents.descendingMap().values()) {
        content.children().forEach(children::putIfAbsent);
      }
      elements.put(name, new ElementType(name, since, attributes, contents, children, hasText));
    }
  }

  /** Returns the version of a line; that of its type if it says none. */
  private Version version(Map<String, String> facts) {
    return facts.containsKey("since") ? Version.parse(facts.get("since")) : since;
  }

  private void attribute(String[] words, Map<String, String> facts) {
    boolean required = !words[1].endsWith("?");
    String type = required ? words[1] : words[1].substring(0, words[1].length() - 1);
    AttributeType before = attributes.get(words[0]);
    List<AttributeType.Use> uses = new ArrayList<>(before == null ? List.of() : before.uses());
    uses.add(new AttributeType.Use(version(facts), required));
    attributes.put(
        words[0],
        new AttributeType(
            words[0],
            type,
            uses,
            Optional.ofNullable(facts.get("default")),
            facts.getOrDefault("now", words[0])));
  }
}
