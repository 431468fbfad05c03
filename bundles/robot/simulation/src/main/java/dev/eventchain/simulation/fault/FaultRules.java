package dev.eventchain.simulation.fault;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about files of faults. */
final class FaultRules {

  static final Rule FAULT_KEY_DUPLICATE = Rule.error("fault.key.duplicate");
  static final Rule FAULT_KEY_MISSING = Rule.error("fault.key.missing");
  static final Rule FAULT_KEY_UNKNOWN = Rule.error("fault.key.unknown");
  static final Rule FAULT_KIND = Rule.error("fault.kind");
  static final Rule FAULT_NAME_DUPLICATE = Rule.error("fault.name.duplicate");
  static final Rule FAULT_NONE = Rule.error("fault.none");
  static final Rule FAULT_SYNTAX = Rule.error("fault.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule FAULT_UNKNOWN = Rule.error("fault.unknown");
  static final Rule FAULT_VALUE_RANGE = Rule.error("fault.value.range");
  static final Rule FAULT_VALUE_TYPE = Rule.error("fault.value.type");
  static final Rule SIMULATION_FAULT_LEFT_OUT = Rule.warning("simulation.fault.left-out");

  private FaultRules() {}
}
