package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.text.Lexer;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The proposals outside the expressions of a rule document. */
final class RuleProposals {

  private record Template(String label, String text, boolean snippet) {}

  private static final List<Template> CLAUSES =
      List.of(
          new Template("context", "context ${1:Class}\n  inv ${2:Name}:\n    $0", true),
          new Template("inv", "inv ${1:Name}:\n    $0", true),
          new Template("def", "def: ${1:name} : ${2:Type} =\n    $0", true),
          new Template("static", "static def: ${1:name}() : ${2:Type} =\n    $0", true),
          new Template("package", "package ${1:name}\n\n$0\n\nendpackage", true),
          new Template("endpackage", "endpackage", false),
          new Template("import", "import '$1'", true),
          new Template("body", "body: $0", true),
          new Template("derive", "derive: $0", true),
          new Template("init", "init: $0", true),
          new Template("pre", "pre ${1:Name}: $0", true),
          new Template("post", "post ${1:Name}: $0", true));

  private static final List<Template> ANNOTATIONS =
      List.of(
          new Template("severity", "severity ${1|warning,error,info|}", true),
          new Template("message", "message ${1:text with {expressions\\}}", true),
          new Template("hint", "hint ${1:text}", true));

  private final RuleText text;
  private final ExpressionLanguage language;
  private final int offset;

  RuleProposals(RuleText text, ExpressionLanguage language, int offset) {
    this.text = text;
    this.language = language;
    this.offset = offset;
  }

  /** Returns the proposals in a comment, which has annotations only; empty outside comments. */
  static Optional<List<Completion>> inComment(RuleText text, int offset) {
    String all = text.source().text();
    int line = text.lines().offset(new TextPosition(text.lines().position(offset).line(), 0));
    for (int i = line; i < offset; ) {
      int end = Lexer.end(all, i, all.length());
      if (all.startsWith("--", i) && offset >= i + 2 && offset <= end) {
        int start = startOfWord(all, offset);
        boolean annotation = start > 0 && all.charAt(start - 1) == '@';
        return Optional.of(annotation ? proposals(ANNOTATIONS, text, start, offset) : List.of());
      }
      i = end;
    }
    return Optional.empty();
  }

  private static int startOfWord(String all, int offset) {
    int start = offset;
    while (start > 0 && Character.isJavaIdentifierPart(all.charAt(start - 1))) {
      start--;
    }
    return start;
  }

  private static List<Completion> proposals(
      List<Template> templates, RuleText text, int start, int offset) {
    String all = text.source().text();
    int end = offset;
    while (end < all.length() && Character.isJavaIdentifierPart(all.charAt(end))) {
      end++;
    }
    TextRange replaced = text.lines().range(start, end);
    List<Completion> found = new ArrayList<>();
    for (Template each : templates) {
      found.add(
          new Completion(
              each.label(), ElementKind.KEYWORD, "", "", each.text(), each.snippet(), replaced));
    }
    return found;
  }

  /** Returns whether the name of a context is expected. */
  boolean namesClass() {
    Tokens tokens = new Tokens(before().text());
    int last = tokens.size() - 1;
    while (last > 1 && tokens.is(last, "::")) {
      last -= 2;
    }
    return last >= 0 && tokens.is(last, "context") && (last == 0 || !tokens.is(last - 1, "."));
  }

  /** Returns whether only white space is before the word on its line. */
  boolean startsLine() {
    String all = text.source().text();
    int line = text.lines().position(offset).line();
    int start = text.lines().offset(new TextPosition(line, 0));
    return all.substring(start, startOfWord(all, offset)).isBlank();
  }

  /** Returns the beginnings of clauses. */
  List<Completion> clauses() {
    return proposals(CLAUSES, text, startOfWord(text.source().text(), offset), offset);
  }

  /** Returns the text from the start of the clause, or the last one, to the word. */
  private SourceRange before() {
    int start = startOfWord(text.source().text(), offset);
    int section = text.sectionAt(start - 1);
    int from = section < 0 ? 0 : text.sections().get(section).start();
    return text.source().range(Math.min(from, start), start);
  }

  List<Completion> all() {
    SourceRange before = before();
    Tokens tokens = new Tokens(before.text());
    String last = tokens.size() == 0 ? "" : tokens.text(tokens.size() - 1);
    boolean type =
        last.equals("context")
            || last.equals("::")
            || (last.equals(":") && tokens.size() > 1 && !tokens.is(tokens.size() - 2, "def"));
    if (type) {
      SourceRange range = text.source().range(before.start(), offset);
      return language.assistant().types(range, offset, text.lines());
    }
    boolean name = last.equals("inv") || last.equals(":") || last.equals("import");
    return name ? List.of() : clauses();
  }
}
