package dev.eventchain.check;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about validation. */
public final class CheckRules {

  public static final Rule OCL_MODEL_UNCONSTRAINED = Rule.warning("ocl.model-unconstrained");
  public static final Rule OCL_VACUOUS = Rule.error("ocl.vacuous");
  public static final Rule PROJECT_MODEL = Rule.error("project.model");
  public static final Rule PROJECT_MODEL_MISSING =
      Rule.info("project.model.missing", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule PROJECT_REQUIREMENT_CHANGED =
      Rule.warning("project.requirement.changed");
  public static final Rule PROJECT_REQUIREMENT_UNKNOWN = Rule.error("project.requirement.unknown");
  public static final Rule PROJECT_RULE_UNCOVERED = Rule.error("project.rule.uncovered");

  private CheckRules() {}
}
