package dev.eventchain.constraints.document;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Splits a Complete OCL document into clauses that are parsed separately, so that an error in one
 * does not hide those in others.
 */
public final class RuleDocument {

  /** A qualified name and its location. */
  public record Path(List<String> names, SourceLocation location) {
    @Override
    public String toString() {
      return String.join("::", names);
    }
  }

  /**
   * An invariant or a definition.
   *
   * @param definition true for a definition
   * @param packagePath the package clause around it; {@code null} if there is none
   * @param context the name of its class
   * @param alias another name of {@code self}; empty if there is none
   * @param name its name; empty if it has none
   * @param location the place of its keyword
   * @param text its expression; the whole clause for a definition
   * @param message the expression for its message; {@code null} if there is none
   * @param comments the text with the comments above it; for the first clause, above the context
   * @param contextComment the text that ends with the comment above its context
   */
  public record Clause(
      boolean definition,
      Path packagePath,
      Path context,
      String alias,
      String name,
      SourceLocation location,
      SourceRange text,
      SourceRange message,
      List<SourceRange> comments,
      SourceRange contextComment) {

    /** Returns the text that ends with the comment right above it. */
    public SourceRange ownComment() {
      return comments.get(comments.size() - 1);
    }
  }

  /** Keywords of bodies, and of conditions about running programs. */
  private static final Set<String> CONDITIONS = Set.of("pre", "post", "body", "init", "derive");

  private static final Set<String> COMPUTING = Set.of("body", "derive");

  private static final Set<String> AFTER_CONTEXT =
      Set.of("inv", "def", "static", "pre", "post", "body", "init", "derive");

  private final SourceText source;
  private final Tokens tokens;
  private final List<Diagnostic> problems;
  private final List<DocumentImports.Import> imports = new ArrayList<>();
  private final List<Clause> clauses = new ArrayList<>();
  private final List<MemberContext> members = new ArrayList<>();
  private int unchecked;
  private MemberContext member;
  private String alias = "";
  private Path packagePath;
  private Path context;
  private SourceRange contextComments;
  private boolean contextIsNew;
  private boolean contextFailed;
  private int at;

  private RuleDocument(SourceText source, List<Diagnostic> problems) {
    this.source = source;
    this.tokens = new Tokens(source.text());
    this.problems = problems;
  }

  /** Reads a document; clauses other than invariants and definitions are reported as problems. */
  public static RuleDocument read(SourceText source, List<Diagnostic> problems) {
    RuleDocument document = new RuleDocument(source, problems);
    int comment = document.tokens.unclosedComment();
    if (comment >= 0) {
      problems.add(
          Diagnostic.of(ExpressionRules.SYNTAX, "This comment has no end.", source.at(comment))
              .withHint("Close it with */; everything after it counts as comment."));
    }
    while (document.at < document.tokens.size()) {
      document.readNext();
    }
    return document;
  }

  public List<DocumentImports.Import> imports() {
    return imports;
  }

  public List<Clause> clauses() {
    return clauses;
  }

  /** Returns the operations and features that the document computes. */
  public List<MemberContext> members() {
    return members;
  }

  /** Returns the number of runtime conditions: {@code pre}, {@code post}, {@code init}. */
  public int unchecked() {
    return unchecked;
  }

  public boolean isEmpty() {
    return clauses.isEmpty() && members.isEmpty() && unchecked == 0;
  }

  private void readNext() {
    String token = tokens.text(at);
    switch (token) {
      case "import", "include", "library" -> readImport();
      case "package" -> {
        at++;
        packagePath = readPath();
        setContext(null, false);
      }
      case "endpackage" -> {
        at++;
        packagePath = null;
        setContext(null, false);
      }
      case "context" -> readContext();
      case "inv" -> readInvariant();
      case "static", "def" -> readDefinition();
      default -> {
        if (CONDITIONS.contains(token)) {
          readCondition(token);
        } else {
          error(at, "'context', 'inv' or 'def' is expected here, not '" + token + "'.");
          skipToClause(at + 1);
        }
      }
    }
  }

  private void readCondition(String keyword) {
    int start = at;
    at += tokens.isName(at + 1) ? 2 : 1;
    if (!tokens.is(at, ":")) {
      error(at - 1, "':' is expected after '" + tokens.text(at - 1) + "'.");
      skipToClause(at);
      return;
    }
    int expression = tokens.end(at);
    skipToClause(at + 1);
    if (member != null && COMPUTING.contains(keyword)) {
      members.add(member.with(source.range(expression, endOfClause(expression))));
    } else if (member != null) {
      unchecked++;
    } else if (!contextFailed) {
      unsupported(start, "'" + keyword + "' needs the context of an operation or a feature.");
    }
  }

  private void readImport() {
    int start = at++;
    if (at + 1 < tokens.size() && tokens.text(at + 1).equals(":")) {
      at += 2; // import name : 'uri'
    }
    if (at < tokens.size() && tokens.isString(at)) {
      String literal = tokens.text(at);
      imports.add(
          new DocumentImports.Import(literal.substring(1, literal.length() - 1), location(at)));
      at++;
    } else if (at < tokens.size() && tokens.isName(at)) {
      Path path = readPath();
      imports.add(new DocumentImports.Import(path.toString(), path.location()));
    } else {
      error(start, "'" + tokens.text(start) + "' needs a URI, a file or the name of a metamodel.");
    }
  }

  private void readContext() {
    int start = at++;
    Path path = readPath();
    setContext(path, path == null);
    contextComments = before(start);
    contextIsNew = true;
    if (path == null) {
      skipToClause(start + 1);
    } else if (tokens.is(at, ":") && path.names().size() == 1) {
      readNamedContext(path);
    } else if (path.names().size() > 1 && (tokens.is(at, ":") || tokens.is(at, "("))) {
      readMember(path);
    } else if (tokens.is(at, "(")) {
      unsupported(at, "The class of this operation is missing.");
      setContext(null, true);
      skipToClause(at);
    } else if (at >= tokens.size() || !AFTER_CONTEXT.contains(tokens.text(at))) {
      error(at - 1, "'inv' or 'def' is expected after the context.");
      skipToClause(at);
    }
  }

  /** Reads {@code context b : Book}. */
  private void readNamedContext(Path variable) {
    at++;
    SourceRange comments = contextComments;
    Path path = readPath();
    setContext(path, path == null);
    contextComments = comments;
    contextIsNew = true;
    alias = variable.names().get(0);
    skipToClause(at);
  }

  /** Reads {@code Book::lend(to : MemberContext) : Boolean} or {@code Book::title : String}. */
  private void readMember(Path path) {
    List<String> parameters = tokens.is(at, "(") ? new ArrayList<>() : null;
    int depth = 0;
    do {
      depth += tokens.is(at, "(") ? 1 : tokens.is(at, ")") ? -1 : 0;
      if (depth == 1 && tokens.isName(at) && tokens.is(at + 1, ":")) {
        parameters.add(tokens.text(at));
      }
      at++;
    } while (depth > 0 && at < tokens.size());
    skipToClause(at);
    int last = path.names().size() - 1;
    Path owner = new Path(path.names().subList(0, last), path.location());
    setContext(null, true);
    member = new MemberContext(packagePath, owner, path.names().get(last), parameters, null);
  }

  private void setContext(Path path, boolean failed) {
    context = path;
    member = null;
    alias = "";
    contextFailed = failed;
    contextIsNew = false;
  }

  private Path readPath() {
    if (at >= tokens.size() || !tokens.isName(at)) {
      error(at - 1, "A name is expected after '" + tokens.text(at - 1) + "'.");
      return null;
    }
    SourceLocation location = location(at);
    List<String> names = new ArrayList<>();
    names.add(name());
    while (at + 1 < tokens.size() && tokens.is(at, "::") && tokens.isName(at + 1)) {
      at++;
      names.add(name());
    }
    return new Path(List.copyOf(names), location);
  }

  /** Reads a name, which may be quoted: {@code _'in'}. */
  private String name() {
    String name = tokens.text(at++);
    if (name.equals("_") && tokens.touches(at - 1) && tokens.isString(at)) {
      String quoted = tokens.text(at++);
      return quoted.substring(1, quoted.length() - 1);
    }
    return name;
  }

  private void readInvariant() {
    int keyword = at++;
    String name = "";
    if (at < tokens.size() && tokens.isName(at)) {
      name = tokens.text(at++);
    }
    SourceRange message = readMessage();
    if (at >= tokens.size() || !tokens.is(at, ":")) {
      error(at - 1, "':' is expected after '" + tokens.text(at - 1) + "'.");
      skipToClause(at);
      return;
    }
    int start = tokens.end(at++);
    skipToClause(at);
    add(false, name, keyword, start, message);
  }

  /** Reads {@code (expression)} after an invariant's name; null if there is none. */
  private SourceRange readMessage() {
    if (!tokens.is(at, "(")) {
      return null;
    }
    int open = at;
    int close = tokens.closing(open);
    if (close == tokens.size()) {
      return null;
    }
    at = close + 1;
    return source.range(tokens.end(open), tokens.start(close));
  }

  private void readDefinition() {
    int keyword = at;
    skipToClause(at + (tokens.is(at, "static") ? 2 : 1));
    add(true, "", keyword, tokens.start(keyword), null);
  }

  private void add(boolean definition, String name, int keyword, int start, SourceRange message) {
    if (context != null) {
      List<SourceRange> comments = new ArrayList<>();
      if (contextIsNew) {
        comments.add(contextComments);
      }
      comments.add(before(keyword));
      SourceRange text = source.range(start, endOfClause(start));
      clauses.add(
          new Clause(
              definition,
              packagePath,
              context,
              alias,
              name,
              location(keyword),
              text,
              message,
              comments,
              contextComments));
    } else if (!contextFailed) {
      error(keyword, "'context' and the name of a class are missing before this.");
    }
    contextIsNew = false;
  }

  /** Returns the text between a token and the one before it. */
  private SourceRange before(int token) {
    return source.range(tokens.endBefore(token), tokens.start(token));
  }

  /** Returns the end of the last token before the next clause. */
  private int endOfClause(int start) {
    return Math.max(start, tokens.endBefore(at));
  }

  private void skipToClause(int from) {
    at = from;
    while (at < tokens.size() && !ClauseStarts.at(tokens, at)) {
      at++;
    }
  }

  private SourceLocation location(int token) {
    return source.at(tokens.start(Math.min(token, tokens.size() - 1)));
  }

  private void error(int token, String message) {
    problems.add(Diagnostic.of(ExpressionRules.SYNTAX, message, location(token)));
  }

  private void unsupported(int token, String message) {
    problems.add(
        Diagnostic.of(ConstraintRules.UNSUPPORTED, message, location(token))
            .withHint("Write 'context Class inv Name: ...' with 'self', or a 'def:'."));
  }
}
