package dev.eventchain.m2t.text;

import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.ocl.Expression;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;

/** Writes the text of a run, and notes where it comes from if that is wanted. */
public final class RunWriter {
  private final OutputBuffer output;
  private final Tracing tracing;
  private final Supplier<EObject> element;

  /**
   * Starts with an empty text.
   *
   * @param tracing where the lines of files are noted; null if that is not wanted
   * @param element the model element at work
   */
  public RunWriter(Tracing tracing, Supplier<EObject> element) {
    this.output = new OutputBuffer(tracing != null);
    this.tracing = tracing;
    this.element = element;
  }

  public OutputBuffer output() {
    return output;
  }

  /** Where the lines of files are noted; nowhere (null) if that is not wanted. */
  public Tracing tracing() {
    return tracing;
  }

  /** Drops where a file comes from, because another one replaces it. */
  public void forget(String file) {
    if (tracing != null) {
      tracing.forget(file);
    }
  }

  /** Appends what the expression of a tag gives. */
  public void append(String text, Place tag) {
    if (tracing == null) {
      output.append(text);
    } else if (!text.isEmpty()) {
      output.append(text, tracing.origin(tag, 0, element.get()));
    }
  }

  /** Appends what an expression gives. */
  public void append(String text, Expression expression) {
    if (tracing == null) {
      output.append(text);
    } else if (!text.isEmpty()) {
      output.append(text, tracing.origin(expression, element.get()));
    }
  }

  /** Appends what an expression gives, with some indentation after each line break. */
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

  /** Appends text as a template has it. */
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
