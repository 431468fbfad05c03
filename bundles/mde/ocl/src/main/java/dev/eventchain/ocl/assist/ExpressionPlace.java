package dev.eventchain.ocl.assist;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.ExpressionAssistant;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.editing.Mention;
import java.util.List;

/**
 * An expression in a text.
 *
 * @param assistant that of the expression's language
 */
public record ExpressionPlace(SourceRange range, Scope scope, ExpressionAssistant assistant) {

  /** Returns whether an offset is in the expression or at one of its ends. */
  public boolean touches(int offset) {
    return range.start() <= offset && offset <= range.end();
  }

  /** Returns the names in the expression. */
  public List<Mention> mentions() {
    return assistant.mentions(range, scope);
  }
}
