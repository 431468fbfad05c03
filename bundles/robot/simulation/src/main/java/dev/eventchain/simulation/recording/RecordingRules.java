package dev.eventchain.simulation.recording;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about recordings. */
final class RecordingRules {

  static final Rule RECORDING_UNWRITABLE = Rule.error("simulation.recording.unwritable");

  private RecordingRules() {}
}
