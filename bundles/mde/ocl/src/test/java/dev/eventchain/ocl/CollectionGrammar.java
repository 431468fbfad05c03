package dev.eventchain.ocl;

import dev.eventchain.ocl.OclGenerator.Options;
import dev.eventchain.ocl.OclGenerator.ValueType;
import java.util.List;

/** Expressions whose value is a collection. */
final class CollectionGrammar {

  private final OclGenerator generator;

  CollectionGrammar(OclGenerator generator) {
    this.generator = generator;
  }

  void leaves(ValueType type, Options options) {
    options.leaf("literal of constants", type.kind() + "{" + constants(type.element()) + "}");
    switch (type.toString()) {
      case "Sequence(Integer)" ->
          options.leaf("feature of many", "self.numbers").leaf("range", "Sequence{1..4}");
      case "Set(Integer)" -> options.leaf("range", "Set{3..6}");
      case "Bag(Integer)" -> options.leaf("range", "Bag{1..3, 2}");
      case "Bag(String)" -> options.leaf("feature of many", "self.words");
      case "OrderedSet(String)" -> options.leaf("feature of many", "self.titles");
      case "Set(Real)" -> options.leaf("feature of many", "self.marks");
      case "OrderedSet(Thing)" ->
          options.leaf("feature of many", "self.parts").leaf("feature of many", "self.admirers");
      case "Set(Thing)" ->
          options
              .leaf("feature of many", "self.friends")
              .leaf("allInstances", "Thing.allInstances()");
      case "Set(Colour)" -> options.leaf("allInstances of values", "Colour.allInstances()");
      default -> {}
    }
    options.leaf("empty literal", "(let e : " + type + " = " + type.kind() + "{} in e)");
  }

  private static String constants(String type) {
    return switch (type) {
      case "Boolean" -> "true, false";
      case "Integer" -> "2, 1, 2";
      case "Real" -> "0.5, 2.0, -1.5";
      case "String" -> "'b', 'a', 'b'";
      case "Colour" -> "Colour::GREEN";
      default -> "self";
    };
  }

  void nodes(ValueType type, Options options) {
    options
        .node(
            "literal of a collection",
            () -> generator.format(type.kind() + "{%s, %s}", type.single(), type.single()))
        .node("select", () -> generator.loop("select", type, ValueType.BOOLEAN))
        .node("reject", () -> generator.loop("reject", type, ValueType.BOOLEAN))
        .node("including", () -> changed(type, "including"))
        .node("excluding", () -> changed(type, "excluding"))
        .node("conversion", () -> conversion(type))
        .node(
            "literal with null",
            () -> generator.format(type.kind() + "{%s, null, %s}", type.single(), type.single()))
        .node("excluding null", () -> typed(type, generator.format("%s->excluding(null)", type)))
        .node("flatten", () -> flatten(type));
    if (type.isUnordered()) {
      unordered(type, options);
    } else {
      ordered(type, options);
    }
    if (type.element().equals("Thing")) {
      things(type, options);
    } else if (type.toString().equals("Sequence(String)")) {
      options
          .node("characters", () -> generator.format("%s.characters()", ValueType.STRING))
          .node("tokenize", () -> generator.format("%s.tokenize()", ValueType.STRING))
          .node(
              "tokenize with delimiters",
              () -> generator.format("%s.tokenize(%s)", ValueType.STRING, ValueType.STRING));
    }
  }

  /** Returns a changed collection; Eclipse OCL types a changed ordered set as a set. */
  private String changed(ValueType type, String name) {
    return typed(type, generator.format("%s->" + name + "(%s)", type, type.single()));
  }

  private static String typed(ValueType type, String changed) {
    return type.kind().equals("OrderedSet") ? changed + "->asOrderedSet()" : changed;
  }

  private void unordered(ValueType type, Options options) {
    options
        .node("union", () -> generator.format("%s->union(%s)", type, type))
        .node("intersection", () -> generator.format("%s->intersection(%s)", type, type));
    if (type.kind().equals("Set")) {
      options
          .node("- of sets", () -> generator.format("(%s - %s)", type, type))
          .node(
              "symmetricDifference",
              () -> generator.format("%s->symmetricDifference(%s)", type, type))
          .node("oclAsSet", () -> generator.format("%s.oclAsSet()", type.single()));
    } else {
      collect(type, List.of("Set", "Bag"), options);
    }
    if (type.toString().equals("Bag(Integer)")) {
      options.node("product", () -> product(type));
    }
  }

  private String product(ValueType type) {
    generator.orderMatters();
    String name = generator.newName();
    return generator.format(
        "%s->product(%s)->collect(" + name + " | " + name + ".first)", type, type);
  }

  private void ordered(ValueType type, Options options) {
    boolean distinct = type.isDistinct();
    String part = distinct ? "subOrderedSet" : "subSequence";
    options
        .node("append", () -> generator.format("%s->append(%s)", type, type.single()))
        .node("prepend", () -> generator.format("%s->prepend(%s)", type, type.single()))
        .node(
            "insertAt",
            () -> generator.format("%s->insertAt(%s, %s)", type, ValueType.INTEGER, type.single()))
        .node(
            part,
            () ->
                generator.format(
                    "%s->" + part + "(%s, %s)", type, ValueType.INTEGER, ValueType.INTEGER));
    if (distinct) {
      options.node("sortedBy", () -> sortedBy(type, List.of("OrderedSet", "Set")));
    } else {
      options
          .node("sortedBy", () -> sortedBy(type, List.of("Sequence", "Bag")))
          .node("union", () -> generator.format("%s->union(%s)", type, type));
      collect(type, List.of("Sequence", "OrderedSet"), options);
    }
    if (type.toString().equals("Sequence(Integer)")) {
      options.node(
          "range of values",
          () ->
              generator.format("Sequence{%s..(%s).min(9)}", ValueType.INTEGER, ValueType.INTEGER));
    }
  }

  private String sortedBy(ValueType type, List<String> kinds) {
    ValueType key = generator.oneOf(List.of(ValueType.INTEGER, ValueType.STRING, ValueType.REAL));
    return generator.loop("sortedBy", type.of(generator.oneOf(kinds)), key);
  }

  private void collect(ValueType type, List<String> kinds, Options options) {
    options
        .node("collect", () -> generator.loop("collect", source(kinds), type.single()))
        .node(
            "collect of collections",
            () -> {
              ValueType body = type.of(generator.oneOf(ValueType.KINDS));
              if (body.isUnordered()) {
                generator.orderMatters();
              }
              return generator.loop("collect", source(kinds), body);
            })
        .node("collectNested", () -> generator.loop("collectNested", source(kinds), type.single()));
    implicitCollect(type, kinds, options);
  }

  /** Adds navigation from many elements, an implicit {@code collect}. */
  private void implicitCollect(ValueType type, List<String> kinds, Options options) {
    List<String> features =
        switch (type.element()) {
          case "Boolean" -> List.of("flag", "maybe");
          case "Integer" -> List.of("whole", "perhaps", "numbers");
          case "Real" -> List.of("real", "partial");
          case "String" -> List.of("name");
          case "Colour" -> List.of("colour");
          default -> List.of("next", "parts", "owner");
        };
    for (String feature : features) {
      options.node(
          "feature of each: " + feature,
          () -> generator.format("%s." + feature, ValueType.THING.of(generator.oneOf(kinds))));
    }
  }

  private ValueType source(List<String> kinds) {
    return generator.oneOf(ValueType.SINGLE).of(generator.oneOf(kinds));
  }

  private String conversion(ValueType type) {
    ValueType source = type.of(generator.oneOf(ValueType.KINDS));
    if (source.isUnordered() && !type.isUnordered()) {
      generator.orderMatters();
    }
    return generator.format("%s->as" + type.kind() + "()", source);
  }

  /** Flattens a collection, as deep as its first element is nested. */
  private String flatten(ValueType type) {
    if (!type.kind().equals("Sequence")) {
      generator.orderMatters();
    }
    if (type.kind().equals("OrderedSet")) {
      return generator.format("OrderedSet{%s}->flatten()->asOrderedSet()", type);
    }
    return generator.format(type.kind() + "{%s, %s}->flatten()", type, type);
  }

  private void things(ValueType type, Options options) {
    for (String condition : List.of("flag", "name = 'a'", "next <> null", "whole > 1")) {
      options.node(
          "select of " + condition, () -> generator.format("%s->select(" + condition + ")", type));
    }
    if (type.kind().equals("Set")) {
      options.node("closure", () -> closure(type));
    } else if (type.kind().equals("Sequence")) {
      options.node(
          "metamodel operation of many",
          () ->
              generator.format(
                  "%s.eContents()->asSequence()->collect(oclAsType(Thing))", ValueType.THING));
    }
  }

  private String closure(ValueType type) {
    ValueType source = type.of(generator.oneOf(List.of("OrderedSet", "Set")));
    ValueType body = generator.oneOf(List.of(ValueType.THING, source));
    return generator.loop("closure", source, body);
  }
}
