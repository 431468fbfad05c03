package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.syntax.Syntax.Name;
import dev.eventchain.m2t.syntax.Syntax.Query;
import dev.eventchain.m2t.syntax.Syntax.Template;
import dev.eventchain.m2t.syntax.Syntax.Variable;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Parser of a file: its declarations, and its templates by {@link BlockParser}. */
final class ModuleParser {
  private static final String HEADER_HINT =
      "A file starts with [module name('namespace of the metamodel')].";

  private static final List<String> TOP_LEVEL = List.of("module", "import", "query", "comment");

  private final Problems problems;
  private final List<Token> tokens;
  private final BlockParser blocks;
  private final List<SourceRange> metamodels = new ArrayList<>();
  private final List<Name> extended = new ArrayList<>();
  private final List<Name> imports = new ArrayList<>();
  private final List<Template> templates = new ArrayList<>();
  private final List<Query> queries = new ArrayList<>();
  private Optional<Name> module = Optional.empty();
  private boolean mainComment;

  private ModuleParser(Problems problems, List<Token> tokens, boolean halfTyped) {
    this.problems = problems;
    this.tokens = tokens;
    List<Syntax.Text> texts =
        halfTyped
            ? tokens.stream().map(each -> new Syntax.Text(each.start(), "")).toList()
            : WhiteSpace.normalise(problems.source().text(), tokens);
    this.blocks = new BlockParser(problems, tokens, texts, halfTyped);
  }

  /** Returns the tree of a file, without invalid parts. */
  static Syntax.Module parse(Problems problems) {
    warnOfMixedLineEnds(problems);
    int nul = problems.source().text().indexOf('\0');
    if (nul >= 0) {
      problems.syntax(
          nul, "The file contains a NUL character, which text never does.", "Remove it.");
    }
    List<Token> tokens = Blocks.balanced(TemplateLexer.tokens(problems), problems);
    return new ModuleParser(problems, tokens, false).module();
  }

  /**
   * As {@link #parse}, with the bodies of blocks whose tags cannot be read; without texts and
   * findings.
   */
  static Syntax.Module understand(SourceText source) {
    Problems lost = Problems.ignored(source);
    List<Token> tokens = Blocks.balanced(TemplateLexer.tokens(lost), lost);
    return new ModuleParser(lost, tokens, true).module();
  }

  private static void warnOfMixedLineEnds(Problems problems) {
    String text = problems.source().text();
    int crlf = text.indexOf("\r\n");
    if (crlf < 0) {
      return;
    }
    for (int i = text.indexOf('\n'); i >= 0; i = text.indexOf('\n', i + 1)) {
      if (i == 0 || text.charAt(i - 1) != '\r') {
        problems.add(
            SyntaxRules.LINE_ENDS,
            i,
            "The file mixes line endings (CRLF and LF), and so will its output.",
            "Convert the file to one kind of line ending.");
        return;
      }
    }
  }

  private Syntax.Module module() {
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      switch (token.kind()) {
        case DECLARATION -> declaration(token);
        case COMMENT -> mainComment |= isMain(token);
        case OPEN -> i = template(i);
        case EXPRESSION -> strayExpression(token);
        default -> {}
      }
    }
    if (module.isEmpty()) {
      problems.syntax(0, "The module header is missing.", HEADER_HINT);
    }
    return new Syntax.Module(
        module.map(Name::text).orElse(""),
        module.map(Name::start).orElse(0),
        List.copyOf(metamodels),
        List.copyOf(extended),
        List.copyOf(imports),
        List.copyOf(templates),
        List.copyOf(queries));
  }

  /** Reports an expression between templates, where only text is allowed, as a remark. */
  private void strayExpression(Token token) {
    String word = reader(token).name().map(Name::text).orElse("");
    String meant = NearestName.question(word, TOP_LEVEL);
    problems.syntax(
        token.start(),
        "This tag is outside any template.",
        meant.isEmpty() ? "Put it between [template ...] and [/template]." : meant);
  }

  private void declaration(Token token) {
    HeaderReader reader = reader(token);
    switch (token.keyword()) {
      case "module" -> header(token, reader);
      case "import" -> {
        Optional<Name> name = reader.qualifiedName();
        name.ifPresentOrElse(imports::add, () -> reader.unexpected("the name of a module"));
        reader.expectEnd("the end of the tag");
      }
      default -> query(reader);
    }
    mainComment = false;
  }

  private void header(Token token, HeaderReader reader) {
    if (module.isPresent()) {
      problems.syntax(token.start(), "A file has only one module header.", "");
      return;
    }
    module = reader.qualifiedName();
    if (module.isEmpty()) {
      reader.unexpected("the name of the module");
      module = Optional.of(new Name("", token.start()));
      return;
    }
    Optional<SourceRange> inside = reader.parentheses("the namespaces of the metamodels");
    inside.ifPresent(span -> list(span).forEach(metamodels::add));
    if (reader.acceptWord(Words.EXTENDS)) {
      do {
        Optional<Name> name = reader.qualifiedName();
        name.ifPresentOrElse(extended::add, () -> reader.unexpected("the name of a module"));
      } while (reader.accept(','));
    }
    reader.expectEnd("'extends' or the end of the tag");
  }

  private List<SourceRange> list(SourceRange span) {
    HeaderReader reader = new HeaderReader(problems, span);
    List<SourceRange> items = new ArrayList<>();
    do {
      SourceRange item = reader.until(",");
      if (!item.isEmpty()) {
        items.add(item);
      }
    } while (reader.accept(','));
    return items;
  }

  private void query(HeaderReader reader) {
    Visibility visibility = visibility(reader);
    Optional<Name> name = reader.name();
    if (name.isEmpty()) {
      reader.unexpected("the name of the query");
      return;
    }
    List<Variable> parameters = reader.parameters();
    if (!reader.accept(':')) {
      reader.unexpected("':' and the type of the result");
      return;
    }
    SourceRange type = reader.until("=");
    if (!reader.accept('=')) {
      reader.unexpected("'=' and the result");
      return;
    }
    queries.add(new Query(name.get(), visibility, parameters, type, reader.rest()));
  }

  /** Reads a template and returns the index of its closing tag. */
  private int template(int open) {
    Token token = tokens.get(open);
    int close = blocks.closing(open);
    if (!token.keyword().equals("template")) {
      problems.add(
          SyntaxRules.UNSUPPORTED,
          token.start(),
          "[" + token.keyword() + "] is not supported.",
          "Write a template instead.");
      return close;
    }
    boolean mainBefore = mainComment;
    mainComment = false;
    boolean main = mainBefore;
    for (int i = open + 1; i < close; i++) {
      main |= tokens.get(i).kind() == Kind.COMMENT && isMain(tokens.get(i));
    }
    header(reader(token), main, blocks.templateBody(open));
    return close;
  }

  private void header(HeaderReader reader, boolean main, List<Syntax.Node> body) {
    Visibility visibility = visibility(reader);
    Optional<Name> name = reader.name();
    if (name.isEmpty()) {
      reader.unexpected("the name of the template");
      return;
    }
    List<Variable> parameters = reader.parameters();
    List<Name> overrides = new ArrayList<>();
    if (reader.acceptWord(Words.OVERRIDES)) {
      do {
        reader
            .name()
            .ifPresentOrElse(overrides::add, () -> reader.unexpected("the name of a template"));
      } while (reader.accept(','));
    }
    Optional<SourceRange> guard =
        reader.accept('?') ? reader.parentheses("a condition") : Optional.empty();
    Optional<SourceRange> post =
        reader.acceptWord(Words.POST) ? reader.parentheses("an operation") : Optional.empty();
    List<Variable> variables = reader.variablesInBraces();
    reader.expectEnd(
        "the end of the tag after 'overrides', '? (guard)', 'post (...)' and '{...}', in this order");
    templates.add(
        new Template(
            name.get(), visibility, parameters, overrides, guard, post, variables, main, body));
  }

  private Visibility visibility(HeaderReader reader) {
    for (Visibility visibility : Visibility.values()) {
      if (reader.acceptWord(Words.of(visibility))) {
        return visibility;
      }
    }
    return Visibility.PUBLIC;
  }

  private boolean isMain(Token comment) {
    String content = comment.content(problems.source()).text();
    int at = content.indexOf("@main");
    int end = at + "@main".length();
    return at >= 0
        && (end == content.length() || !Character.isJavaIdentifierPart(content.charAt(end)));
  }

  private HeaderReader reader(Token token) {
    return new HeaderReader(problems, token.content(problems.source()));
  }
}
