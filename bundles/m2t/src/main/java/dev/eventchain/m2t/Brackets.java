package dev.eventchain.m2t;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * Looks for brackets in the literal text of a template that have no partner: usually a {@code [}
 * that was forgotten, for it has to be written {@code ['['/]}. Where the brackets depend on
 * conditions or are computed it keeps silent.
 */
final class Brackets {
  private final String source;
  private final Deque<Integer> open = new ArrayDeque<>();
  private final List<Integer> closeWithoutOpen = new ArrayList<>();
  private boolean unknown;

  private Brackets(String source) {
    this.source = source;
  }

  /** Warns of the first bracket of a template, or of a file in it, that has no partner. */
  static void check(List<Syntax.Node> body, Problems problems) {
    Brackets brackets = new Brackets(problems.source().text());
    brackets.walk(body, problems);
    brackets.report(problems);
  }

  private void report(Problems problems) {
    Optional<Integer> place = place();
    if (!unknown && place.isPresent()) {
      boolean closes = open.isEmpty() || !closeWithoutOpen.isEmpty();
      problems.warning(
          "m2t.lint.bracket",
          place.get(),
          "The text has a '"
              + (closes ? ']' : '[')
              + "' without the '"
              + (closes ? '[' : ']')
              + "' that belongs to it.",
          "A bracket that opens is written ['['/], one that closes ] or [']'/].");
    }
  }

  private Optional<Integer> place() {
    return closeWithoutOpen.isEmpty()
        ? Optional.ofNullable(open.peekLast())
        : Optional.of(closeWithoutOpen.get(0));
  }

  private void walk(List<Syntax.Node> nodes, Problems problems) {
    for (Syntax.Node node : nodes) {
      if (node instanceof Syntax.Text text) {
        text(text);
      } else if (node instanceof Syntax.Output output) {
        output(output);
      } else if (node instanceof Syntax.For loop) {
        decoration(loop.decoration().before());
        walk(loop.body(), problems);
        decoration(loop.decoration().after());
      } else if (node instanceof Syntax.If choice) {
        List<List<Syntax.Node>> bodies =
            new ArrayList<>(choice.branches().stream().map(Syntax.Branch::body).toList());
        bodies.add(choice.otherwise());
        branches(bodies, problems);
      } else if (node instanceof Syntax.Let choice) {
        List<List<Syntax.Node>> bodies =
            new ArrayList<>(choice.bindings().stream().map(Syntax.Binding::body).toList());
        bodies.add(choice.otherwise());
        branches(bodies, problems);
      } else if (node instanceof Syntax.File file) {
        check(file.body(), problems);
      } else if (node instanceof Syntax.Protected area) {
        walk(area.body(), problems);
      }
    }
  }

  /** Only one of the branches is output; they must agree for anything to be known. */
  private void branches(List<List<Syntax.Node>> bodies, Problems problems) {
    List<Brackets> outcomes = new ArrayList<>();
    for (List<Syntax.Node> body : bodies) {
      Brackets outcome = new Brackets(source);
      outcome.walk(body, problems);
      outcomes.add(outcome);
    }
    Brackets first = outcomes.get(0);
    for (Brackets outcome : outcomes) {
      unknown |=
          outcome.unknown
              || outcome.open.size() != first.open.size()
              || outcome.closeWithoutOpen.size() != first.closeWithoutOpen.size();
    }
    first.closeWithoutOpen.forEach(this::close);
    first.open.descendingIterator().forEachRemaining(open::push);
  }

  private void text(Syntax.Text text) {
    // Only white space was taken from the text, so the brackets are those of the source.
    int at = text.start();
    for (int i = text.text().indexOf(']'); i >= 0; i = text.text().indexOf(']', i + 1)) {
      at = source.indexOf(']', at);
      close(at++);
    }
  }

  private void output(Syntax.Output output) {
    decoration(output.decoration().before());
    expression(output.value());
    decoration(output.decoration().after());
  }

  private void decoration(Optional<Span> text) {
    text.ifPresent(span -> expression(span.strip(source)));
  }

  private void expression(Span span) {
    int quote = span.start();
    Brackets inside = new Brackets(source);
    boolean literal = false;
    while (quote < span.end()) {
      int close = source.charAt(quote) == '\'' ? Quotes.close(source, quote, span.end()) : -1;
      if (close < 0) {
        quote++;
        continue;
      }
      literal |= quote == span.start() && close == span.end() - 1;
      inside.scan(quote + 1, close);
      quote = close + 1;
    }
    if (literal && isQuoted(span)) {
      return;
    }
    if (literal) {
      scan(span.start() + 1, span.end() - 1);
    } else {
      unknown |= !inside.open.isEmpty() || !inside.closeWithoutOpen.isEmpty();
    }
  }

  /** Whether quotes stand around a tag, so that its text is only mentioned: {@code "['['/]"}. */
  private boolean isQuoted(Span inside) {
    int before = source.lastIndexOf('[', inside.start()) - 1;
    int after = source.indexOf("/]", inside.end()) + 2;
    return before >= 0
        && after < source.length()
        && source.charAt(before) == source.charAt(after)
        && "\"'`".indexOf(source.charAt(before)) >= 0;
  }

  private void scan(int from, int to) {
    for (int i = from; i < to; i++) {
      if (source.charAt(i) == '[') {
        open.push(i);
      } else if (source.charAt(i) == ']') {
        close(i);
      }
    }
  }

  private void close(int at) {
    if (open.poll() == null) {
      closeWithoutOpen.add(at);
    }
  }
}
