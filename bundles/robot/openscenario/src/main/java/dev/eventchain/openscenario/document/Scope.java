package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.expression.Expression;
import dev.eventchain.openscenario.expression.ExpressionException;
import dev.eventchain.openscenario.expression.Operand;
import dev.eventchain.openscenario.vocabulary.DataType;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * The parameters that are known at a place: those declared there, and those around it. A value is
 * computed when it is first needed, so that a declaration may use others before and after it.
 */
final class Scope {

  private static final Pattern REFERENCE = Pattern.compile("\\$[A-Za-z_]\\w*");
  private static final int LONGEST_QUOTE = 100;

  /** Origin of a value: its declaration, or who gives another one. */
  private record Source(
      ParameterDeclaration declared, String written, Scope scope, SourceLocation place) {}

  private final Scope outer;
  private final Findings findings;
  private final Map<String, Source> sources = new LinkedHashMap<>();
  private final Map<String, Optional<String>> values = new LinkedHashMap<>();

  /**
   * Creates a scope without parameters.
   *
   * @param outer the scope around it; null for that of a file or of an entry of a catalog
   */
  Scope(Scope outer, Findings findings) {
    this.outer = outer;
    this.findings = findings;
  }

  /** Adds a parameter. */
  void declare(ParameterDeclaration declared) {
    Source source = new Source(declared, declared.value(), this, declared.location());
    if (sources.putIfAbsent(declared.name(), source) != null) {
      findings.add(
          DocumentRules.PARAMETER_DUPLICATE,
          "The parameter `" + declared.name() + "` is declared twice.",
          declared.location(),
          "Leave one out.");
    }
  }

  /**
   * Gives a parameter another value.
   *
   * @param from the scope that the value is written in
   */
  void assign(String name, String written, Scope from, SourceLocation place) {
    Source source = sources.get(name);
    if (source == null) {
      unknown(name, sources.keySet(), place);
    } else {
      sources.put(name, new Source(source.declared(), written, from, place));
    }
  }

  /**
   * Returns the values of the parameters that are declared here, as far as they have one, and holds
   * them against their constraints.
   */
  Map<String, String> values() {
    Map<String, String> all = new LinkedHashMap<>();
    for (String name : sources.keySet()) {
      value(name, SourceLocation.NONE).ifPresent(value -> all.put(name, value));
    }
    Constraints constraints = new Constraints(this, findings);
    all.forEach(
        (name, value) -> {
          Source source = sources.get(name);
          constraints.check(source.declared(), value, source.place());
        });
    return all;
  }

  /**
   * Returns a text with its parameter or expression replaced; empty, with a finding, if that has no
   * value.
   */
  Optional<String> evaluate(String written, SourceLocation place) {
    String text = written.strip();
    if (!text.startsWith("$")) {
      return Optional.of(written);
    } else if (REFERENCE.matcher(text).matches()) {
      return value(text.substring(1), place);
    } else if (!text.startsWith("${") || !text.endsWith("}")) {
      findings.add(
          DocumentRules.EXPRESSION,
          "`" + text + "` is neither a parameter nor an expression.",
          place,
          "Write `$name` or `${...}`.");
      return Optional.empty();
    }
    return compute(text, place);
  }

  private Optional<String> compute(String text, SourceLocation place) {
    boolean[] reported = {false};
    try {
      Operand value =
          Expression.evaluate(
              text.substring(2, text.length() - 1),
              name -> {
                Optional<Operand> operand = operand(name, place);
                reported[0] = operand.isEmpty();
                return operand.orElse(new Operand.Text(""));
              });
      return reported[0] ? Optional.empty() : Optional.of(value.text());
    } catch (ExpressionException e) {
      if (!reported[0]) {
        findings.add(
            DocumentRules.EXPRESSION,
            "`" + shortened(text) + "` has no value. " + e.getMessage(),
            place,
            "");
      }
      return Optional.empty();
    }
  }

  private static String shortened(String text) {
    return text.length() <= LONGEST_QUOTE ? text : text.substring(0, LONGEST_QUOTE) + "...";
  }

  private Optional<Operand> operand(String name, SourceLocation place) {
    Scope owner = ownerOf(name);
    return value(name, place)
        .map(
            value -> {
              DataType type =
                  DataType.ofWord(owner.sources.get(name).declared().type()).orElseThrow();
              if (type.isNumber()) {
                return new Operand.Numeric(Double.parseDouble(value));
              }
              return type == DataType.BOOLEAN
                  ? new Operand.Truth(Boolean.parseBoolean(value))
                  : new Operand.Text(value);
            });
  }

  private Scope ownerOf(String name) {
    for (Scope scope = this; scope != null; scope = scope.outer) {
      if (scope.sources.containsKey(name)) {
        return scope;
      }
    }
    return null;
  }

  private Optional<String> value(String name, SourceLocation place) {
    Scope owner = ownerOf(name);
    if (owner == null) {
      Set<String> known = new TreeSet<>();
      for (Scope scope = this; scope != null; scope = scope.outer) {
        known.addAll(scope.sources.keySet());
      }
      unknown(name, known, place);
      return Optional.empty();
    }
    if (!owner.values.containsKey(name)) {
      owner.compute(name);
    }
    return owner.values.get(name);
  }

  /** Computes a value after those that it depends on, without recursion: chains may be long. */
  private void compute(String name) {
    Deque<String> next = new ArrayDeque<>(List.of(name));
    Set<String> open = new HashSet<>();
    while (!next.isEmpty()) {
      String top = next.peek();
      if (values.containsKey(top) || !open.add(top)) {
        if (!values.containsKey(top)) {
          values.put(top, computed(top));
        }
        open.remove(next.pop());
        continue;
      }
      for (String needed : missing(top)) {
        if (open.contains(needed)) {
          cycle(needed, sources.get(top).place());
          values.put(top, Optional.empty());
        } else {
          next.push(needed);
        }
      }
    }
  }

  /** Returns the parameters declared here that a value needs, and that have none yet. */
  private List<String> missing(String name) {
    Source source = sources.get(name);
    if (source.scope() != this || !source.written().strip().startsWith("$")) {
      return List.of();
    }
    return REFERENCE
        .matcher(source.written())
        .results()
        .map(found -> found.group().substring(1))
        .filter(needed -> sources.containsKey(needed) && !values.containsKey(needed))
        .toList();
  }

  private Optional<String> computed(String name) {
    Source source = sources.get(name);
    DataType type = DataType.ofWord(source.declared().type()).orElseThrow();
    return source
        .scope()
        .evaluate(source.written(), source.place())
        .flatMap(text -> AttributeValues.check(type, "$" + name, text, source.place(), findings));
  }

  private void cycle(String name, SourceLocation place) {
    findings.add(
        DocumentRules.PARAMETER_CYCLE,
        "The value of `" + name + "` depends on itself.",
        place,
        "Give one of them a value of its own.");
  }

  private void unknown(String name, Set<String> known, SourceLocation place) {
    findings.add(
        DocumentRules.PARAMETER_UNKNOWN,
        "No parameter `" + name + "` is declared.",
        place,
        findings.isFull() ? "" : NearestName.hint(name, known));
  }
}
