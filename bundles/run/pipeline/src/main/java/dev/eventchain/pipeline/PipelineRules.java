package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about commands as a whole. */
final class PipelineRules {

  static final Rule EVENTCHAIN_DEFECT = Rule.error("eventchain.defect", CommonTrait.UNSUPPRESSIBLE);
  static final Rule EVENTCHAIN_FILES = Rule.error("eventchain.files");
  static final Rule EVENTCHAIN_MEMORY = Rule.error("eventchain.memory");
  static final Rule PROPERTIES_DUPLICATE = Rule.error("properties.duplicate");
  static final Rule REPORT_UNWRITABLE = Rule.error("report.unwritable", CommonTrait.UNSUPPRESSIBLE);

  private PipelineRules() {}
}
