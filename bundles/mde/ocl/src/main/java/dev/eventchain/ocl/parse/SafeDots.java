package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.text.Lexer;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;

/** The question marks of {@code ?.} and {@code ?->} in a text, which the older grammar lacks. */
final class SafeDots {

  static final Set<String> SIGNS = Set.of("?.", "?->");

  private final NavigableSet<Integer> offsets = new TreeSet<>();
  private final String plain;

  SafeDots(String text) {
    StringBuilder without = new StringBuilder(text);
    int end;
    for (int i = 0; i < text.length(); i = end) {
      end = Lexer.end(text, i, text.length());
      int here = i;
      if (SIGNS.stream().anyMatch(sign -> text.startsWith(sign, here))) {
        offsets.add(i);
        without.setCharAt(i, ' ');
      }
    }
    plain = without.toString();
  }

  /** Returns the text with spaces in place of the question marks. */
  String plain() {
    return plain;
  }

  /** Returns whether there is one between two offsets. */
  boolean between(int start, int end) {
    Integer next = offsets.ceiling(start);
    return next != null && next < end;
  }
}
