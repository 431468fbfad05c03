package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.TextRange;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.syntax.Token;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.metamodel.PackageIndex;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EPackage;

/** The proposals at a place of a template file, apart from its expressions. */
final class TemplateProposals {

  /**
   * A tag.
   *
   * @param head what is in the first tag
   * @param rest what follows it
   * @param inside true if it stands in templates
   */
  private record Snippet(String label, String head, String rest, boolean inside) {}

  private static final List<Snippet> BLOCKS =
      List.of(
          new Snippet("for", "for (${1:each} | ${2:values})]", "\n$0\n[/for]", true),
          new Snippet("if", "if (${1:condition})]", "\n$0\n[/if]", true),
          new Snippet("elseif", "elseif (${1:condition})]", "", true),
          new Snippet("else", "else]", "", true),
          new Snippet("let", "let ${1:name} : ${2:Type} = ${3:value}]", "\n$0\n[/let]", true),
          new Snippet("elselet", "elselet ${1:name} : ${2:Type} = ${3:value}]", "", true),
          new Snippet("file", "file (${1:name}, false, 'UTF-8')]", "\n$0\n[/file]", true),
          new Snippet("protected", "protected (${1:id})]", "\n$0\n[/protected]", true),
          new Snippet("comment", "comment ${1:text} /]", "", true),
          new Snippet("super", "super/]", "", true),
          new Snippet("module", "module ${1:name}('${2:namespace}')]", "\n$0", false),
          new Snippet("import", "import ${1:module}/]", "", false),
          new Snippet(
              "template",
              "template public ${1:name}(${2:element} : ${3:Type})]",
              "\n$0\n[/template]",
              false),
          new Snippet(
              "query",
              "query public ${1:name}(${2:element} : ${3:Type}) : ${4:Type} = ${5:value} /]",
              "",
              false),
          new Snippet("comment", "comment ${1:text} /]", "", false));

  private final TemplateText text;
  private final ExpressionLanguage language;
  private final TemplateLanguageService service;
  private final int offset;
  private final String all;
  private final int start;
  private final TextRange replaced;
  private final Token tag;

  TemplateProposals(
      TemplateText text, ExpressionLanguage language, TemplateLanguageService service, int offset) {
    this.text = text;
    this.language = language;
    this.service = service;
    this.offset = offset;
    this.all = text.written().text();
    int from = offset;
    while (from > 0 && Character.isJavaIdentifierPart(all.charAt(from - 1))) {
      from--;
    }
    int end = offset;
    while (end < all.length() && Character.isJavaIdentifierPart(all.charAt(end))) {
      end++;
    }
    this.start = from;
    this.replaced = text.lines().range(from, end);
    this.tag = text.tagAt(offset);
  }

  /** Returns whether no expression can stand here. */
  boolean isAlone() {
    return tag != null && (isClosing() || tag.kind() == Token.Kind.COMMENT);
  }

  private boolean isClosing() {
    return start > 1 && all.startsWith("[/", start - 2);
  }

  /** Returns the tags that can begin here, the block to close, or an annotation. */
  List<Completion> before() {
    if (tag == null) {
      return List.of();
    } else if (tag.kind() == Token.Kind.COMMENT) {
      boolean annotation = start > 0 && all.charAt(start - 1) == '@';
      return annotation ? List.of(word("main", ElementKind.ANNOTATION)) : List.of();
    } else if (isClosing()) {
      return closing();
    } else if (all.charAt(start - 1) == '[') {
      return blocks();
    }
    return List.of();
  }

  private List<Completion> blocks() {
    boolean inside = !around(text.blocks(), start).isEmpty();
    boolean bracketed = all.startsWith("]", text.lines().offset(replaced.end()));
    List<Completion> found = new ArrayList<>();
    for (Snippet each : BLOCKS) {
      if (each.inside() == inside) {
        String head = each.head();
        // An editor may have written the bracket already.
        String inserted = bracketed ? head.substring(0, head.length() - 1) : head + each.rest();
        found.add(
            new Completion(each.label(), ElementKind.SNIPPET, "", "", inserted, true, replaced));
      }
    }
    return found;
  }

  /** Returns the blocks that are open here, the innermost first. */
  private List<Completion> closing() {
    List<Completion> found = new ArrayList<>();
    boolean bracketed = all.startsWith("]", text.lines().offset(replaced.end()));
    for (String keyword : around(text.blocks(), start)) {
      found.add(
          0,
          new Completion(
              keyword,
              ElementKind.KEYWORD,
              "",
              "",
              keyword + (bracketed ? "" : "]"),
              false,
              replaced));
    }
    return found;
  }

  private static List<String> around(List<TagBlock> blocks, int offset) {
    for (TagBlock each : blocks) {
      if (each.isAround(offset)) {
        List<String> found = new ArrayList<>(List.of(each.open().keyword()));
        found.addAll(around(each.children(), offset));
        return found;
      }
    }
    return List.of();
  }

  /** Returns the proposals in the heads of modules, templates and queries. */
  List<Completion> outside() {
    if (tag == null || tag.kind() == Token.Kind.COMMENT || tag.kind() == Token.Kind.CLOSE) {
      return List.of();
    }
    String before = all.substring(tag.start(), start).stripTrailing();
    return switch (text.wordOf(tag)) {
      case "module" -> moduleHead(before);
      case "import" -> modules();
      case "template", "query" -> head(before);
      default -> List.of();
    };
  }

  private List<Completion> moduleHead(String before) {
    List<Completion> found = new ArrayList<>();
    if (before.endsWith("'") || before.lastIndexOf('\'') > before.lastIndexOf(')')) {
      int quote = all.lastIndexOf('\'', offset - 1);
      TextRange uri = text.lines().range(quote + 1, offset);
      for (EPackage each : language.packages().all()) {
        if (each.getNsURI() != null) {
          String name = PackageIndex.qualifiedName(each);
          found.add(
              new Completion(
                  each.getNsURI(), ElementKind.PACKAGE, name, "", each.getNsURI(), false, uri));
        }
      }
    } else if (before.endsWith("extends") || before.endsWith(",")) {
      found.addAll(modules());
    } else if (before.endsWith(")")) {
      found.add(word("extends", ElementKind.KEYWORD));
    }
    return found;
  }

  private List<Completion> modules() {
    List<Completion> found = new ArrayList<>();
    for (Path file : service.files()) {
      if (!file.equals(text.file())) {
        service
            .text(file)
            .map(each -> each.module().name())
            .filter(name -> !name.isEmpty())
            .ifPresent(name -> found.add(module(name, file)));
      }
    }
    return found;
  }

  private Completion module(String name, Path file) {
    return new Completion(
        name, ElementKind.MODULE, file.getFileName().toString(), "", name, false, replaced);
  }

  private List<Completion> head(String before) {
    if (before.endsWith(":") || (before.endsWith("(") && before.contains(":"))) {
      SourceRange range = text.written().range(tag.start() + 1, offset);
      return language.assistant().types(range, offset, text.lines());
    }
    List<Completion> found = new ArrayList<>();
    if (before.equals("[template") || before.equals("[query")) {
      for (String each : List.of("public", "protected", "private")) {
        found.add(word(each, ElementKind.KEYWORD));
      }
    } else if (before.endsWith(")") && before.startsWith("[template")) {
      found.add(word("overrides", ElementKind.KEYWORD));
      found.add(word("post", ElementKind.KEYWORD));
    }
    return found;
  }

  private Completion word(String word, ElementKind kind) {
    return new Completion(word, kind, "", "", word, false, replaced);
  }
}
