package dev.eventchain.ocl;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.parse.FrequentMistakes;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.InvalidType;

/**
 * The part of an expression before an offset, which need not be complete: the variables there, and
 * what stands before the last dot or arrow. The parser reads each complete part of it; only which
 * parentheses, loops and {@code let} are still open is found by the tokens.
 */
final class OpenExpression {

  /** A parenthesis, brace or bracket that is open, with what held before it. */
  private static final class Frame {
    private final int open;
    private final Scope scope;
    private final List<EClassifier> implicit;
    private final Deque<Integer> lets = new ArrayDeque<>();
    private EClassifier element;
    private int commas;

    private Frame(int open, Scope scope, List<EClassifier> implicit) {
      this.open = open;
      this.scope = scope;
      this.implicit = implicit;
    }
  }

  /** A call whose parenthesis is open: its name, its source, and the index of the argument. */
  record Call(String name, String operator, Optional<EClassifier> source, int argument) {}

  private static final Set<String> NAVIGATIONS = Set.of(".", "->", "::");

  private final ExpressionLanguage language;
  private final SourceRange text;
  private final Tokens tokens;
  private final Deque<Frame> frames = new ArrayDeque<>();
  private Scope scope;
  private List<EClassifier> implicit = List.of();

  /**
   * Reads an expression up to an offset.
   *
   * @param text the part before the offset
   * @param scope the scope of the whole expression
   */
  OpenExpression(ExpressionLanguage language, SourceRange text, Scope scope) {
    this.language = language;
    this.text = text;
    this.tokens = new Tokens(text.text());
    this.scope = scope;
    frames.push(new Frame(-1, scope, List.of()));
    for (int i = 0; i < tokens.size(); i++) {
      read(i);
    }
    frames.peek().lets.descendingIterator().forEachRemaining(let -> declareLet(let, tokens.size()));
  }

  /** Returns the scope at the end. */
  Scope scope() {
    return scope;
  }

  /** Returns the types of the elements of loops without a variable, the innermost first. */
  List<EClassifier> implicit() {
    return implicit;
  }

  /** Returns the last token; empty if there is none. */
  String last() {
    return tokens.size() == 0 ? "" : tokens.text(tokens.size() - 1);
  }

  /** Returns the token before the last one; empty if there is none. */
  String beforeLast() {
    return tokens.size() < 2 ? "" : tokens.text(tokens.size() - 2);
  }

  /** Returns the names before the double colon at the end: {@code a::b::}. */
  List<String> path() {
    List<String> names = new ArrayList<>();
    for (int i = tokens.size() - 1; i > 0 && tokens.is(i, "::") && tokens.isName(i - 1); i -= 2) {
      names.add(0, tokens.text(i - 1));
    }
    return names;
  }

  /** Returns what stands before the dot or arrow at the end. */
  Optional<SourceRange> receiver() {
    return before(tokens.size() - 1);
  }

  /** Returns the chain of calls that ends here. */
  Optional<SourceRange> chain() {
    return tokens.size() == 0
        ? Optional.empty()
        : Optional.of(range(chainStart(tokens.size() - 1), tokens.size()));
  }

  /** Returns the type of what stands before the dot or arrow at the end. */
  Optional<EClassifier> receiverType() {
    return receiver().flatMap(this::type);
  }

  /** Returns the innermost call that is open. */
  Optional<Call> call() {
    for (Frame frame : frames) {
      int name = frame.open - 1;
      if (name >= 0 && tokens.is(frame.open, "(") && tokens.isName(name)) {
        String operator = name > 0 ? tokens.text(name - 1) : "";
        boolean navigates = operator.equals(".") || operator.equals("->");
        Optional<EClassifier> source =
            navigates ? before(name - 1).flatMap(range -> type(range, frame)) : Optional.empty();
        return Optional.of(
            new Call(tokens.text(name), navigates ? operator : "", source, frame.commas));
      }
    }
    return Optional.empty();
  }

  private Optional<EClassifier> type(SourceRange range, Frame frame) {
    return type(range, frame.scope, frame.implicit);
  }

  /** Returns the type of a part in the present scope; empty if it is not known. */
  Optional<EClassifier> type(SourceRange range) {
    return type(range, scope, implicit);
  }

  private Optional<EClassifier> type(SourceRange range, Scope where, List<EClassifier> sources) {
    Tokens first = new Tokens(range.text());
    boolean named = first.size() > 0 && where.typeOf(first.text(0)) != null;
    if (!named) {
      for (EClassifier source : sources) {
        Optional<EClassifier> found = known(range, where.with("self", source));
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return known(range, where);
  }

  private Optional<EClassifier> known(SourceRange range, Scope where) {
    return language
        .understand(range, where)
        .map(tree -> tree.getType())
        .filter(type -> !(type instanceof InvalidType<?>));
  }

  private void read(int i) {
    switch (tokens.text(i)) {
      case "(", "{", "[" -> open(i);
      case ")", "}", "]" -> close();
      case "|" -> declareIterators(i);
      case "," -> frames.peek().commas++;
      case "let" -> frames.peek().lets.push(i);
      case "in" -> {
        if (!frames.peek().lets.isEmpty()) {
          declareLet(frames.peek().lets.pop(), i);
        }
      }
      default -> {}
    }
  }

  private void open(int i) {
    Frame frame = new Frame(i, scope, implicit);
    boolean loop =
        i > 1
            && tokens.is(i, "(")
            && tokens.is(i - 2, "->")
            && FrequentMistakes.ITERATORS.contains(tokens.text(i - 1));
    if (loop) {
      Optional<EClassifier> element =
          before(i - 2).flatMap(this::type).map(type -> language.elementType(type).orElse(type));
      if (element.isPresent()) {
        frame.element = element.get();
        List<EClassifier> inner = new ArrayList<>(implicit);
        inner.add(0, element.get());
        implicit = inner;
      }
    }
    frames.push(frame);
  }

  private void close() {
    if (frames.size() > 1) {
      Frame closed = frames.pop();
      scope = closed.scope;
      implicit = closed.implicit;
    }
  }

  /** Adds the variables before the bar of a loop: {@code a, b : T |}, {@code a; sum : T = 0 |}. */
  private void declareIterators(int bar) {
    Frame frame = frames.peek();
    int before = frame.open - 1;
    if (before < 1 || !tokens.is(frame.open, "(") || !tokens.is(before - 1, "->")) {
      return;
    }
    implicit = frame.implicit;
    frame.commas = 0;
    EClassifier element = frame.element == null ? language.any() : frame.element;
    for (int i = frame.open + 1; i < bar; ) {
      int end = endOfVariable(i, bar);
      declare(i, end, element);
      i = end + 1;
    }
  }

  /** Adds the variables between a {@code let} and its {@code in}, or before the last comma. */
  private void declareLet(int let, int end) {
    boolean whole = tokens.is(end, "in");
    for (int i = let + 1; i < end; ) {
      int next = endOfVariable(i, end);
      if (next < end || whole) {
        declare(i, next, null);
      }
      i = next + 1;
    }
  }

  /** Returns the index of the comma or semicolon after a declaration, or the limit. */
  private int endOfVariable(int from, int limit) {
    int depth = 0;
    for (int i = from; i < limit; i++) {
      String token = tokens.text(i);
      depth += "([{".contains(token) || token.equals("let") ? 1 : 0;
      depth -= ")]}".contains(token) || token.equals("in") ? 1 : 0;
      if (depth == 0 && (token.equals(",") || token.equals(";"))) {
        return i;
      }
    }
    return limit;
  }

  /** Adds {@code name : Type = value}, where type and value may be missing. */
  private void declare(int from, int to, EClassifier usual) {
    if (from >= to || !tokens.isName(from)) {
      return;
    }
    int equals = from;
    while (equals < to && !tokens.is(equals, "=")) {
      equals++;
    }
    Optional<EClassifier> type = Optional.ofNullable(usual);
    if (tokens.is(from + 1, ":") && from + 2 < equals) {
      type = language.type(range(from + 2, equals), new ArrayList<>());
    } else if (equals + 1 < to) {
      type = type(range(equals + 1, to));
    }
    int offset = text.start() + tokens.start(from);
    scope = scope.with(tokens.text(from), type.orElse(language.any()), offset);
  }

  /** Returns what stands before a dot or arrow. */
  private Optional<SourceRange> before(int operator) {
    int last = operator - 1;
    if (last >= 0 && tokens.is(last, "?")) {
      last--;
    }
    return last < 0 || operator < 0 || !NAVIGATIONS.contains(tokens.text(operator))
        ? Optional.empty()
        : Optional.of(range(chainStart(last), last + 1));
  }

  /** Returns the index of the first token of the chain of calls that ends with a token. */
  private int chainStart(int end) {
    int i = end;
    while (true) {
      i = segmentStart(i);
      int operator = i - 1;
      if (operator < 1 || !NAVIGATIONS.contains(tokens.text(operator))) {
        return i;
      }
      int before = tokens.is(operator - 1, "?") ? operator - 2 : operator - 1;
      if (before < 0) {
        return i;
      }
      i = before;
    }
  }

  /** Returns the start of a name, a literal, a call, a parenthesis or an {@code if}. */
  private int segmentStart(int end) {
    String token = tokens.text(end);
    if (token.equals("endif")) {
      return opening(end, "if", "endif");
    } else if (")]}".contains(token)) {
      String open = token.equals(")") ? "(" : token.equals("]") ? "[" : "{";
      int start = opening(end, open, token);
      boolean called = start > 0 && tokens.isName(start - 1) && !isWord(tokens.text(start - 1));
      return called ? start - 1 : start;
    }
    return end;
  }

  private static boolean isWord(String name) {
    return Set.of("and", "or", "xor", "not", "implies", "if", "then", "else", "in", "let")
        .contains(name);
  }

  private int opening(int end, String open, String close) {
    int depth = 0;
    for (int i = end; i >= 0; i--) {
      depth += tokens.is(i, close) ? 1 : tokens.is(i, open) ? -1 : 0;
      if (depth == 0) {
        return i;
      }
    }
    return 0;
  }

  private SourceRange range(int from, int to) {
    return text.source()
        .range(text.start() + tokens.start(from), text.start() + tokens.end(to - 1));
  }
}
