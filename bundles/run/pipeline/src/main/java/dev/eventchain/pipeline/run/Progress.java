package dev.eventchain.pipeline.run;

import java.nio.file.Path;
import java.time.Duration;

/** Is notified of the progress of a run, on the thread that runs it. */
public interface Progress {

  /** The final states of a stage. */
  enum Status {
    DONE("done"),
    UNCHANGED("unchanged"),
    FAILED("failed"),
    /** Waiting for an external answer; the same command continues when it exists. */
    WAITING("waiting"),
    NOT_RUN("not run");

    private final String words;

    Status(String words) {
      this.words = words;
    }

    /** Returns whether later stages cannot continue. */
    public boolean isStopped() {
      return this == FAILED || this == WAITING;
    }

    /** Returns the text for people. */
    @Override
    public String toString() {
      return words;
    }
  }

  /** A listener that does nothing. */
  Progress NONE =
      new Progress() {
        @Override
        public void started(Stage stage) {}

        @Override
        public void step(Stage stage, String message) {}

        @Override
        public void ended(Stage stage, Status status, Duration duration, String details) {}
      };

  /** Reports the beginning of a stage. */
  void started(Stage stage);

  /** Reports a step or an event in a stage, in a few words. */
  void step(Stage stage, String message);

  /**
   * Reports the end of a stage.
   *
   * @param details a short description of its results; may be empty
   */
  void ended(Stage stage, Status status, Duration duration, String details);

  /**
   * Reports that the model of a chain, or its description, was read: once for each state of its
   * files.
   */
  default void read(Path file) {}
}
