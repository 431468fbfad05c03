package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SourceRangeTest {

  private final SourceText source = SourceText.of("rules.ocl", "inv:\n  self.x  \n\n");

  @Test
  void stripKeepsThePlaceOfWhatIsLeft() {
    SourceRange stripped = source.range(4, 16).strip();
    assertEquals("self.x", stripped.text());
    assertEquals(source.at(2, 3), stripped.location());
  }

  @Test
  void stripOfWhiteSpaceIsEmpty() {
    SourceRange blank = source.range(13, 17);
    assertTrue(blank.strip().isEmpty());
    assertTrue(!blank.isEmpty());
  }

  @Test
  void wholeIsTheTextWithoutItsByteOrderMark() {
    assertEquals("self", SourceText.of("a", "\uFEFFself").whole().text());
  }

  @Test
  void refusesWhatIsNotInsideTheText() {
    int length = source.text().length();
    assertThrows(IndexOutOfBoundsException.class, () -> source.range(-1, 2));
    assertThrows(IndexOutOfBoundsException.class, () -> source.range(3, 2));
    assertThrows(IndexOutOfBoundsException.class, () -> source.range(0, length + 1));
  }
}
