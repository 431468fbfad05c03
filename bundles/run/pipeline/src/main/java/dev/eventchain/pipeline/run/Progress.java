package dev.eventchain.pipeline.run;

import java.nio.file.Path;
import java.time.Duration;

/** Is notified of the progress of a run, on the thread that runs it. */
public interface Progress {

  /** How a stage ended. */
  enum Status {
    DONE("done"),
    UNCHANGED("unchanged"),
    FAILED("failed"),
    /** An answer from outside is awaited; the same command continues when it is there. */
    WAITING("waiting"),
    NOT_RUN("not run");

    private final String words;

    Status(String words) {
      this.words = words;
    }

    /** Whether later stages cannot continue. */
    public boolean isStopped() {
      return this == FAILED || this == WAITING;
    }

    /** The words that people read. */
    @Override
    public String toString() {
      return words;
    }
  }

  /** Nobody is told. */
  Progress NONE =
      new Progress() {
        @Override
        public void started(Stage stage) {}

        @Override
        public void step(Stage stage, String message) {}

        @Override
        public void ended(Stage stage, Status status, Duration duration, String details) {}
      };

  /** A stage begins. */
  void started(Stage stage);

  /** Something inside a stage begins or is worth knowing, in a few words. */
  void step(Stage stage, String message);

  /**
   * A stage has ended.
   *
   * @param details what it made, in a few words; may be empty
   */
  void ended(Stage stage, Status status, Duration duration, String details);

  /**
   * The model of a chain, or its description, is read and understood: once for each state of the
   * files that this depends on.
   */
  default void read(Path file) {}
}
