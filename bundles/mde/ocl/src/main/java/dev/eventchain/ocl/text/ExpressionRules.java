package dev.eventchain.ocl.text;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about expressions. */
public final class ExpressionRules {

  public static final Rule DUPLICATE = Rule.error("ocl.duplicate");
  public static final Rule STRING_QUOTE = Rule.warning("ocl.string.quote");
  public static final Rule SYNTAX = Rule.error("ocl.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule TYPE = Rule.error("ocl.type", CommonTrait.UNSUPPRESSIBLE);

  private ExpressionRules() {}
}
