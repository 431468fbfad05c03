package dev.eventchain.ocl.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests what editors ask of the language: its keywords, and where a number ends. */
class WordsTest {

  @Test
  void keywordsAreThoseOfTheParserAndOfDocuments() {
    assertEquals(
        "and body context def derive else endif endpackage false if implies import in include init"
            + " inv invalid let library not null or package post pre self static then true xor",
        String.join(" ", Keywords.ALL));
  }

  @Test
  void typesHaveValues() {
    assertEquals(
        "Bag Boolean Collection Integer OclAny OclInvalid OclVoid OrderedSet Real Sequence Set"
            + " String Tuple UnlimitedNatural",
        String.join(" ", Keywords.TYPES));
  }

  @Test
  void numbersEndAfterTheirExponent() {
    for (String number : List.of("1", "12", "1.5", "1e3", "1.5E+20", "2e-1")) {
      for (String after : List.of("", " ", "..3", ".max(2)", "e", "e+", "x")) {
        String text = "(" + number + after;
        assertEquals(1 + number.length(), Lexer.endOfNumber(text, 1, text.length()), text);
      }
    }
    assertEquals(2, Lexer.endOfNumber("1234", 0, 2));
  }
}
