package dev.eventchain.editing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TextLinesTest {

  /** Positions count UTF-16 units, and each kind of line break is one. */
  @Test
  void convertsBothWays() {
    String text = "a\u00e4\ud83d\ude00b\r\nc\td\re\n\nf";
    TextLines lines = new TextLines(text);
    assertEquals(5, lines.count());
    assertEquals(new TextPosition(0, 4), lines.position(text.indexOf('b')));
    assertEquals(new TextPosition(1, 2), lines.position(text.indexOf('d')));
    assertEquals(new TextPosition(2, 0), lines.position(text.indexOf('e')));
    assertEquals(new TextPosition(4, 1), lines.position(text.length()));
    for (int i = 0; i <= text.length(); i++) {
      boolean insideBreak = i > 0 && text.startsWith("\r\n", i - 1);
      assertEquals(insideBreak ? i - 1 : i, lines.offset(lines.position(i)));
    }
  }

  @Test
  void takesTheNearestPositionOutside() {
    TextLines lines = new TextLines("ab\r\nc");
    assertEquals(2, lines.offset(new TextPosition(0, 99)));
    assertEquals(5, lines.offset(new TextPosition(7, 0)));
    assertEquals(0, lines.offset(new TextPosition(-1, 3)));
    assertEquals(new TextPosition(1, 1), lines.position(99));
    assertEquals(new TextPosition(0, 0), new TextLines("").position(-1));
  }
}
