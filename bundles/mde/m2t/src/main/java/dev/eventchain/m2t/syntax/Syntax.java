package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceRange;
import java.util.List;
import java.util.Optional;

/**
 * Syntax tree of a template file. Immutable; white space is normalised; expressions are unparsed
 * source ranges. Offsets are those of the file.
 */
public final class Syntax {
  private Syntax() {}

  /** A template file. */
  public record Module(
      String name,
      int start,
      List<SourceRange> metamodels,
      List<Name> extended,
      List<Name> imports,
      List<Template> templates,
      List<Query> queries) {}

  /** A name and its offset. */
  public record Name(String text, int start) {}

  /** Visibility of a template or query. */
  public enum Visibility {
    PUBLIC,
    PROTECTED,
    PRIVATE
  }

  /**
   * {@code name : type}, or {@code name : type = value}; the type may be inferred from the value.
   */
  public record Variable(Name name, Optional<SourceRange> type, Optional<SourceRange> value) {}

  /** {@code [template ...]...[/template]}. */
  public record Template(
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
  public record Query(
      Name name,
      Visibility visibility,
      List<Variable> parameters,
      SourceRange type,
      SourceRange value) {}

  /** A node of a template's body. */
  public sealed interface Node {
    /** Returns the offset of the node's tag. */
    int start();
  }

  /** Literal text. */
  public record Text(int start, String text) implements Node {}

  /** {@code [value/]}. */
  public record Output(int start, SourceRange value, Decoration decoration) implements Node {}

  /** {@code [super/]}. */
  public record Super(int start) implements Node {}

  /** Text around and between the items of a repeated output. */
  public record Decoration(
      Optional<SourceRange> before,
      Optional<SourceRange> separator,
      Optional<SourceRange> after,
      Optional<SourceRange> guard,
      List<Variable> variables) {}

  /** {@code [for (variable | items) ...]}; without a variable, only self and i are defined. */
  public record For(
      int start,
      Optional<Variable> variable,
      SourceRange items,
      Decoration decoration,
      List<Node> body)
      implements Node {}

  /** {@code [if] [elseif] [else]}. */
  public record If(int start, List<Branch> branches, List<Node> otherwise) implements Node {}

  /** A condition, its body, and the offset of its tag. */
  public record Branch(
      int start, SourceRange condition, List<Variable> variables, List<Node> body) {}

  /** {@code [let] [elselet] [else]}. */
  public record Let(int start, List<Binding> bindings, List<Node> otherwise) implements Node {}

  /** A variable whose type must accept the value, its body, and the offset of its tag. */
  public record Binding(int start, Variable variable, List<Variable> variables, List<Node> body) {}

  /** {@code [file (name, mode, charset)]}. */
  public record File(
      int start,
      SourceRange name,
      Optional<SourceRange> mode,
      Optional<SourceRange> charset,
      List<Node> body)
      implements Node {}

  /** {@code [protected (id) startTagPrefix(...) endTagPrefix(...)]}. */
  public record Protected(
      int start,
      SourceRange id,
      Optional<SourceRange> startPrefix,
      Optional<SourceRange> endPrefix,
      List<Node> body)
      implements Node {}
}
