package dev.eventchain.pipeline.run;

/**
 * The stages of a run. Results of earlier stages are read from the output folder.
 *
 * @param again true to run them even if nothing has changed since their last run
 */
public record Stages(Stage first, Stage last, boolean again) {

  /** All stages. */
  public static final Stages ALL = upTo(Stage.REPORT);

  /** Checks their order. */
  public Stages {
    if (first.compareTo(last) > 0) {
      throw new IllegalArgumentException(
          "the first stage, " + first.id() + ", comes after the last one, " + last.id());
    }
  }

  /** Returns a single stage, which is run anew. */
  public static Stages only(Stage stage) {
    return new Stages(stage, stage, true);
  }

  /** Returns all stages up to one, of which those are run for which something has changed. */
  public static Stages upTo(Stage last) {
    return new Stages(Stage.DESIGN, last, false);
  }

  /** Returns whether a stage is among them. */
  public boolean include(Stage stage) {
    return first.compareTo(stage) <= 0 && stage.compareTo(last) <= 0;
  }
}
