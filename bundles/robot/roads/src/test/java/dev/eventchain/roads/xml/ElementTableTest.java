package dev.eventchain.roads.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class ElementTableTest {

  @Test
  void whatIsNotReadHasAReason() {
    ElementTable.ENTRIES.forEach(
        (name, entry) ->
            assertEquals(
                entry.treatment() == ElementTable.Treatment.READ, entry.reason().isEmpty(), name));
  }

  /** Each parent but the root is read itself, or its children would not be looked at. */
  @Test
  void parentsAreRead() {
    Set<String> read =
        ElementTable.ENTRIES.entrySet().stream()
            .filter(entry -> entry.getValue().treatment() == ElementTable.Treatment.READ)
            .map(entry -> entry.getKey().replaceFirst(".*/", ""))
            .collect(Collectors.toCollection(TreeSet::new));
    Set<String> parents =
        ElementTable.ENTRIES.keySet().stream()
            .map(name -> name.replaceFirst("/.*", ""))
            .collect(Collectors.toCollection(TreeSet::new));
    parents.removeAll(read);
    assertEquals(Set.of("*", "OpenDRIVE"), parents);
    assertTrue(ElementTable.ENTRIES.size() > 100);
  }
}
