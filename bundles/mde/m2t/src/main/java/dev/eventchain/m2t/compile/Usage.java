package dev.eventchain.m2t.compile;

import dev.eventchain.m2t.template.Callable;
import dev.eventchain.ocl.Expression;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Expressions of each callable, recorded during parsing for the {@link Lints}. */
final class Usage {
  private final Map<Callable, List<Expression>> expressions = new HashMap<>();
  private List<Expression> current = new ArrayList<>();

  /** Assigns the following expressions to a callable. */
  void enter(Callable callable) {
    current = expressions.computeIfAbsent(callable, key -> new ArrayList<>());
  }

  void add(Expression expression) {
    current.add(expression);
  }

  List<Expression> of(Callable callable) {
    return expressions.getOrDefault(callable, List.of());
  }
}
