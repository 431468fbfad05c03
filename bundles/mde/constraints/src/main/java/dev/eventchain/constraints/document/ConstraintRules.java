package dev.eventchain.constraints.document;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about documents of constraints and their evaluation. */
public final class ConstraintRules {

  public static final Rule ANNOTATION = Rule.error("ocl.annotation");
  public static final Rule CONDITION_UNCHECKED = Rule.info("ocl.condition.unchecked");
  public static final Rule DOCUMENT_EMPTY = Rule.error("ocl.document.empty");
  public static final Rule IMPORT_UNKNOWN = Rule.error("ocl.import.unknown");
  public static final Rule JAVA_MISSING = Rule.error("ocl.java.missing");
  public static final Rule NOT_BOOLEAN = Rule.error("ocl.not-boolean", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule NOTHING_EVALUATED =
      Rule.error("ocl.nothing-evaluated", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule UNDEFINED = Rule.error("ocl.undefined");
  public static final Rule UNSUPPORTED = Rule.error("ocl.unsupported");
  public static final Rule VIOLATED = Rule.error("ocl.violated");

  private ConstraintRules() {}
}
