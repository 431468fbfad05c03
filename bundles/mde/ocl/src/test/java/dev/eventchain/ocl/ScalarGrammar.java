package dev.eventchain.ocl;

import dev.eventchain.ocl.OclGenerator.Options;
import dev.eventchain.ocl.OclGenerator.ValueType;
import dev.eventchain.ocl.OclGenerator.Variable;
import java.util.List;

/** Expressions with a single value. */
final class ScalarGrammar {

  private final OclGenerator generator;

  ScalarGrammar(OclGenerator generator) {
    this.generator = generator;
  }

  void leaves(ValueType type, Options options) {
    switch (type.element()) {
      case "Boolean" ->
          options
              .leaf("literal", "true")
              .leaf("literal", "false")
              .leaf("feature", "self.flag")
              .leaf("feature", "self.maybe");
      case "Integer" -> integers(options);
      case "Real" ->
          options
              .leaf("literal", "0.5")
              .leaf("literal", "0.0")
              .leaf("feature", "self.real")
              .leaf("feature", "self.float")
              .leaf("feature", "self.partial")
              .leaf("feature", "self.exact")
              .leaf("definition of a property", "self.load");
      case "String" ->
          options
              .leaf("literal", "'a'")
              .leaf("literal", "''")
              .leaf("literal", "' 12,x Ab'")
              .leaf("text of *", "(*).toString()")
              .leaf("feature", "self.name");
      case "Colour" -> options.leaf("enumeration", "Colour::RED").leaf("feature", "self.colour");
      default -> options.leaf("self", "self").leaf("feature", "self.next");
    }
  }

  private static void integers(Options options) {
    options
        .leaf("literal", "1")
        .leaf("literal", "0")
        .leaf("literal", "2")
        .leaf("literal", "2147483647")
        .leaf("literal", "(-3)")
        .leaf("feature", "self.whole")
        .leaf("feature", "self.long")
        .leaf("feature", "self.short")
        .leaf("feature", "self.perhaps")
        .leaf("feature", "self.big");
  }

  void nodes(ValueType type, Options options) {
    switch (type.element()) {
      case "Boolean" -> {
        logic(options);
        tests(options);
        unlimited(options);
        quantifiers(options);
      }
      case "Integer" -> {
        arithmetic(type, options);
        counts(options);
      }
      case "Real" -> {
        arithmetic(type, options);
        options.node("oclAsType of an Integer", () -> cast(ValueType.INTEGER, "Real"));
        options.node("toReal", () -> generator.format("%s.toReal()", ValueType.STRING));
        options.node("/", () -> generator.format("(%s / %s)", number(), number()));
      }
      case "String" -> strings(options);
      case "Thing" -> things(options);
      default -> {}
    }
    elements(type, options);
  }

  private void unlimited(Options options) {
    for (String operator : List.of("<", "<=", ">", ">=", "=", "<>")) {
      String before = "(* " + operator + " %s)";
      String behind = "(%s " + operator + " *)";
      options
          .node("* " + operator, () -> generator.format(before, ValueType.INTEGER))
          .node(operator + " *", () -> generator.format(behind, ValueType.INTEGER));
    }
    List<String> types = List.of("Integer", "Real", "UnlimitedNatural", "OclAny");
    for (String name : List.of("oclIsKindOf", "oclIsTypeOf")) {
      options.node(name + " of *", () -> "(*)." + name + "(" + generator.oneOf(types) + ")");
    }
  }

  private String cast(ValueType source, String type) {
    return generator.format("%s.oclAsType(" + type + ")", source);
  }

  private ValueType number() {
    return generator.oneOf(List.of(ValueType.REAL, ValueType.INTEGER));
  }

  private void logic(Options options) {
    for (String operator : List.of("and", "or", "implies", "xor")) {
      options.node(
          operator,
          () -> generator.format("(%s " + operator + " %s)", ValueType.BOOLEAN, ValueType.BOOLEAN));
    }
    options.node("not", () -> generator.format("(not %s)", ValueType.BOOLEAN));
    for (String operator : List.of("<", "<=", ">", ">=")) {
      options
          .node(operator, () -> generator.format("(%s " + operator + " %s)", number(), number()))
          .node(
              operator + " of strings",
              () ->
                  generator.format("(%s " + operator + " %s)", ValueType.STRING, ValueType.STRING));
    }
    for (String operator : List.of("=", "<>")) {
      options.node(operator, () -> equality(operator));
    }
  }

  private String equality(String operator) {
    ValueType left = generator.anyType();
    ValueType right = left.isNumber() ? number() : left;
    return generator.format("(%s " + operator + " %s)", left, right);
  }

  private void tests(Options options) {
    for (String name : List.of("oclIsUndefined", "oclIsInvalid")) {
      options.node(name, () -> generator.format("%s." + name + "()", generator.anyType().single()));
    }
    for (String name : List.of("oclIsKindOf", "oclIsTypeOf")) {
      options
          .node(name, () -> generator.format("%s." + name + "(%s)", ValueType.THING, className()))
          .node(
              name + " of a value",
              () ->
                  generator.format(
                      "%s." + name + "(%s)",
                      generator.oneOf(List.of(ValueType.INTEGER, ValueType.REAL, ValueType.STRING)),
                      generator.oneOf(List.of("Integer", "Real", "String", "OclAny"))));
    }
    for (String name : List.of("matches", "startsWith", "endsWith", "equalsIgnoreCase")) {
      options.node(
          name, () -> generator.format("%s." + name + "(%s)", ValueType.STRING, ValueType.STRING));
    }
    options
        .node(
            "oclIsTypeOf of a literal",
            () ->
                generator.format(
                    "%s.oclIsTypeOf(%s)",
                    generator.oneOf(List.of(ValueType.BOOLEAN, ValueType.COLOUR)),
                    generator.oneOf(List.of("Boolean", "Colour", "Integer"))))
        .node("equality of tuples", this::tuples)
        .node("toBoolean", () -> generator.format("%s.toBoolean()", ValueType.STRING))
        .node(
            "definition with arguments",
            () -> generator.format("%s.sameName(%s)", ValueType.THING, ValueType.THING));
  }

  private String tuples() {
    ValueType type = generator.oneOf(List.of(ValueType.STRING, ValueType.COLOUR, ValueType.THING));
    String format = "Tuple{one : %s = %s, two : Boolean = %s}";
    return generator.format(
        "(" + format + " = " + format + ")",
        type.toString(),
        type,
        ValueType.BOOLEAN,
        type.toString(),
        type,
        ValueType.BOOLEAN);
  }

  private String className() {
    return generator.oneOf(List.of("Thing", "Special", "Rare"));
  }

  private void quantifiers(Options options) {
    for (String name : List.of("forAll", "exists", "one")) {
      options.node(name, () -> generator.loop(name, source(), ValueType.BOOLEAN));
    }
    options.node("isUnique", () -> generator.loop("isUnique", source(), generator.anyType()));
    for (String name : List.of("forAll", "exists")) {
      options.node(name + " of pairs", () -> pairs(name));
    }
    for (String name : List.of("isEmpty", "notEmpty")) {
      options
          .node(name, () -> generator.format("%s->" + name + "()", source()))
          .node(
              name + " of a value",
              () -> generator.format("%s->" + name + "()", generator.oneOf(ValueType.SINGLE)));
    }
    for (String name : List.of("includes", "excludes")) {
      options.node(name, () -> membership(name));
    }
    options
        .node("includes null", () -> generator.format("%s->includes(null)", source()))
        .node("includes a collection", () -> nested("includes"));
    for (String condition : List.of("flag", "name = 'a'", "next <> null", "whole > 1")) {
      options.node(
          "forAll of " + condition,
          () -> generator.format("%s->forAll(" + condition + ")", things()));
    }
    for (String name : List.of("includesAll", "excludesAll")) {
      options.node(name, () -> comparison(name));
    }
  }

  private String membership(String name) {
    ValueType source = source();
    return generator.format("%s->" + name + "(%s)", source, source.single());
  }

  /** Returns a predicate on a sequence of collections. */
  private String nested(String name) {
    ValueType source = source();
    return generator.format("Sequence{%s, %s}->" + name + "(%s)", source, source, source);
  }

  private ValueType things() {
    return ValueType.THING.of(generator.oneOf(ValueType.KINDS));
  }

  private String comparison(String name) {
    ValueType source = source();
    ValueType other = source.of(generator.oneOf(ValueType.KINDS));
    return generator.format("%s->" + name + "(%s)", source, other);
  }

  private String pairs(String name) {
    ValueType source = source();
    String from = generator.expression(source);
    Variable first = new Variable(generator.newName(), source.single());
    Variable second = new Variable(generator.newName(), source.single());
    String body =
        generator.within(
            first, () -> generator.within(second, () -> generator.expression(ValueType.BOOLEAN)));
    return from + "->" + name + "(" + first.name() + ", " + second.name() + " | " + body + ")";
  }

  /** Returns any type of collection. */
  private ValueType source() {
    return generator.oneOf(ValueType.SINGLE).of(generator.oneOf(ValueType.KINDS));
  }

  private ValueType ordered(ValueType element) {
    return element.of(generator.oneOf(List.of("Sequence", "OrderedSet")));
  }

  private void arithmetic(ValueType type, Options options) {
    for (String operator : List.of("+", "-", "*")) {
      options.node(operator, () -> generator.format("(%s " + operator + " %s)", type, type));
    }
    options
        .node("minus", () -> generator.format("(-%s)", type))
        .node("abs", () -> generator.format("%s.abs()", type))
        .node("max", () -> generator.format("%s.max(%s)", type, type))
        .node("min", () -> generator.format("%s.min(%s)", type, type));
    for (String name : List.of("sum", "max", "min")) {
      options.node(name + " of a collection", () -> aggregate(name, type));
    }
    options.node("iterate", () -> iterate(type));
  }

  private String aggregate(String name, ValueType type) {
    ValueType source = type.of(generator.oneOf(ValueType.KINDS));
    if (source.isUnordered() && name.equals("sum") && type.equals(ValueType.REAL)) {
      generator.orderMatters();
    }
    return generator.format("%s->" + name + "()", source);
  }

  private String iterate(ValueType type) {
    ValueType source = source();
    if (source.isUnordered()) {
      generator.orderMatters();
    }
    String from = generator.expression(source);
    String start = generator.expression(type);
    Variable element = new Variable(generator.newName(), source.single());
    Variable result = new Variable(generator.newName(), type);
    String body =
        generator.within(element, () -> generator.within(result, () -> generator.expression(type)));
    return String.format(
        "%s->iterate(%s : %s; %s : %s = %s | %s)",
        from, element.name(), element.type(), result.name(), type, start, body);
  }

  private void counts(Options options) {
    options
        .node("div", () -> generator.format("%s.div(%s)", ValueType.INTEGER, ValueType.INTEGER))
        .node("mod", () -> generator.format("%s.mod(%s)", ValueType.INTEGER, ValueType.INTEGER))
        .node("floor", () -> generator.format("%s.floor()", number()))
        .node("round", () -> generator.format("%s.round()", number()))
        .node("count of null", () -> generator.format("%s->count(null)", source()))
        .node("position of a collection", () -> nested("indexOf"))
        .node(
            "size of a value",
            () -> generator.format("%s->size()", generator.oneOf(ValueType.SINGLE)))
        .node("size", () -> generator.format("%s->size()", source()))
        .node("size of a string", () -> generator.format("%s.size()", ValueType.STRING))
        .node("toInteger", () -> generator.format("%s.toInteger()", ValueType.STRING))
        .node(
            "indexOf", () -> generator.format("%s.indexOf(%s)", ValueType.STRING, ValueType.STRING))
        .node(
            "lastIndexOf",
            () -> generator.format("%s.lastIndexOf(%s)", ValueType.STRING, ValueType.STRING))
        .node("selectByKind", () -> selected("selectByKind"))
        .node("selectByType", () -> selected("selectByType"))
        .node("count", () -> membership("count"))
        .node(
            "recursion", () -> generator.format("%s.depth(%s)", ValueType.THING, ValueType.INTEGER))
        .node("mutual recursion", () -> generator.format("%s.even()", ValueType.THING))
        .node(
            "tuple",
            () ->
                generator.format(
                    "Tuple{first : Integer = %s, second : String = %s}.first",
                    ValueType.INTEGER, ValueType.STRING))
        .node("indexOf in a collection", () -> position(ValueType.SINGLE));
  }

  private String selected(String name) {
    ValueType source = ValueType.THING.of(generator.oneOf(ValueType.KINDS));
    return generator.format("%s->" + name + "(%s)->size()", source, className());
  }

  private String position(List<ValueType> types) {
    ValueType source = ordered(generator.oneOf(types));
    return generator.format("%s->indexOf(%s)", source, source.single());
  }

  private void strings(Options options) {
    options
        .node("concat", () -> generator.format("%s.concat(%s)", ValueType.STRING, ValueType.STRING))
        .node(
            "+ of strings", () -> generator.format("(%s + %s)", ValueType.STRING, ValueType.STRING))
        .node(
            "substring",
            () ->
                generator.format(
                    "%s.substring(%s, %s)", ValueType.STRING, ValueType.INTEGER, ValueType.INTEGER))
        .node(
            "at of a string",
            () -> generator.format("%s.at(%s)", ValueType.STRING, ValueType.INTEGER))
        .node(
            "toString",
            () -> {
              ValueType type = generator.anyType().single();
              return generator.format("%s.toString()", type);
            });
    options.node("eClass", () -> generator.format("%s.eClass().name", ValueType.THING));
    for (String name : List.of("toUpperCase", "toLowerCase", "toUpper", "toLower", "trim")) {
      options.node(name, () -> generator.format("%s." + name + "()", ValueType.STRING));
    }
    for (String name : List.of("replaceAll", "replaceFirst", "substituteAll", "substituteFirst")) {
      options.node(
          name,
          () ->
              generator.format(
                  "%s." + name + "(%s, %s)", ValueType.STRING, ValueType.STRING, ValueType.STRING));
    }
  }

  private void things(Options options) {
    options
        .node("navigation", () -> generator.format("%s.next", ValueType.THING))
        .node(
            "oclAsType",
            () ->
                generator.format("%s.oclAsType(%s).oclAsType(Thing)", ValueType.THING, className()))
        .node(
            "metamodel operation",
            () -> generator.format("%s.eContainer().oclAsType(Thing)", ValueType.THING));
  }

  private void elements(ValueType type, Options options) {
    if (!type.equals(ValueType.THING)) {
      options
          .node("oclAsType of a value", () -> cast(type, type.element()))
          .node("oclAsType of anything", () -> cast(type, "OclAny).oclAsType(" + type.element()));
    }
    options
        .node("first", () -> generator.format("%s->first()", ordered(type)))
        .node("last", () -> generator.format("%s->last()", ordered(type)))
        .node("at", () -> generator.format("%s->at(%s)", ordered(type), ValueType.INTEGER))
        .node(
            "any",
            () ->
                generator.loop(
                    "any", type.of(generator.oneOf(ValueType.KINDS)), ValueType.BOOLEAN));
  }
}
