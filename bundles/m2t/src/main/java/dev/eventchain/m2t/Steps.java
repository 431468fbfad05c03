package dev.eventchain.m2t;

import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.Invalid;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/** The pieces that templates are made of, one for each kind of syntax node. */
final class Steps {
  private Steps() {}

  /** Literal text. */
  record Text(String text) implements Step {
    @Override
    public void write(GenerationRun run) {
      run.append(text);
    }
  }

  /** The value of an expression; the text of a called template is indented like its caller. */
  record Output(Expression value, boolean callsTemplate) implements Step {
    @Override
    public void write(GenerationRun run) {
      Object result = run.evaluate(value);
      if (result instanceof Invalid) {
        return;
      }
      if (callsTemplate) {
        run.appendIndented(Texts.of(result));
      } else {
        run.append(Texts.of(result));
      }
    }
  }

  /** A call whose results are decorated like those of a loop. */
  record DecoratedOutput(Expression value, boolean callsTemplate, Decoration decoration)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object result = run.evaluate(value);
      if (result instanceof Invalid) {
        return;
      }
      Collection<?> items = elements(result);
      decoration.write(
          run,
          items,
          (item, separator) -> {
            if (separator) {
              decoration.writeSeparator(run);
            }
            if (callsTemplate) {
              run.appendIndented(Texts.of(item));
            } else {
              run.append(Texts.of(item));
            }
            return true;
          });
    }
  }

  /** The text of the template that this one overrides. */
  record Super(Template template) implements Step {
    @Override
    public void write(GenerationRun run) {
      Template overridden = template.overridden().orElseThrow();
      run.appendIndented(Texts.of(overridden.callExactly(run.arguments(), run)));
    }
  }

  /** Before, between and after the items of a loop. */
  record Decoration(
      Optional<Expression> before, Optional<Expression> separator, Optional<Expression> after) {

    /** Writes an item, with a separator ahead if told; says whether it wrote anything. */
    interface Item {
      boolean write(Object item, boolean separator);
    }

    void write(GenerationRun run, Collection<?> items, Item writer) {
      if (items.isEmpty()) {
        return;
      }
      writeText(before, run);
      boolean first = true;
      for (Object item : items) {
        if (writer.write(item, !first)) {
          first = false;
        }
      }
      writeText(after, run);
    }

    void writeSeparator(GenerationRun run) {
      writeText(separator, run);
    }

    private static void writeText(Optional<Expression> text, GenerationRun run) {
      if (text.isPresent()) {
        Object value = run.evaluate(text.get());
        run.append(value instanceof Invalid ? "" : Texts.of(value));
      }
    }
  }

  /** A loop. */
  record For(
      Optional<String> variable,
      Predicate<Object> accepts,
      String typeName,
      Expression items,
      Optional<Expression> guard,
      Decoration decoration,
      List<Step.Variable> variables,
      Step body)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object value = run.evaluate(items);
      if (value instanceof Invalid) {
        return;
      }
      int[] index = {0};
      decoration.write(
          run, elements(value), (item, separator) -> item(item, ++index[0], separator, run));
    }

    private boolean item(Object item, int index, boolean separator, GenerationRun run) {
      if (item != null && !accepts.test(item)) {
        run.warn(
            "m2t.for.type",
            items.location(),
            "The loop skips "
                + (item instanceof org.eclipse.emf.ecore.EObject object
                    ? Texts.label(object)
                    : "'" + item + "'")
                + ", which is no "
                + typeName
                + ".",
            "Filter the collection: ->filter(" + typeName + ").");
        return false;
      }
      run.enterItem(item, index, variable);
      try {
        if (guard.isPresent() && !run.holds(guard.get())) {
          return false;
        }
        if (separator) {
          decoration.writeSeparator(run);
        }
        Step.withVariables(variables, run, body);
        return true;
      } finally {
        run.leaveItem(variable);
      }
    }
  }

  /** A choice by conditions, of which null is false; an invalid one ends the choice. */
  record If(List<Branch> branches, Step otherwise) implements Step {
    record Branch(Expression condition, List<Step.Variable> variables, Step body) {}

    @Override
    public void write(GenerationRun run) {
      for (Branch branch : branches) {
        Object value = run.evaluate(branch.condition());
        if (value instanceof Invalid) {
          return;
        }
        if (Boolean.TRUE.equals(value)) {
          Step.withVariables(branch.variables(), run, branch.body());
          return;
        }
      }
      otherwise.write(run);
    }
  }

  /** A choice by the types of values. */
  record Let(List<Binding> bindings, Step otherwise) implements Step {
    record Binding(
        String name,
        Predicate<Object> accepts,
        Expression value,
        List<Step.Variable> variables,
        Step body) {}

    @Override
    public void write(GenerationRun run) {
      for (Binding binding : bindings) {
        Object value = run.evaluate(binding.value());
        if (value instanceof Invalid) {
          return;
        }
        if (value != null && binding.accepts().test(value)) {
          run.evaluation().bind(binding.name(), value);
          try {
            Step.withVariables(binding.variables(), run, binding.body());
          } finally {
            run.evaluation().unbind(binding.name());
          }
          return;
        }
      }
      otherwise.write(run);
    }
  }

  /** A file. */
  record File(
      Expression name,
      Optional<Expression> modeExpression,
      FileMode mode,
      Optional<Expression> charset,
      Step body)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object fileName = run.evaluate(name);
      Object append = modeExpression.isPresent() ? run.evaluate(modeExpression.get()) : null;
      Object charsetName = charset.isPresent() ? run.evaluate(charset.get()) : null;
      if (fileName instanceof Invalid
          || append instanceof Invalid
          || charsetName instanceof Invalid) {
        return;
      }
      FileMode actual = Boolean.TRUE.equals(append) ? FileMode.APPEND : mode;
      run.files()
          .write(
              name.location(),
              Texts.of(fileName),
              actual,
              charsetName == null ? "" : Texts.of(charsetName),
              () -> body.write(run));
    }
  }

  /** How a file that is there already is treated. */
  enum FileMode {
    OVERWRITE,
    APPEND,
    CREATE
  }

  /** An area that people may fill. */
  record Protected(
      Expression id, Optional<Expression> startPrefix, Optional<Expression> endPrefix, Step body)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object value = run.evaluate(id);
      if (value instanceof Invalid) {
        return;
      }
      String marker = Texts.of(value).strip();
      if (!run.files().beginArea(id.location(), marker)) {
        return;
      }
      Decoration.writeText(startPrefix, run);
      run.append(ProtectedAreas.START + marker);
      Optional<String> kept = run.files().keptArea(marker);
      if (kept.isPresent()) {
        run.append(kept.get());
      } else {
        body.write(run);
        Decoration.writeText(endPrefix, run);
      }
      run.append(ProtectedAreas.END);
    }
  }

  /** What a loop goes through: a collection's elements, a single value, or nothing for null. */
  static Collection<?> elements(Object value) {
    if (value instanceof Collection<?> collection) {
      return new ArrayList<>(collection);
    }
    return value == null ? List.of() : List.of(value);
  }
}
