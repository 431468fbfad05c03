package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceRange;
import java.util.List;
import java.util.Optional;

/**
 * The syntax tree of a template file. Immutable; white space is settled; expressions are still the
 * places where they stand. Offsets are those of the file.
 */
final class Syntax {
  private Syntax() {}

  /** A file. */
  record Module(
      String name,
      int start,
      List<SourceRange> metamodels,
      List<Name> extended,
      List<Name> imports,
      List<Template> templates,
      List<Query> queries) {}

  /** A name and where it stands. */
  record Name(String text, int start) {}

  /** Who may call a template or query. */
  enum Visibility {
    PUBLIC,
    PROTECTED,
    PRIVATE
  }

  /** {@code name : type}, or {@code name : type = value}; the type may be left to the value. */
  record Variable(Name name, Optional<SourceRange> type, Optional<SourceRange> value) {}

  /** {@code [template ...]...[/template]}. */
  record Template(
      Name name,
      Visibility visibility,
      List<Variable> parameters,
      List<Name> overrides,
      Optional<SourceRange> guard,
      Optional<SourceRange> post,
      List<Variable> variables,
      boolean main,
      List<Node> body) {}

  /** {@code [query ... : type = value /]}. */
  record Query(
      Name name,
      Visibility visibility,
      List<Variable> parameters,
      SourceRange type,
      SourceRange value) {}

  /** What a template's body is made of. */
  sealed interface Node {
    /** Where the node's tag starts. */
    int start();
  }

  /** Text that is output as it stands. */
  record Text(int start, String text) implements Node {}

  /** {@code [value/]}. */
  record Output(int start, SourceRange value, Decoration decoration) implements Node {}

  /** {@code [super/]}. */
  record Super(int start) implements Node {}

  /** What goes around and between the parts of a repeated output. */
  record Decoration(
      Optional<SourceRange> before,
      Optional<SourceRange> separator,
      Optional<SourceRange> after,
      Optional<SourceRange> guard,
      List<Variable> variables) {}

  /** {@code [for (variable | items) ...]}; without a variable, self and i are all there is. */
  record For(
      int start,
      Optional<Variable> variable,
      SourceRange items,
      Decoration decoration,
      List<Node> body)
      implements Node {}

  /** {@code [if] [elseif] [else]}. */
  record If(int start, List<Branch> branches, List<Node> otherwise) implements Node {}

  /** A condition, what it guards, and where its tag starts. */
  record Branch(int start, SourceRange condition, List<Variable> variables, List<Node> body) {}

  /** {@code [let] [elselet] [else]}. */
  record Let(int start, List<Binding> bindings, List<Node> otherwise) implements Node {}

  /** A variable that its type must suit, the body that sees it, and where its tag starts. */
  record Binding(int start, Variable variable, List<Variable> variables, List<Node> body) {}

  /** {@code [file (name, mode, charset)]}. */
  record File(
      int start,
      SourceRange name,
      Optional<SourceRange> mode,
      Optional<SourceRange> charset,
      List<Node> body)
      implements Node {}

  /** {@code [protected (id) startTagPrefix(...) endTagPrefix(...)]}. */
  record Protected(
      int start,
      SourceRange id,
      Optional<SourceRange> startPrefix,
      Optional<SourceRange> endPrefix,
      List<Node> body)
      implements Node {}
}
