package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class NearestNameTest {

  private static final List<String> NAMES = List.of("frequency", "fieldName", "topicName", "unit");

  @Test
  void findsWhatWasMisspelt() {
    assertEquals(Optional.of("frequency"), NearestName.of("freqeuncy", NAMES));
    assertEquals(Optional.of("frequency"), NearestName.of("Frequency", NAMES));
    assertEquals(Optional.of("fieldName"), NearestName.of("field_name", NAMES));
    assertEquals(Optional.of("unit"), NearestName.of("units", NAMES));
  }

  @Test
  void findsNothingWhereNothingIsNear() {
    assertEquals(Optional.empty(), NearestName.of("priority", NAMES));
    assertEquals(Optional.empty(), NearestName.of("x", List.of()));
  }

  @Test
  void takesTheFirstOfEquallyNearNames() {
    assertEquals(Optional.of("ab"), NearestName.of("aX", List.of("ac", "ab")));
    assertEquals(Optional.of("book"), NearestName.of("bok", List.of("Book", "book")));
  }

  @Test
  void neverAsksForTheUnknownNameItself() {
    assertEquals("Did you mean `units`?", NearestName.question("unit", List.of("unit", "units")));
    assertEquals("", NearestName.question("unit", List.of("unit")));
  }

  @Test
  void hintsDoNotNameTheUnknownNameItself() {
    assertEquals("Known are `gap`.", NearestName.hint("speed", List.of("speed", "gap")));
    assertEquals("Did you mean `sped`?", NearestName.hint("speed", List.of("speed", "sped")));
    assertEquals("", NearestName.hint("speed", List.of("speed")));
  }

  @Test
  void hintsNameTheNearestOrAll() {
    assertEquals("Did you mean `unit`?", NearestName.hint("unti", NAMES));
    assertEquals("Known are `a`, `b`.", NearestName.hint("zzzzzz", List.of("b", "a", "b")));
    assertEquals("", NearestName.hint("x", List.of()));
  }
}
