package dev.eventchain.pipeline.run;

import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.output.OutputFolder.OnEdit;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;

/**
 * Options of a run.
 *
 * @param output the output folder
 * @param onEdit what becomes of files in the output folder that a person has edited
 * @param compare the measurements of another run, which the report compares with this one's: its
 *     {@code measurements.json} or its folder
 * @param suppressions the findings that do not count
 * @param timeLimit the processor time that a constraint may take on the whole model
 */
public record RunOptions(
    Path output,
    Stages stages,
    Answers answers,
    OnEdit onEdit,
    SimulationOptions simulation,
    Optional<Path> compare,
    Suppressions suppressions,
    Duration timeLimit) {

  /**
   * Returns options for all stages, in lock-step, with the project's source of answers and without
   * suppressions.
   *
   * @param output the output folder
   */
  public static RunOptions of(Path output) {
    return new RunOptions(
        output,
        Stages.ALL,
        Answers.OF_PROJECT,
        OnEdit.KEEP,
        SimulationOptions.DEFAULT,
        Optional.empty(),
        Suppressions.NONE,
        OclValidator.TIME_LIMIT);
  }

  /** Returns options for other stages. */
  public RunOptions with(Stages others) {
    return new RunOptions(
        output, others, answers, onEdit, simulation, compare, suppressions, timeLimit);
  }

  /** Returns options for other stages and another folder. */
  public RunOptions in(Path folder, Stage from, Stage to) {
    Stages others = new Stages(from, to, stages.again());
    return new RunOptions(
        folder, others, answers, onEdit, simulation, compare, suppressions, timeLimit);
  }

  /** Returns options with other suppressions. */
  public RunOptions accepting(Suppressions accepted) {
    return new RunOptions(
        output, stages, answers, onEdit, simulation, compare, accepted, timeLimit);
  }

  /** Returns options with another time limit. */
  public RunOptions within(Duration limit) {
    return new RunOptions(
        output, stages, answers, onEdit, simulation, compare, suppressions, limit);
  }

  public boolean runs(Stage stage) {
    return stages.include(stage);
  }

  /** Returns whether only some scenarios are simulated, which is not enough for a verdict. */
  public boolean isPartial() {
    return !simulation.scenarios().isAll();
  }

  /** Returns whether the run writes nothing, so that it works on read-only folders. */
  public boolean readsOnly() {
    return stages.first() == Stage.VALIDATE && stages.last() == Stage.VALIDATE;
  }

  /** Returns whether the run only writes the report about the results that stand. */
  public boolean onlyReports() {
    return stages.first() == Stage.REPORT;
  }
}
