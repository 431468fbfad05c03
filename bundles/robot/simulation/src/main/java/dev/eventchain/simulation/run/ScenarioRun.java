package dev.eventchain.simulation.run;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.simulation.host.NodeSession.Notice;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.FieldSamples;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Map;

/**
 * A driven scenario and its results.
 *
 * @param ready the Python version and the missing connections, as the process reported them
 * @param lost number of messages lost between nodes, by topic
 * @param notices deadline and liveliness events of DDS
 * @param outputs the outputs of the components, where they are recorded
 * @param samples what the nodes read and wrote, where it is kept
 * @param overrun largest delay of the world behind the clock, in ns
 * @param hostNanos wall time of the steps, in ns
 */
public record ScenarioRun(
    Scenario scenario,
    Trace trace,
    RunLog log,
    JsonNode ready,
    Map<String, Long> lost,
    List<Notice> notices,
    OutputRecord outputs,
    List<FieldSamples> samples,
    long overrun,
    long hostNanos) {

  /** Largest delay behind the clock at which results are valid, in ns. */
  private static final long MOST_OVERRUN = 20_000_000L;

  /** Returns a copy with the criteria of another scenario. */
  public ScenarioRun with(Scenario other) {
    return new ScenarioRun(
        other, trace, log, ready, lost, notices, outputs, samples, overrun, hostNanos);
  }

  /** Returns a copy with what the nodes read and wrote. */
  ScenarioRun with(List<FieldSamples> kept) {
    return new ScenarioRun(
        scenario, trace, log, ready, lost, notices, outputs, kept, overrun, hostNanos);
  }

  /** Returns whether the world fell too far behind the clock for valid results. */
  public boolean isOverrun() {
    return overrun > MOST_OVERRUN;
  }
}
