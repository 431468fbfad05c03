package dev.eventchain.openscenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.openscenario.vocabulary.AttributeType;
import dev.eventchain.openscenario.vocabulary.ElementType;
import dev.eventchain.openscenario.vocabulary.Enumeration;
import dev.eventchain.openscenario.vocabulary.Version;
import dev.eventchain.openscenario.vocabulary.Vocabulary;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The table of the vocabulary in itself. */
class VocabularyTest {

  private static final Vocabulary STANDARD = Vocabulary.standard();

  private static final Set<String> PRIMITIVES =
      Set.of(
          "String",
          "Double",
          "DoubleOrInfinite",
          "Int",
          "UnsignedInt",
          "UnsignedShort",
          "Boolean",
          "DateTime");

  @Test
  void eachTypeIsReachedFromTheRoot() {
    Set<String> reached = new TreeSet<>();
    Deque<String> next = new ArrayDeque<>(List.of("OpenScenario"));
    while (!next.isEmpty()) {
      String type = next.pop();
      if (reached.add(type)) {
        next.addAll(STANDARD.element(type).children().values());
      }
    }
    Set<String> all = new TreeSet<>(STANDARD.elements().stream().map(ElementType::name).toList());
    assertEquals(all, reached);
    assertEquals(287, all.size());
  }

  @Test
  void eachAttributeHasAKnownType() {
    Set<String> used = new TreeSet<>();
    for (ElementType type : STANDARD.elements()) {
      for (AttributeType attribute : type.attributes().values()) {
        boolean known = STANDARD.enumeration(attribute.type()).isPresent();
        assertTrue(known || PRIMITIVES.contains(attribute.type()), type + " " + attribute);
        assertTrue(type.attributes().containsKey(attribute.latest()), attribute.toString());
        attribute
            .otherwise()
            .filter(value -> known)
            .ifPresent(
                value -> assertTrue(isLatest(attribute.type(), value), attribute.toString()));
        used.add(attribute.type());
      }
    }
    STANDARD.enumerations().forEach(each -> assertTrue(used.contains(each.name()), each.name()));
  }

  private static boolean isLatest(String enumeration, String word) {
    Enumeration.Literal literal =
        STANDARD.enumeration(enumeration).orElseThrow().literal(word).orElseThrow();
    return literal.latest().equals(word);
  }

  @Test
  void wordsOfEarlierVersionsHaveOneOfTheLatest() {
    for (Enumeration each : STANDARD.enumerations()) {
      for (Enumeration.Literal literal : each.literals()) {
        assertTrue(isLatest(each.name(), literal.latest()), each.name() + " " + literal);
      }
    }
    Enumeration priority = STANDARD.enumeration("Priority").orElseThrow();
    assertEquals("override", priority.literal("overwrite").orElseThrow().latest());
    assertEquals(new Version(2), priority.literal("override").orElseThrow().since());
  }

  @Test
  void versionsDiffer() {
    ElementType event = STANDARD.element("Event");
    assertEquals(
        "[Mismatch[kind=MISSING, name=StartTrigger]]",
        event.content(Version.FIRST).mismatches(Map.of("Action", 1)).toString());
    assertEquals(List.of(), event.content(Version.LATEST).mismatches(Map.of("Action", 1)));
    AttributeType along =
        STANDARD.element("TimeHeadwayCondition").attribute("alongRoute").orElseThrow();
    assertTrue(along.isRequired(Version.FIRST));
    assertTrue(!along.isRequired(new Version(1)));
  }
}
