package dev.eventchain.ocl.explain;

import dev.eventchain.ocl.metamodel.ValueTexts;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What an explanation tells: a few values, each once, some of them under an element. */
final class Facts {

  private static final int MOST = 4;

  private final Set<String> told = new HashSet<>();
  private List<String> current = new ArrayList<>();
  private boolean grouped;

  /** How many values have been told. */
  int size() {
    return told.size();
  }

  boolean full() {
    return told.size() >= MOST;
  }

  /** Tells the value of an expression. */
  void add(String expression, Object value) {
    add(expression + " " + ValueTexts.predicate(value));
  }

  /** Tells a fact in words. */
  void add(String words) {
    if (!full() && told.add(words)) {
      current.add(words);
    }
  }

  /**
   * Tells what is found meanwhile under one element.
   *
   * @param heading such as {@code for b = Book 'Dune'}
   * @param otherwise what to tell if nothing is found
   */
  void group(String heading, String otherwise, Runnable meanwhile) {
    List<String> outer = current;
    boolean outerGrouped = grouped;
    current = new ArrayList<>();
    grouped = false;
    meanwhile.run();
    String found = text();
    current = outer;
    grouped = outerGrouped;
    if (found.isEmpty()) {
      add(otherwise);
    } else {
      current.add(heading + ", " + found);
      grouped = true;
    }
  }

  /** All facts in one sentence without its end; empty if there are none. */
  String text() {
    if (grouped) {
      return String.join("; ", current);
    }
    int last = current.size() - 1;
    return last < 1
        ? String.join("", current)
        : String.join(", ", current.subList(0, last)) + " and " + current.get(last);
  }
}
