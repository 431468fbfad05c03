package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the Python environment and its confinement. */
final class PythonRules {

  static final Rule DDS_UNAVAILABLE = Rule.error("dds.unavailable");
  static final Rule PYTHON_CONFINEMENT_UNAVAILABLE = Rule.error("python.confinement.unavailable");
  static final Rule PYTHON_CONFINEMENT_UNKNOWN = Rule.error("python.confinement.unknown");
  static final Rule PYTHON_UNAVAILABLE = Rule.error("python.unavailable");
  static final Rule PYTHON_WHEELS_MISSING = Rule.error("python.wheels.missing");
  static final Rule RAY_UNAVAILABLE = Rule.error("ray.unavailable");
  static final Rule TEMPORARY_UNWRITABLE = Rule.error("temporary.unwritable");

  private PythonRules() {}
}
