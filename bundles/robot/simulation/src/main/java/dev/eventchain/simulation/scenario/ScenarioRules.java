package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about scenarios. */
final class ScenarioRules {

  static final Rule FILE_UNREAD = Rule.warning("scenario.file.unread");
  static final Rule INPUT_UNKNOWN = Rule.error("scenario.input.unknown");
  static final Rule KEY_DUPLICATE = Rule.error("scenario.key.duplicate");
  static final Rule KEY_MISSING = Rule.error("scenario.key.missing");
  static final Rule KEY_UNKNOWN = Rule.error("scenario.key.unknown");
  static final Rule NAME_DUPLICATE = Rule.error("scenario.name.duplicate");
  static final Rule NODE_UNKNOWN = Rule.warning("scenario.node.unknown");
  static final Rule NONE = Rule.error("scenario.none");
  static final Rule OUTPUT_UNRESOLVED = Rule.warning("scenario.output.unresolved");
  static final Rule SYNTAX = Rule.error("scenario.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule VALUE_RANGE = Rule.error("scenario.value.range");
  static final Rule VALUE_TYPE = Rule.error("scenario.value.type");

  private ScenarioRules() {}
}
