package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about requirements in the formats of other tools. */
public final class RequirementRules {

  public static final Rule DUPLICATE = Rule.error("modeler.requirements.duplicate");
  public static final Rule EMPTY = Rule.error("modeler.requirements.empty");
  public static final Rule NONE = Rule.error("modeler.requirements.none");
  static final Rule FILTERED = Rule.info("requirements.filtered");
  static final Rule ID = Rule.error("requirements.id");
  static final Rule PARENT = Rule.warning("requirements.parent");
  static final Rule REDUCED = Rule.warning("requirements.reduced");
  static final Rule SELECTION = Rule.warning("requirements.selection");
  static final Rule SOURCE = Rule.error("requirements.source");
  public static final Rule UNREAD = Rule.warning("modeler.requirements.unread");

  private RequirementRules() {}
}
