package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.compile.LinkedModules;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.ocl.Scope;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A template or a query of a file, which is compiled when something in it is asked for. */
final class TemplateUnit {

  private final LinkedModules linked;
  private final TagBlock block;
  private final Syntax.Template template;
  private final Syntax.Query query;
  private final int number;
  private volatile Compiled compiled;

  private TemplateUnit(
      LinkedModules linked,
      TagBlock block,
      Syntax.Template template,
      Syntax.Query query,
      int number) {
    this.linked = linked;
    this.block = block;
    this.template = template;
    this.query = query;
    this.number = number;
  }

  /** Returns the templates and queries of a text, in its order. */
  static List<TemplateUnit> of(TemplateText text, LinkedModules linked) {
    List<TemplateUnit> units = new ArrayList<>();
    for (TagBlock block : text.blocks()) {
      List<Syntax.Template> templates = text.module().templates();
      for (int i = 0; i < templates.size(); i++) {
        if (isIn(templates.get(i).name(), block)) {
          units.add(new TemplateUnit(linked, block, templates.get(i), null, i));
        }
      }
      List<Syntax.Query> queries = text.module().queries();
      for (int i = 0; i < queries.size(); i++) {
        if (isIn(queries.get(i).name(), block)) {
          units.add(new TemplateUnit(linked, block, null, queries.get(i), i));
        }
      }
    }
    return units;
  }

  private static boolean isIn(Syntax.Name name, TagBlock block) {
    return block.open().start() <= name.start() && name.start() < block.open().end();
  }

  TagBlock block() {
    return block;
  }

  boolean isTemplate() {
    return template != null;
  }

  int number() {
    return number;
  }

  Syntax.Name name() {
    return isTemplate() ? template.name() : query.name();
  }

  List<Syntax.Variable> parameters() {
    return isTemplate() ? template.parameters() : query.parameters();
  }

  List<Syntax.Name> overrides() {
    return isTemplate() ? template.overrides() : List.of();
  }

  /** Returns the type of a query's result; empty for a template. */
  Optional<SourceRange> resultType() {
    return isTemplate() ? Optional.empty() : Optional.of(query.type());
  }

  /** Returns a query's value; empty for a template. */
  Optional<SourceRange> value() {
    return isTemplate() ? Optional.empty() : Optional.of(query.value());
  }

  /** Returns what it declares; empty if its head has an error. */
  Optional<? extends Callable> callable() {
    return isTemplate() ? linked.template(number) : linked.query(number);
  }

  /** Returns what the compiler found in it. */
  Compiled compiled() {
    Compiled known = compiled;
    if (known == null) {
      known = new Compiled(linked.language());
      if (isTemplate()) {
        linked.compile(template, number, known);
      } else {
        linked.compile(query, number, known);
      }
      compiled = known;
    }
    return known;
  }

  /** Returns the scope of the innermost body around an offset. */
  Scope scopeAt(int offset) {
    Scope scope = compiled().scopeAfter(name().start(), linked.language().root());
    List<TagBlock> inner = block.children();
    boolean deeper = true;
    while (deeper) {
      Optional<TagBlock> around = inner.stream().filter(each -> each.isAround(offset)).findFirst();
      deeper = around.isPresent();
      if (deeper) {
        scope = inside(around.get(), offset, scope);
        inner = around.get().children();
      }
    }
    return scope;
  }

  private Scope inside(TagBlock around, int offset, Scope outer) {
    int start = around.start();
    boolean otherwise = false;
    for (var middle : around.middles()) {
      if (middle.end() <= offset) {
        start = middle.start();
        otherwise = middle.keyword().equals("else");
      }
    }
    return otherwise ? outer : compiled().scopeAfter(start, outer);
  }

  /** Returns {@code name(parameter : Type) : Type}, as written. */
  String signature() {
    List<String> parameters =
        parameters().stream()
            .map(
                each ->
                    each.name().text()
                        + each.type().map(type -> " : " + type.text().strip()).orElse(""))
            .toList();
    String result = resultType().map(type -> " : " + type.text().strip()).orElse("");
    return name().text() + "(" + String.join(", ", parameters) + ")" + result;
  }
}
