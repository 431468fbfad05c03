package dev.eventchain.lsp.project;

import dev.eventchain.editing.Folding;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/** Folding and selection by the parts of an outline. */
final class Outline {

  private Outline() {}

  /** Returns the lines of the parts that have several; of parts with the same first line, one. */
  static List<Folding> foldings(List<Symbol> symbols) {
    List<Folding> found = new ArrayList<>();
    add(symbols, found);
    return found;
  }

  private static void add(List<Symbol> symbols, List<Folding> found) {
    for (Symbol each : symbols) {
      int first = each.range().start().line();
      int last = each.range().end().line();
      boolean isNew = found.isEmpty() || found.get(found.size() - 1).firstLine() != first;
      if (last > first && isNew) {
        found.add(new Folding(first, last, Folding.Kind.BLOCK));
      }
      add(each.children(), found);
    }
  }

  /** Returns the ranges of the names and parts around a position, the innermost first. */
  static List<TextRange> selection(List<Symbol> symbols, TextPosition position) {
    List<TextRange> found = new ArrayList<>();
    Optional<Symbol> around = at(symbols, position);
    while (around.isPresent()) {
      found.add(around.get().range());
      Optional<Symbol> inside = at(around.get().children(), position);
      if (inside.isEmpty() && around.get().nameRange().touches(position)) {
        found.add(around.get().nameRange());
      }
      around = inside;
    }
    Collections.reverse(found);
    return found.stream().distinct().toList();
  }

  private static Optional<Symbol> at(List<Symbol> symbols, TextPosition position) {
    return symbols.stream().filter(each -> each.range().touches(position)).findFirst();
  }
}
