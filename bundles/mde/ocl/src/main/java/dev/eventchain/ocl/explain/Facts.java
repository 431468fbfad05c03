package dev.eventchain.ocl.explain;

import dev.eventchain.ocl.metamodel.ValueTexts;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The facts of an explanation: a few values, each once, some of them under an element. */
final class Facts {

  private static final int MOST = 4;

  private final Set<String> told = new HashSet<>();
  private List<String> current = new ArrayList<>();
  private boolean grouped;

  /** Returns the number of values. */
  int size() {
    return told.size();
  }

  boolean full() {
    return told.size() >= MOST;
  }

  /** Adds the value of an expression. */
  void add(String expression, Object value) {
    add(expression + " " + ValueTexts.predicate(value));
  }

  /** Adds a fact in words. */
  void add(String words) {
    if (!full() && told.add(words)) {
      current.add(words);
    }
  }

  /**
   * Groups the facts that an action adds under one element.
   *
   * @param heading such as {@code for b = Book 'Dune'}
   * @param otherwise the fact to add if the action adds none
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

  /** Returns all facts as a sentence without full stop; empty if there are none. */
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
