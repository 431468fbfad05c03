package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.syntax.Token;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The outline and the folding of a template file, and what is said about its declarations. */
final class TemplateOutline {

  /** Greatest length of what an outline shows of a tag. */
  private static final int SHORT = 60;

  private TemplateOutline() {}

  /** Returns the modules that a text extends and imports. */
  static List<Syntax.Name> modules(TemplateText text) {
    return Stream.concat(text.module().extended().stream(), text.module().imports().stream())
        .toList();
  }

  /** Returns the module, its templates with their blocks, and its queries. */
  static List<Symbol> symbols(TemplateText text, List<TemplateUnit> units) {
    List<Symbol> symbols = new ArrayList<>();
    for (TagBlock block : text.blocks()) {
      Optional<TemplateUnit> unit = units.stream().filter(u -> u.block().equals(block)).findFirst();
      if (unit.isPresent()) {
        Symbol head = symbol(text, unit.get());
        symbols.add(
            new Symbol(
                head.name(),
                head.detail(),
                head.kind(),
                head.range(),
                head.nameRange(),
                blocks(text, block.children())));
      } else if (block.open().keyword().equals("module") && !text.module().name().isEmpty()) {
        int start = text.module().start();
        TextRange name = text.lines().range(start, start + text.module().name().length());
        TextRange range = text.lines().range(block.start(), block.end());
        symbols.add(
            new Symbol(text.module().name(), "", ElementKind.MODULE, range, name, List.of()));
      }
    }
    return List.copyOf(symbols);
  }

  private static List<Symbol> blocks(TemplateText text, List<TagBlock> blocks) {
    List<Symbol> symbols = new ArrayList<>();
    for (TagBlock each : blocks) {
      Token open = each.open();
      SourceRange word = text.wordIn(open);
      String content = text.source().range(open.contentStart(), open.contentEnd()).text();
      String line = content.strip().replaceAll("\\s+", " ");
      symbols.add(
          new Symbol(
              open.keyword(),
              line.length() > SHORT ? line.substring(0, SHORT) + "..." : line,
              ElementKind.BLOCK,
              text.lines().range(each.start(), each.end()),
              text.lines().range(word.start(), word.end()),
              blocks(text, each.children())));
    }
    return List.copyOf(symbols);
  }

  private static Symbol symbol(TemplateText text, TemplateUnit unit) {
    int start = unit.name().start();
    String name = unit.name().text();
    return new Symbol(
        name,
        unit.signature().substring(name.length()),
        unit.isTemplate() ? ElementKind.TEMPLATE : ElementKind.QUERY,
        text.lines().range(unit.block().start(), unit.block().end()),
        text.lines().range(start, start + name.length()),
        List.of());
  }

  /** Returns a template or query as a caller or as what is called. */
  static Call.Item item(TemplateText text, TemplateUnit unit) {
    Symbol symbol = symbol(text, unit);
    return new Call.Item(
        symbol.name(),
        symbol.detail(),
        symbol.kind(),
        new FileRange(text.file(), symbol.range()),
        symbol.nameRange());
  }

  /** Returns the head of a template or query, with the value of a short query. */
  static String headOf(TemplateUnit unit) {
    String kind = unit.isTemplate() ? "template " : "query ";
    String value = unit.value().map(SourceRange::text).orElse("").strip();
    boolean shown = !value.isEmpty() && value.length() <= SHORT && value.indexOf('\n') < 0;
    return kind + unit.signature() + (shown ? " = " + value : "");
  }

  /** Returns the comment right before a template or query; empty if there is none. */
  static String documentation(TemplateText text, TemplateUnit unit) {
    Token before = null;
    for (Token token : text.tokens()) {
      if (token.start() >= unit.block().start()) {
        break;
      }
      boolean blank =
          token.kind() == Token.Kind.TEXT
              && text.source().range(token.start(), token.end()).text().isBlank();
      before = token.kind() == Token.Kind.COMMENT ? token : blank ? before : null;
    }
    if (before == null) {
      return "";
    }
    String comment = text.source().range(before.contentStart(), before.contentEnd()).text().strip();
    return comment.startsWith("@main") ? "" : comment.replaceAll("(?m)^[ \\t]*\\*[ \\t]?", "");
  }

  static List<Folding> foldings(TemplateText text) {
    List<Folding> found = new ArrayList<>();
    addBlocks(text, text.blocks(), found);
    for (Token token : text.tokens()) {
      if (token.kind() == Token.Kind.COMMENT) {
        add(text.lines(), token.start(), token.end(), Folding.Kind.COMMENT, found);
      }
    }
    List<TagBlock> imports =
        text.blocks().stream().filter(each -> each.open().keyword().equals("import")).toList();
    if (imports.size() > 1) {
      int end = imports.get(imports.size() - 1).end();
      add(text.lines(), imports.get(0).start(), end, Folding.Kind.IMPORTS, found);
    }
    found.sort(Comparator.comparingInt(Folding::firstLine).thenComparing(Folding::lastLine));
    return found;
  }

  private static void addBlocks(TemplateText text, List<TagBlock> blocks, List<Folding> into) {
    for (TagBlock each : blocks) {
      // The line with the last tag stays visible, as it tells what ends.
      boolean closed =
          each.close().end() > each.close().start() && !each.close().equals(each.open());
      int last = text.lines().position(each.close().start()).line() - (closed ? 1 : 0);
      int first = text.lines().position(each.start()).line();
      if (last > first) {
        into.add(new Folding(first, last, Folding.Kind.BLOCK));
      }
      addBlocks(text, each.children(), into);
    }
  }

  private static void add(
      TextLines lines, int start, int end, Folding.Kind kind, List<Folding> into) {
    int first = lines.position(start).line();
    int last = lines.position(end).line();
    if (last > first) {
      into.add(new Folding(first, last, kind));
    }
  }
}
