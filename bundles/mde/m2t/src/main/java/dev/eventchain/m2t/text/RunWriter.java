package dev.eventchain.m2t.text;

import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.ocl.Expression;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;

/** Writer of the text of a run, with optional tracing of its origins. */
public final class RunWriter {
  private final OutputBuffer output;
  private final Tracing tracing;
  private final Supplier<EObject> element;

  /**
   * Creates a writer with an empty text.
   *
   * @param tracing the trace of the lines of files; null without tracing
   * @param element returns the current model element
   */
  public RunWriter(Tracing tracing, Supplier<EObject> element) {
    this.output = new OutputBuffer(tracing != null);
    this.tracing = tracing;
    this.element = element;
  }

  public OutputBuffer output() {
    return output;
  }

  /** Returns the trace of the lines of files; null without tracing. */
  public Tracing tracing() {
    return tracing;
  }

  /** Drops the trace of a file that another one replaces. */
  public void forget(String file) {
    if (tracing != null) {
      tracing.forget(file);
    }
  }

  /** Appends the value of the expression of a tag. */
  public void append(String text, Place tag) {
    if (tracing == null) {
      output.append(text);
    } else if (!text.isEmpty()) {
      output.append(text, tracing.origin(tag, 0, element.get()));
    }
  }

  /** Appends the value of an expression. */
  public void append(String text, Expression expression) {
    if (tracing == null) {
      output.append(text);
    } else if (!text.isEmpty()) {
      output.append(text, tracing.origin(expression, element.get()));
    }
  }

  /** Appends the value of an expression, with an indentation after each line break. */
  public void appendIndented(String text, String indentation, Expression expression) {
    OutputBuffer.Part part = output.beginIndented(indentation);
    append(text, expression);
    output.end(part);
  }

  /** Appends text that does not come from a template. */
  public void appendOwn(String text) {
    if (tracing == null) {
      output.append(text);
    } else {
      output.append(text, OriginMarks.NONE);
    }
  }

  /** Appends literal text of a template. */
  public void appendLiteral(String text, boolean hasBreak, Place start) {
    if (tracing == null) {
      output.append(text, hasBreak);
      return;
    }
    EObject origin = element.get();
    int line = 0;
    for (int from = 0; from < text.length(); line++) {
      int lineBreak = text.indexOf('\n', from);
      int end = lineBreak < 0 ? text.length() : lineBreak + 1;
      output.append(text.substring(from, end), tracing.origin(start, line, origin));
      from = end;
    }
  }
}
