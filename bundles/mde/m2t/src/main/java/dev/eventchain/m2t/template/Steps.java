package dev.eventchain.m2t.template;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.files.FileMode;
import dev.eventchain.m2t.files.GeneratedFiles;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.m2t.run.Elements;
import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.text.OutputBuffer;
import dev.eventchain.m2t.text.Texts;
import dev.eventchain.m2t.text.Undefined;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.output.ProtectedAreas;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/** Steps of templates, one for each kind of syntax node. */
public final class Steps {
  private Steps() {}

  /** Literal text. */
  public record Text(String text, boolean hasBreak, Place place) implements Step {
    public Text(String text, Place place) {
      this(text, text.indexOf('\n') >= 0, place);
    }

    @Override
    public void write(GenerationRun run) {
      run.writer().appendLiteral(text, hasBreak, place);
    }
  }

  /** The value of an expression. */
  public record Output(Expression value, Place place) implements Step {
    @Override
    public void write(GenerationRun run) {
      run.writer().append(Undefined.textOf(run.evaluate(value, Undefined.TEXT)), place);
    }
  }

  /** The value of an expression, whose elements are decorated like those of a loop. */
  public record DecoratedOutput(Expression value, Decoration decoration, Place place)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object result = run.evaluate(value, Undefined.TEXT);
      if (result instanceof Invalid) {
        run.writer().append(Undefined.textOf(result), place);
        return;
      }
      boolean first = true;
      for (Object item : Elements.of(result)) {
        decoration.writeAhead(first, run);
        run.writer().append(Texts.of(item), place);
        first = false;
      }
      decoration.writeBehind(first, run);
    }
  }

  /** The text of a called template, or of one for each element, indented like the caller. */
  public record CallOutput(Expression value, CallLibrary.Call call) implements Step {
    @Override
    public void write(GenerationRun run) {
      OutputBuffer output = run.output();
      OutputBuffer.Part before = output.mark();
      String indentation = output.currentIndentation();
      Object result =
          run.evaluateCalls(
              value,
              (source, arguments, evaluation) -> call.write(source, arguments, run, indentation));
      if (result instanceof Invalid) {
        output.cut(before);
        run.writer().append(Undefined.textOf(result), value);
      }
    }
  }

  /** Calls whose texts are decorated like those of a loop. */
  public record DecoratedCallOutput(Expression value, CallLibrary.Call call, Decoration decoration)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      OutputBuffer output = run.output();
      OutputBuffer.Part before = output.mark();
      boolean[] first = {true};
      Object result =
          run.evaluateCalls(
              value,
              (source, arguments, evaluation) -> {
                decoration.writeAhead(first[0], run);
                first[0] = false;
                return call.write(source, arguments, run, output.currentIndentation());
              });
      if (result instanceof Invalid) {
        output.cut(before);
        run.writer().append(Undefined.textOf(result), value);
      } else {
        decoration.writeBehind(first[0], run);
      }
    }
  }

  /** The text of the template that the current one overrides. */
  public record Super(Template overridden) implements Step {
    @Override
    public void write(GenerationRun run) {
      overridden.write(run.calls().arguments(), run, run.output().currentIndentation());
    }
  }

  /** Text before, between and after the items of a loop. */
  public record Decoration(
      Optional<Expression> before, Optional<Expression> separator, Optional<Expression> after) {

    /** Writes the text before the first item, or between two. */
    void writeAhead(boolean first, GenerationRun run) {
      writeText(first ? before : separator, run);
    }

    /** Writes the text after the last item, if there are items. */
    void writeBehind(boolean none, GenerationRun run) {
      if (!none) {
        writeText(after, run);
      }
    }

    private static void writeText(Optional<Expression> text, GenerationRun run) {
      if (text.isPresent()) {
        Object value = run.evaluate(text.get(), Undefined.TEXT);
        run.writer().append(Undefined.textOf(value), text.get());
      }
    }
  }

  /** A loop. */
  public record For(
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
      Object value = run.read(items, Undefined.BLOCK);
      if (value instanceof Invalid) {
        return;
      }
      Collection<?> all = Elements.read(value);
      if (all.isEmpty()) {
        return;
      }
      Decoration.writeText(decoration.before(), run);
      int place = run.calls().enterLoop(variable);
      try {
        int index = 0;
        boolean first = true;
        for (Object item : all) {
          if (item(place, item, ++index, !first, run)) {
            first = false;
          }
        }
      } finally {
        run.calls().leaveLoop(place);
      }
      Decoration.writeText(decoration.after(), run);
    }

    private boolean item(int place, Object item, int index, boolean separator, GenerationRun run) {
      if (item != null && !accepts.test(item)) {
        run.calls().skipItem();
        run.report()
            .find(
                GenerationRules.FOR_TYPE,
                items.location(),
                "The loop skips "
                    + (item instanceof org.eclipse.emf.ecore.EObject object
                        ? Texts.label(object)
                        : "'" + item + "'")
                    + ", which is not of type "
                    + typeName
                    + ".",
                "Filter the collection: ->filter(" + typeName + ").");
        return false;
      }
      run.calls().nextItem(place, item, index, variable);
      if (guard.isPresent() && !run.holds(guard.get())) {
        return false;
      }
      if (separator) {
        Decoration.writeText(decoration.separator(), run);
      }
      Step.withVariables(variables, run, body);
      return true;
    }
  }

  /** A choice by conditions. Null counts as false; an undefined condition ends the choice. */
  public record If(List<Branch> branches, Step otherwise) implements Step {
    public record Branch(Expression condition, List<Step.Variable> variables, Step body) {}

    @Override
    public void write(GenerationRun run) {
      for (Branch branch : branches) {
        Object value = run.condition(branch.condition(), Undefined.BLOCK);
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
  public record Let(List<Binding> bindings, Step otherwise) implements Step {
    /**
     * A variable and its block.
     *
     * @param expected the declared type, if it is one of collections and nothing else is written
     *     for values of other kinds
     */
    public record Binding(
        String name,
        Predicate<Object> accepts,
        Optional<String> expected,
        Expression value,
        List<Step.Variable> variables,
        Step body) {

      private boolean takes(Object value, GenerationRun run) {
        boolean taken = value != null && accepts.test(value);
        if (!taken && value instanceof Collection<?> && expected.isPresent()) {
          reportKind(expected.get(), run);
        }
        return taken;
      }

      private void reportKind(String type, GenerationRun run) {
        run.report()
            .find(
                GenerationRules.LET_KIND,
                value.location(),
                "The block is not entered: a query made another kind of collection than "
                    + type
                    + ".",
                "Convert it in the query, for example by ->asSequence().");
      }
    }

    @Override
    public void write(GenerationRun run) {
      for (Binding binding : bindings) {
        Object value = run.evaluate(binding.value(), Undefined.BLOCK);
        if (value instanceof Invalid) {
          return;
        }
        if (binding.takes(value, run)) {
          int bindings = run.evaluation().bindings();
          run.evaluation().bind(binding.name(), value);
          try {
            Step.withVariables(binding.variables(), run, binding.body());
          } finally {
            run.evaluation().unbindTo(bindings);
          }
          return;
        }
      }
      otherwise.write(run);
    }
  }

  /** A file. */
  public record File(
      Expression name,
      Optional<Expression> modeExpression,
      FileMode mode,
      Optional<Expression> charset,
      Step body)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object fileName = run.evaluate(name, Undefined.FILE);
      Object append =
          modeExpression.isPresent() ? run.condition(modeExpression.get(), Undefined.FILE) : null;
      Object charsetName = value(charset, run);
      if (fileName instanceof Invalid
          || append instanceof Invalid
          || charsetName instanceof Invalid) {
        return;
      }
      if (Texts.of(fileName).isEmpty()) {
        String what = fileName == null ? "null" : "empty";
        run.report()
            .undefined(
                name,
                new Invalid("the name of the file is " + what, name.location(), Invalid.Kind.OTHER),
                Undefined.FILE);
        return;
      }
      FileMode actual = Boolean.TRUE.equals(append) ? FileMode.APPEND : mode;
      Optional<String> named =
          Optional.ofNullable(charsetName).map(Texts::of).filter(text -> !text.isEmpty());
      SourceLocation place = name.location();
      SourceLocation charsetPlace = charset.map(Expression::location).orElse(place);
      var tag = new GeneratedFiles.Tag(place, Texts.of(fileName), actual, charsetPlace, named);
      run.files().write(tag, () -> body.write(run));
    }

    private static Object value(Optional<Expression> part, GenerationRun run) {
      return part.isPresent() ? run.evaluate(part.get(), Undefined.FILE) : null;
    }
  }

  /**
   * A protected area, which users may edit. It always writes the text of its block; earlier content
   * replaces that text in the file.
   */
  public record Protected(
      Expression id, Optional<Expression> startPrefix, Optional<Expression> endPrefix, Step body)
      implements Step {
    @Override
    public void write(GenerationRun run) {
      Object value = run.evaluate(id, Undefined.AREA);
      if (value instanceof Invalid) {
        return;
      }
      String marker = Texts.of(value).strip();
      if (!run.files().beginArea(id.location(), marker)) {
        return;
      }
      try {
        Decoration.writeText(startPrefix, run);
        run.files().startArea();
        run.writer().append(ProtectedAreas.START + marker, id);
        body.write(run);
        Decoration.writeText(endPrefix, run);
        run.writer().append(ProtectedAreas.END, id);
      } finally {
        run.files().endArea();
      }
    }
  }
}
