package dev.eventchain.pipeline.run;

import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.project.StrengthExtent;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;

/**
 * Options of a run.
 *
 * @param output the output folder
 * @param first the first stage; results of earlier stages are read from the output folder
 * @param last the last stage
 * @param again true to run stages even if nothing has changed since their last run
 * @param llm the source of answers ({@code replay} or {@code handoff:DIR}); empty for that of the
 *     project's configuration
 * @param record true to keep answers from elsewhere as recordings of the project
 * @param overwrite true to replace files in the output folder that a person has edited
 * @param scenarios those to simulate
 * @param driver the driver of the simulated nodes
 * @param mcap true to record the messages of the scenarios, too
 * @param compare the measurements of another run, which the report compares with this one's: its
 *     {@code measurements.json} or its folder
 * @param faults a file of faults for additional simulations of the scenarios
 * @param strength how far to measure the strength of requirements; empty: as the project says
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
    ScenarioSelection scenarios,
    Driver driver,
    boolean mcap,
    Optional<Path> compare,
    Optional<Path> faults,
    Optional<StrengthExtent> strength,
    Suppressions suppressions,
    Duration timeLimit) {

  /** Drivers of the nodes: they transport messages and advance time. */
  public enum Driver {
    /** All nodes in one process, with messages in memory. */
    LOCKSTEP,
    /** Each node in its own process on Cyclone DDS, in simulated time. */
    DDS,
    /** The same in real time. */
    DDS_IN_REAL_TIME,
    /** Nodes started elsewhere, in the DDS domain of the environment, in real time. */
    DDS_ATTACHED
  }

  /**
   * Returns options for all stages, in lock-step, with the project's source of answers and without
   * suppressions.
   *
   * @param output the output folder
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
        ScenarioSelection.ALL,
        Driver.LOCKSTEP,
        false,
        Optional.empty(),
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
  }

  /** Returns options for other stages and another folder. */
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
        strength,
        suppressions,
        timeLimit);
  }

  /** Returns options with other suppressions. */
  public RunOptions accepting(Suppressions accepted) {
    return new RunOptions(
        output, first, last, again, llm, record, overwrite, scenarios, driver, mcap, compare,
        faults, strength, accepted, timeLimit);
  }

  /** Returns whether only some scenarios are simulated, which is not enough for a verdict. */
  public boolean isPartial() {
    return !scenarios.isAll();
  }

  /** Returns whether the nodes run elsewhere, so that changes in them are unknown. */
  public boolean isAttached() {
    return driver == Driver.DDS_ATTACHED;
  }

  /** Returns whether scenarios are simulated even if nothing has changed here. */
  public boolean simulatesAnyway() {
    return mcap || isAttached();
  }

  /** Returns whether the run writes nothing, so that it works on read-only folders. */
  public boolean readsOnly() {
    return first == Stage.VALIDATE && last == Stage.VALIDATE;
  }

  /** Returns whether the run only writes the report about the results that stand. */
  public boolean onlyReports() {
    return first == Stage.REPORT;
  }

  public boolean runs(Stage stage) {
    return first.compareTo(stage) <= 0 && stage.compareTo(last) <= 0;
  }
}
