package dev.eventchain.ocl;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;

/**
 * Generates well-typed expressions about a Thing from a list of choices. Smaller and fewer choices
 * give simpler expressions, so that failures shrink to readable ones.
 */
final class OclGenerator {

  /** A type; {@code kind} is empty for a single value. */
  record ValueType(String kind, String element) {
    static final ValueType BOOLEAN = new ValueType("", "Boolean");
    static final ValueType INTEGER = new ValueType("", "Integer");
    static final ValueType REAL = new ValueType("", "Real");
    static final ValueType STRING = new ValueType("", "String");
    static final ValueType COLOUR = new ValueType("", "Colour");
    static final ValueType THING = new ValueType("", "Thing");
    static final List<ValueType> SINGLE = List.of(BOOLEAN, INTEGER, REAL, STRING, COLOUR, THING);
    static final List<String> KINDS = List.of("Sequence", "OrderedSet", "Set", "Bag");

    ValueType of(String newKind) {
      return new ValueType(newKind, element);
    }

    ValueType single() {
      return of("");
    }

    boolean isCollection() {
      return !kind.isEmpty();
    }

    /** Returns whether its elements have no order in OCL. */
    boolean isUnordered() {
      return kind.equals("Set") || kind.equals("Bag");
    }

    boolean isDistinct() {
      return kind.endsWith("Set");
    }

    boolean isNumber() {
      return equals(INTEGER) || equals(REAL);
    }

    @Override
    public String toString() {
      return isCollection() ? kind + "(" + element + ")" : element;
    }
  }

  record Variable(String name, ValueType type) {}

  /** Alternatives for an expression of some type. */
  final class Options {
    private final List<String> names = new ArrayList<>();
    private final List<Supplier<String>> makers = new ArrayList<>();
    private int leaves;

    /** Adds an alternative without sub-expressions. Leaves come first, the simplest first. */
    Options leaf(String name, String text) {
      leaves++;
      return node(name, () -> text);
    }

    Options node(String name, Supplier<String> maker) {
      names.add(name);
      makers.add(maker);
      return this;
    }

    private String choose() {
      int choice = pick(depth > 0 ? names.size() : leaves);
      used.merge(names.get(choice), 1, Integer::sum);
      depth--;
      try {
        return makers.get(choice).get();
      } finally {
        depth++;
      }
    }
  }

  private static final int DEPTH = 4;

  /** Loops whose value depends on the order of their source, whatever the body. */
  private static final Set<String> ORDERED_LOOPS = Set.of("any", "sortedBy");

  private final List<Integer> choices;
  private final Map<String, Integer> used = new TreeMap<>();
  private final List<Variable> scope = new ArrayList<>();
  private final ScalarGrammar scalars = new ScalarGrammar(this);
  private final CollectionGrammar collections = new CollectionGrammar(this);
  private int depth = DEPTH;
  private int at;
  private int names;
  private boolean orderMatters;

  OclGenerator(List<Integer> choices) {
    this.choices = choices;
  }

  /** Returns an expression of any type. */
  String expression() {
    ValueType single = oneOf(ValueType.SINGLE);
    int kind = pick(ValueType.KINDS.size() * 2);
    return expression(
        kind < ValueType.KINDS.size() ? single : single.of(ValueType.KINDS.get(kind - 4)));
  }

  String expression(ValueType type) {
    Options options = new Options();
    if (type.isCollection()) {
      collections.leaves(type, options);
    } else {
      scalars.leaves(type, options);
    }
    for (Variable variable : scope) {
      if (variable.type().equals(type)) {
        options.leaf("variable", variable.name());
      }
    }
    if (type.isCollection()) {
      collections.nodes(type, options);
    } else {
      scalars.nodes(type, options);
    }
    shared(type, options);
    return options.choose();
  }

  private void shared(ValueType type, Options options) {
    options
        .node("part of a tuple", () -> tuple(type))
        .node("if", () -> format("(if %s then %s else %s endif)", ValueType.BOOLEAN, type, type))
        .node("let", () -> let(anyType(), type))
        .node("null or invalid", () -> undefined(type, oneOf(List.of("null", "invalid"))));
  }

  private String undefined(ValueType type, String value) {
    String name = newName();
    return "(let " + name + " : " + type + " = " + value + " in " + name + ")";
  }

  private String tuple(ValueType type) {
    ValueType other = anyType();
    return format(
        "Tuple{one : %s = %s, two : %s = %s}.two", other.toString(), other, type.toString(), type);
  }

  private String let(ValueType variableType, ValueType type) {
    String value = expression(variableType);
    Variable variable = new Variable(newName(), variableType);
    return "(let "
        + variable.name()
        + " : "
        + variableType
        + " = "
        + value
        + " in "
        + within(variable, () -> expression(type))
        + ")";
  }

  /** Returns a text in which expressions of these types replace each {@code %s}. */
  String format(String format, Object... types) {
    Object[] texts = new Object[types.length];
    for (int i = 0; i < types.length; i++) {
      texts[i] = types[i] instanceof ValueType type ? expression(type) : types[i];
    }
    return String.format(format, texts);
  }

  /** Returns a loop over a source, with a variable for its elements. */
  String loop(String name, ValueType source, ValueType body) {
    String from = expression(source);
    Variable variable = new Variable(newName(), source.single());
    if (source.isUnordered() && ORDERED_LOOPS.contains(name)) {
      orderMatters();
    }
    String inner = within(variable, () -> expression(body));
    return from + "->" + name + "(" + variable.name() + " | " + inner + ")";
  }

  String within(Variable variable, Supplier<String> inner) {
    scope.add(variable);
    try {
      return inner.get();
    } finally {
      scope.remove(scope.size() - 1);
    }
  }

  ValueType anyType() {
    ValueType single = oneOf(ValueType.SINGLE);
    return pick(3) == 2 ? single.of(oneOf(ValueType.KINDS)) : single;
  }

  String newName() {
    names++;
    return "v" + names;
  }

  <T> T oneOf(List<T> values) {
    return values.get(pick(values.size()));
  }

  private int pick(int bound) {
    return at < choices.size() ? choices.get(at++) % bound : 0;
  }

  /** Records that the value depends on the order of a set or a bag. */
  void orderMatters() {
    orderMatters = true;
  }

  /** Returns whether the value may depend on the order of a set or a bag. */
  boolean doesOrderMatter() {
    return orderMatters;
  }

  /** Returns the number of uses of each construct. */
  Map<String, Integer> used() {
    return used;
  }
}
