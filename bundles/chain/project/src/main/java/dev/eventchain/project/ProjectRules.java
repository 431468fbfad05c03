package dev.eventchain.project;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the folder of a project. */
final class ProjectRules {

  static final Rule MODELER_COMPONENT_FILE = Rule.error("modeler.component.file");
  static final Rule MODELER_COMPONENT_IMPLEMENTATION =
      Rule.error("modeler.component.implementation");
  static final Rule MODELER_COMPONENT_NODE = Rule.error("modeler.component.node");
  static final Rule MODELER_COMPONENT_OUTPUT_UNUSED =
      Rule.warning("modeler.component.output.unused");
  static final Rule MODELER_COMPONENT_VALUE_CHANGED = Rule.error("modeler.component.value.changed");
  static final Rule MODELER_COMPONENT_VALUE_MISSING = Rule.error("modeler.component.value.missing");
  static final Rule MODELER_COMPONENT_VALUE_UNKNOWN = Rule.error("modeler.component.value.unknown");
  static final Rule MODELER_SIGNAL_DIRECTION = Rule.error("modeler.signal.direction");
  static final Rule PROJECT_ACCEPTED = Rule.error("project.accepted");
  static final Rule PROJECT_CATALOGUE = Rule.error("project.catalogue");
  static final Rule PROJECT_CONFIGURATION = Rule.error("project.configuration");
  static final Rule PROJECT_CONSTRAINTS_UNREAD = Rule.warning("project.constraints.unread");
  static final Rule PROJECT_FILE_MISNAMED = Rule.error("project.file.misnamed");
  static final Rule PROJECT_MISSING = Rule.error("project.missing");
  static final Rule PROJECT_QUESTION = Rule.warning("project.question");
  static final Rule PROJECT_QUESTIONS = Rule.error("project.questions");
  static final Rule SUPPRESSION_INVALID =
      Rule.error("suppression.invalid", CommonTrait.UNSUPPRESSIBLE);

  private ProjectRules() {}
}
