package dev.eventchain.cli;

import dev.eventchain.pipeline.run.Stage;

/**
 * The stages that a command runs.
 *
 * @param again true to run them although nothing has changed
 */
record Stages(Stage first, Stage last, boolean again) {

  /** Returns a single stage, which is run anew. */
  static Stages only(Stage stage) {
    return new Stages(stage, stage, true);
  }

  /** Returns all stages up to one, of which those are run for which something has changed. */
  static Stages upTo(Stage last) {
    return new Stages(Stage.DESIGN, last, false);
  }
}
