package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.syntax.Syntax.Binding;
import dev.eventchain.m2t.syntax.Syntax.Branch;
import dev.eventchain.m2t.syntax.Syntax.Decoration;
import dev.eventchain.m2t.syntax.Syntax.Node;
import dev.eventchain.m2t.syntax.Syntax.Variable;
import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;

/** Parser of the blocks inside a template. The tokens are balanced, so blocks always end. */
final class BlockParser {
  private static final Decoration NONE =
      new Decoration(
          Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), List.of());

  private static final Pattern TEXT = Pattern.compile("[\\w\\[]");

  private final Problems problems;
  private final List<Token> tokens;
  private final List<Syntax.Text> texts;
  private int next;

  /** True if the current block is in a protected area of its file. */
  private boolean inArea;

  /** True to keep the body of a block whose tag cannot be read. */
  private final boolean keepsBodies;

  BlockParser(Problems problems, List<Token> tokens, List<Syntax.Text> texts, boolean keepsBodies) {
    this.keepsBodies = keepsBodies;
    this.problems = problems;
    this.tokens = tokens;
    this.texts = texts;
  }

  /** Returns the index of the tag that closes the block opened at an index. */
  int closing(int open) {
    int depth = 0;
    for (int i = open; i < tokens.size(); i++) {
      Kind kind = tokens.get(i).kind();
      if (kind == Kind.OPEN) {
        depth++;
      } else if (kind == Kind.CLOSE && --depth == 0) {
        return i;
      }
    }
    throw new IllegalStateException("unbalanced tokens");
  }

  /** Parses the body of a template. */
  List<Node> templateBody(int open) {
    next = open + 1;
    return body();
  }

  /** Reads nodes up to the next middle or closing tag. */
  private List<Node> body() {
    List<Node> nodes = new ArrayList<>();
    while (true) {
      Token token = tokens.get(next);
      switch (token.kind()) {
        case MIDDLE, CLOSE -> {
          return List.copyOf(nodes);
        }
        case TEXT -> {
          if (!texts.get(next).text().isEmpty()) {
            nodes.add(texts.get(next));
          }
          next++;
        }
        case EXPRESSION -> {
          next++;
          output(token).ifPresent(nodes::add);
        }
        case OPEN -> block(token).ifPresent(nodes::add);
        default -> next++;
      }
    }
  }

  /** Reads the body of a block that begins or ends a protected area. */
  private List<Node> body(boolean area) {
    boolean outer = inArea;
    inArea = area;
    List<Node> nodes = body();
    inArea = outer;
    return nodes;
  }

  private Optional<Node> block(Token token) {
    next++;
    Optional<Node> node =
        switch (token.keyword()) {
          case "for" -> forBlock(token);
          case "if" -> ifBlock(token);
          case "let" -> letBlock(token);
          case "file" -> fileBlock(token);
          case "protected" -> protectedBlock(token);
          default -> {
            problems.add(
                SyntaxRules.UNSUPPORTED,
                token.start(),
                "[" + token.keyword() + "] is not supported.",
                "Remove the tags [" + token.keyword() + "] and [/" + token.keyword() + "].");
            // The body is checked all the same.
            yield Optional.of(new Syntax.If(token.start(), List.of(), body()));
          }
        };
    next++;
    return node;
  }

  private Optional<Node> output(Token token) {
    HeaderReader reader = reader(token);
    if (reader.acceptWord(Words.SUPER) && reader.atEnd()) {
      return Optional.of(new Syntax.Super(token.start()));
    }
    SourceRange whole = token.content(problems.source());
    int decorated = decorationStart(whole);
    SourceRange value = problems.source().range(whole.start(), decorated).strip();
    if (value.isEmpty()) {
      problems.syntax(token.start(), "This expression is empty.", "");
      return Optional.empty();
    }
    Decoration decoration =
        decorated == whole.end()
            ? NONE
            : new HeaderReader(problems, problems.source().range(decorated, whole.end()))
                .decoration();
    return Optional.of(new Syntax.Output(token.start(), value, decoration));
  }

  /**
   * Returns the offset where {@code before(...)}, {@code separator(...)} or {@code after(...)}
   * start after a call: after a closing parenthesis and white space.
   */
  private int decorationStart(SourceRange span) {
    // The expression's parser reports errors in the expression itself.
    Problems unheard = new Problems(problems.source(), new ArrayList<>());
    HeaderReader reader = new HeaderReader(unheard, span);
    while (!reader.atEnd()) {
      reader.until("(");
      if (reader.atEnd() || reader.parentheses("arguments").isEmpty()) {
        return span.end();
      }
      if (reader.atWord(Words.BEFORE)
          || reader.atWord(Words.SEPARATOR)
          || reader.atWord(Words.AFTER)) {
        return reader.position();
      }
    }
    return span.end();
  }

  private Optional<Node> forBlock(Token token) {
    HeaderReader reader = reader(token);
    Optional<SourceRange> inside = reader.parentheses("a collection");
    Decoration decoration = inside.isEmpty() ? NONE : reader.decoration();
    List<Node> body = body();
    if (inside.isEmpty()) {
      return bodyOnly(token, body);
    }
    HeaderReader items = new HeaderReader(problems, inside.get());
    Optional<Variable> variable = Optional.empty();
    if (declaresVariable(inside.get())) {
      variable = items.variable("|");
      items.accept('|');
    }
    SourceRange collection = items.rest();
    if (collection.isEmpty()) {
      items.unexpected("a collection");
      return bodyOnly(token, body);
    }
    return Optional.of(new Syntax.For(token.start(), variable, collection, decoration, body));
  }

  /** Returns the body of a block whose tag cannot be read, for editors; otherwise nothing. */
  private Optional<Node> bodyOnly(Token token, List<Node> body) {
    return keepsBodies
        ? Optional.of(new Syntax.If(token.start(), List.of(), body))
        : Optional.empty();
  }

  private boolean declaresVariable(SourceRange span) {
    HeaderReader reader = new HeaderReader(problems, span);
    if (reader.name().isEmpty()) {
      return false;
    }
    String text = problems.source().text();
    boolean typed = reader.at(':') && !text.startsWith("::", reader.position());
    if (typed) {
      reader.until("|");
    }
    return reader.at('|');
  }

  private Optional<Node> ifBlock(Token token) {
    Alternatives<Branch> found = alternatives(token, this::branch);
    return Optional.of(new Syntax.If(token.start(), found.parts(), found.otherwise()));
  }

  /**
   * The parts of a block of which one is used.
   *
   * @param otherwise the body after {@code [else]}; empty without one
   */
  private record Alternatives<T>(List<T> parts, List<Node> otherwise) {}

  /** Parses a block with parts like its first one, and {@code [else]} at its end. */
  private <T> Alternatives<T> alternatives(Token first, Function<Token, Optional<T>> part) {
    List<T> parts = new ArrayList<>();
    part.apply(first).ifPresent(parts::add);
    List<Node> otherwise = List.of();
    boolean last = false;
    while (tokens.get(next).kind() == Kind.MIDDLE) {
      Token middle = tokens.get(next++);
      if (last) {
        String end = "[/" + first.keyword() + "]";
        problems.syntax(middle.start(), "Only " + end + " may follow [else].", "");
      }
      if (middle.keyword().equals("else")) {
        last = true;
        otherwise = body();
      } else {
        part.apply(middle).ifPresent(parts::add);
      }
    }
    return new Alternatives<>(List.copyOf(parts), otherwise);
  }

  private Optional<Branch> branch(Token token) {
    HeaderReader reader = reader(token);
    Optional<SourceRange> condition = reader.condition();
    List<Variable> variables = reader.variablesInBraces();
    if (condition.isPresent()) {
      reader.expectEnd("the end of the tag");
    }
    List<Node> body = body();
    return condition.map(span -> new Branch(token.start(), span, variables, body));
  }

  private Optional<Node> letBlock(Token token) {
    Alternatives<Binding> found = alternatives(token, this::binding);
    return Optional.of(new Syntax.Let(token.start(), found.parts(), found.otherwise()));
  }

  private Optional<Binding> binding(Token token) {
    HeaderReader reader = reader(token);
    Optional<Variable> variable = reader.variableWithValue();
    List<Variable> variables = reader.variablesInBraces();
    reader.expectEnd("the end of the tag");
    List<Node> body = body();
    return variable.map(v -> new Binding(token.start(), v, variables, body));
  }

  private Optional<Node> fileBlock(Token token) {
    HeaderReader reader = reader(token);
    Optional<SourceRange> inside = reader.parentheses("the name of the file");
    reader.variablesInBraces();
    reader.skip(')'); // Acceleo reads over what closes nothing.
    reader.expectEnd("the end of the tag");
    List<Node> body = body(false);
    if (inside.isEmpty()) {
      return bodyOnly(token, body);
    }
    HeaderReader arguments = new HeaderReader(problems, inside.get());
    SourceRange name = arguments.until(",");
    Optional<SourceRange> mode =
        arguments.accept(',') ? some(arguments.until(",")) : Optional.empty();
    Optional<SourceRange> charset =
        arguments.accept(',') ? some(arguments.until(",")) : Optional.empty();
    arguments.expectEnd("no more than a name, a mode and a charset");
    if (name.isEmpty()) {
      problems.syntax(token.start(), "The file has no name.", "");
      return bodyOnly(token, body);
    }
    return Optional.of(new Syntax.File(token.start(), name, mode, charset, body));
  }

  private Optional<Node> protectedBlock(Token token) {
    HeaderReader reader = reader(token);
    Optional<SourceRange> id = reader.parentheses("the id of the area");
    Optional<SourceRange> startPrefix = Optional.empty();
    Optional<SourceRange> endPrefix = Optional.empty();
    if (reader.acceptWord(Words.START_TAG_PREFIX)) {
      startPrefix = reader.parentheses("a string");
    }
    if (reader.acceptWord(Words.END_TAG_PREFIX)) {
      endPrefix = reader.parentheses("a string");
    }
    reader.expectEnd("startTagPrefix(), endTagPrefix() or the end of the tag");
    if (inArea) {
      problems.add(
          SyntaxRules.PROTECTED_ID,
          token.start(),
          "This protected area is inside another one.",
          "End the outer area before it, or make the inner one plain text.");
    }
    List<Node> body = body(true);
    if (id.isEmpty()) {
      return bodyOnly(token, body);
    }
    warnOfTextBehindTheId(token, tokens.get(next));
    return Optional.of(new Syntax.Protected(token.start(), id.get(), startPrefix, endPrefix, body));
  }

  /** Warns of text after the id, which is read as a part of the id when the file is read again. */
  private void warnOfTextBehindTheId(Token open, Token close) {
    String area = problems.source().text().substring(open.end(), close.start());
    // Text apart from the id, such as the end of a comment, is known to be no part of it.
    if (area.indexOf('\n') < 0 || TEXT.matcher(area).lookingAt()) {
      problems.warn(
          SyntaxRules.PROTECTED_ID,
          open.start(),
          "The text on the line of the opening tag belongs to the area's id, which an edit changes.",
          "Put the text of the area, and the closing tag, on lines of their own.");
    }
  }

  private static Optional<SourceRange> some(SourceRange span) {
    return span.isEmpty() ? Optional.empty() : Optional.of(span);
  }

  private HeaderReader reader(Token token) {
    return new HeaderReader(problems, token.content(problems.source()));
  }
}
