package dev.eventchain.m2t.template;

import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.text.Undefined;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.List;
import java.util.Optional;

/** A step of a compiled template. Immutable; all state is in the run. */
@FunctionalInterface
public interface Step {

  /** Writes the text of the step into the run, which reports problems. */
  void write(GenerationRun run);

  /** A variable with its initial value; null if there is none. */
  record Variable(String name, Optional<Expression> value) {}

  /** Returns a sequence of steps. */
  static Step sequence(List<Step> steps) {
    Step[] pieces = steps.toArray(Step[]::new);
    if (pieces.length == 1) {
      return pieces[0];
    }
    return run -> {
      for (Step piece : pieces) {
        piece.write(run);
      }
    };
  }

  /** Writes a step with variables in scope, unless one of them has an undefined value. */
  static void withVariables(List<Variable> variables, GenerationRun run, Step body) {
    if (variables.isEmpty()) {
      body.write(run);
      return;
    }
    int bindings = run.evaluation().bindings();
    try {
      for (Variable variable : variables) {
        Optional<Expression> given = variable.value();
        Object value = given.isEmpty() ? null : run.evaluate(given.get(), Undefined.BLOCK);
        if (value instanceof Invalid) {
          return;
        }
        run.evaluation().bind(variable.name(), value);
      }
      body.write(run);
    } finally {
      run.evaluation().unbindTo(bindings);
    }
  }
}
