package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceRange;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * Check for unpaired brackets in the literal text of a template: usually a missing {@code [}, which
 * must be written {@code ['['/]}. It reports nothing if brackets depend on conditions or are
 * computed.
 */
public final class Brackets {
  private final String source;
  private final Deque<Integer> open = new ArrayDeque<>();
  private final List<Integer> closeWithoutOpen = new ArrayList<>();
  private boolean unknown;

  private Brackets(String source) {
    this.source = source;
  }

  /** Warns of the first unpaired bracket of a template, or of a file in it. */
  public static void check(List<Syntax.Node> body, Problems problems) {
    if (!new Brackets(problems.source().text()).isOnlyABracket(body)) {
      checkText(body, problems);
    }
  }

  private static void checkText(List<Syntax.Node> text, Problems problems) {
    Brackets brackets = new Brackets(problems.source().text());
    brackets.walk(text, problems);
    brackets.report(problems);
  }

  /**
   * Returns whether the whole text of a template is a bracket, which is intended: another template
   * has the partner.
   */
  private boolean isOnlyABracket(List<Syntax.Node> body) {
    StringBuilder whole = new StringBuilder();
    for (Syntax.Node node : body) {
      if (node instanceof Syntax.Text text) {
        whole.append(text.text().strip());
      } else if (node instanceof Syntax.Output output) {
        whole.append(output.value().text().replace("'", ""));
      } else {
        return false;
      }
    }
    return whole.length() == 1;
  }

  private void report(Problems problems) {
    Optional<Integer> place = place();
    if (!unknown && place.isPresent()) {
      boolean closes = open.isEmpty() || !closeWithoutOpen.isEmpty();
      problems.add(
          SyntaxRules.LINT_BRACKET,
          place.get(),
          "The text has a '"
              + (closes ? ']' : '[')
              + "' without the '"
              + (closes ? '[' : ']')
              + "' that belongs to it.",
          "An opening bracket is written ['['/], a closing one ] or [']'/].");
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
        checkText(file.body(), problems);
      } else if (node instanceof Syntax.Protected area) {
        walk(area.body(), problems);
      }
    }
  }

  /** Checks branches. Only one is output, so they must agree on their brackets. */
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
    // The text differs from the source in white space only, so the brackets are the same.
    int at = text.start();
    for (int i = text.text().indexOf(']'); i >= 0; i = text.text().indexOf(']', i + 1)) {
      at = source.indexOf(']', at);
      if (!isMentioned(at)) {
        close(at);
      }
      at++;
    }
  }

  private void output(Syntax.Output output) {
    decoration(output.decoration().before());
    expression(output.value());
    decoration(output.decoration().after());
  }

  private void decoration(Optional<SourceRange> text) {
    text.ifPresent(span -> expression(span.strip()));
  }

  private void expression(SourceRange span) {
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
    if (literal && isMentioned(span.start())) {
      return;
    }
    if (literal) {
      scan(span.start() + 1, span.end() - 1);
    } else {
      unknown |= !inside.open.isEmpty() || !inside.closeWithoutOpen.isEmpty();
    }
  }

  /**
   * Returns whether an offset is inside quotes on its line, so that a bracket there needs no
   * partner: {@code if text == "]":}. Tags on the line are ignored.
   */
  private boolean isMentioned(int at) {
    int lineEnd = source.indexOf('\n', at) < 0 ? source.length() : source.indexOf('\n', at);
    int i = source.lastIndexOf('\n', at) + 1;
    char quote = 0;
    while (i < at) {
      char c = source.charAt(i);
      int next = c == '[' ? tagEnd(i, lineEnd) : i + 1;
      if (next > at) {
        return quote != 0 && isBetween(source.indexOf(quote, next), lineEnd);
      }
      if (c == quote) {
        quote = 0;
      } else if (quote == 0 && "\"'`".indexOf(c) >= 0) {
        quote = c;
      }
      i = next;
    }
    return quote != 0 && isBetween(source.indexOf(quote, at), lineEnd);
  }

  private static boolean isBetween(int found, int end) {
    return found >= 0 && found < end;
  }

  /** Returns the offset after a tag. */
  private int tagEnd(int start, int lineEnd) {
    boolean quoted = false;
    for (int i = start + 1; i < lineEnd; i++) {
      char c = source.charAt(i);
      if (c == '\'') {
        quoted = !quoted;
      } else if (c == ']' && !quoted) {
        return i + 1;
      }
    }
    return lineEnd;
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
