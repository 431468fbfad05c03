package dev.eventchain.pipeline.run;

import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Suppressions;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * What a run should do.
 *
 * @param output the folder that everything is written to
 * @param first the first stage; what earlier stages made is read from the output folder
 * @param last the last stage
 * @param again whether stages run even where nothing has changed since they last did
 * @param llm how answers are had ({@code replay} or {@code handoff:DIR}); empty: as the project's
 *     configuration says
 * @param record whether answers from elsewhere are kept as recordings of the project
 * @param overwrite whether files that a person has edited in the output folder are replaced
 * @param scenarios the names of the scenarios to simulate; empty: all
 * @param driver how the nodes are run that are simulated
 * @param mcap whether the messages of the scenarios are recorded, too
 * @param compare what another run measured, which the report shows next to what this one does: its
 *     {@code measurements.json}, or the folder of it
 * @param faults a file with faults that scenarios are simulated with besides
 * @param suppressions the findings that do not count
 * @param timeLimit the processor time that a constraint may take on the whole model
 */
public record RunOptions(
    Path output,
    Stage first,
    Stage last,
    boolean again,
    Optional<String> llm,
    boolean record,
    boolean overwrite,
    List<String> scenarios,
    Driver driver,
    boolean mcap,
    Optional<Path> compare,
    Optional<Path> faults,
    Suppressions suppressions,
    Duration timeLimit) {

  /** What brings messages from one node to another, and lets time pass. */
  public enum Driver {
    /** All nodes in one process, messages in its memory. */
    LOCKSTEP,
    /** Each node in its own process on Cyclone DDS, in simulated time. */
    DDS,
    /** The same in real time. */
    DDS_IN_REAL_TIME,
    /** Others run the nodes, in the DDS domain that the environment names, in real time. */
    DDS_ATTACHED
  }

  /**
   * All stages, in lock-step, with answers as the project's configuration says; nothing is
   * suppressed.
   *
   * @param output the folder that everything is written to
   */
  public static RunOptions of(Path output) {
    return new RunOptions(
        output,
        Stage.DESIGN,
        Stage.REPORT,
        false,
        Optional.empty(),
        false,
        false,
        List.of(),
        Driver.LOCKSTEP,
        false,
        Optional.empty(),
        Optional.empty(),
        Suppressions.NONE,
        OclValidator.TIME_LIMIT);
  }

  /** Checks the order of the stages. */
  public RunOptions {
    if (first.compareTo(last) > 0) {
      throw new IllegalArgumentException(
          "the first stage, " + first.id() + ", comes after the last one, " + last.id());
    }
    scenarios = List.copyOf(scenarios);
  }

  /** The same for other stages, in another folder. */
  public RunOptions in(Path folder, Stage from, Stage to) {
    return new RunOptions(
        folder,
        from,
        to,
        again,
        llm,
        record,
        overwrite,
        scenarios,
        driver,
        mcap,
        compare,
        faults,
        suppressions,
        timeLimit);
  }

  /** Whether only some of the scenarios are simulated, which is not enough for a verdict. */
  public boolean isPartial() {
    return !scenarios.isEmpty();
  }

  /** Whether the nodes are run elsewhere: it is unknown whether they are the same as before. */
  public boolean isAttached() {
    return driver == Driver.DDS_ATTACHED;
  }

  /** Whether scenarios are simulated even where nothing has changed here. */
  public boolean simulatesAnyway() {
    return mcap || isAttached();
  }

  /** Whether nothing is written, so that it works where nothing can be written. */
  public boolean readsOnly() {
    return first == Stage.VALIDATE && last == Stage.VALIDATE;
  }

  public boolean runs(Stage stage) {
    return first.compareTo(stage) <= 0 && stage.compareTo(last) <= 0;
  }
}
