package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import dev.eventchain.ocl.assist.ExpressionTokens;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.text.Lexer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;

/** The outline, the folding and the colours of a rule document, which need no metamodel. */
final class RuleOutline {

  private static final Set<String> IMPORTS = Set.of("import", "include", "library");

  private RuleOutline() {}

  /** Returns packages, in them contexts, and in these their clauses. */
  static List<Symbol> symbols(RuleText text) {
    List<Symbol> top = new ArrayList<>();
    for (int i = 0; i < text.sections().size(); ) {
      i = addAt(text, i, top);
    }
    return List.copyOf(top);
  }

  /** Adds the symbol of a section with those in it, and returns the index after them. */
  private static int addAt(RuleText text, int index, List<Symbol> into) {
    Section section = text.sections().get(index);
    if (IMPORTS.contains(section.keyword()) || section.keyword().equals("endpackage")) {
      return index + 1;
    }
    List<Symbol> children = new ArrayList<>();
    int last = lastOf(text, index);
    for (int i = index + 1; i <= last; ) {
      i = addAt(text, i, children);
    }
    Symbol alone = symbol(text, section);
    int end = text.sections().get(last).end();
    into.add(
        new Symbol(
            alone.name(),
            alone.detail(),
            alone.kind(),
            text.lines().range(section.start(), end),
            alone.nameRange(),
            List.copyOf(children)));
    return last + 1;
  }

  /** Returns the index of the last section inside another one. */
  static int lastOf(RuleText text, int index) {
    int level = level(text.sections().get(index));
    int last = index;
    while (last + 1 < text.sections().size() && level(text.sections().get(last + 1)) > level) {
      last++;
    }
    return last;
  }

  private static int level(Section section) {
    return switch (section.keyword()) {
      case "import", "include", "library", "package", "endpackage" -> 0;
      case "context" -> 1;
      default -> 2;
    };
  }

  /** Returns the symbol of one section. */
  static Symbol symbol(RuleText text, Section section) {
    boolean definition = section.keyword().equals("def");
    String signature =
        definition
            ? DefinitionText.of(text.source().range(section.start(), section.end())).signature()
            : section.keyword();
    boolean named = !section.name().isEmpty();
    return new Symbol(
        named ? section.name() : section.keyword(),
        definition && named ? signature.substring(section.name().length()).strip() : signature,
        RuleAnalysis.kindOf(section),
        text.lines().range(section.start(), section.end()),
        text.lines().range(section.nameStart(), section.nameEnd()),
        List.of());
  }

  static List<Folding> foldings(RuleText text) {
    List<Folding> found = new ArrayList<>();
    TextLines lines = text.lines();
    int imports = 0;
    for (int i = 0; i < text.sections().size(); i++) {
      Section section = text.sections().get(i);
      if (IMPORTS.contains(section.keyword())) {
        imports = i + 1;
      } else {
        int end = text.sections().get(lastOf(text, i)).end();
        add(lines, section.start(), end, Folding.Kind.BLOCK, found);
      }
    }
    if (imports > 1) {
      int start = text.sections().get(0).start();
      add(lines, start, text.sections().get(imports - 1).end(), Folding.Kind.IMPORTS, found);
    }
    addComments(text, found);
    found.sort(Comparator.comparingInt(Folding::firstLine).thenComparing(Folding::lastLine));
    return found;
  }

  /** Adds comments over several lines, and lines of comments in a row. */
  private static void addComments(RuleText text, List<Folding> into) {
    String all = text.source().text();
    int start = -1;
    int end = 0;
    for (int i = 0; i < all.length(); ) {
      int next = Lexer.end(all, i, all.length());
      boolean comment = all.startsWith("--", i) || all.startsWith("/*", i);
      if (comment) {
        start = start < 0 ? i : start;
        end = next;
      } else if (!Character.isWhitespace(all.charAt(i)) || isBlankLine(all, i, next)) {
        if (start >= 0) {
          add(text.lines(), start, end, Folding.Kind.COMMENT, into);
        }
        start = -1;
      }
      i = next;
    }
    if (start >= 0) {
      add(text.lines(), start, end, Folding.Kind.COMMENT, into);
    }
  }

  private static boolean isBlankLine(String text, int start, int end) {
    return text.substring(start, end).lines().count() > 2;
  }

  private static void add(
      TextLines lines, int start, int end, Folding.Kind kind, List<Folding> into) {
    int first = lines.position(start).line();
    int last = lines.position(end).line();
    if (last > first) {
      into.add(new Folding(first, last, kind));
    }
  }

  static List<SemanticToken> tokens(RuleText text, PackageIndex packages) {
    ExpressionTokens tokens = new ExpressionTokens(text.lines(), packages, Set.of());
    int from = 0;
    for (Section section : text.sections()) {
      boolean rule = level(section) == 2 && !section.name().isEmpty();
      if (rule) {
        tokens.addAll(text.source().range(from, section.nameStart()));
        int end = section.nameStart() + section.name().length();
        tokens.add(
            text.source().text(), section.nameStart(), end, SemanticToken.Kind.FUNCTION, true);
        from = end;
      }
    }
    SourceRange rest = text.source().range(from, text.source().text().length());
    tokens.addAll(rest);
    return List.copyOf(tokens.found());
  }
}
