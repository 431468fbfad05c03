package dev.eventchain.simulation.run;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.simulation.host.NodeSession.Notice;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Map;

/**
 * A scenario that was driven, and what happened in it.
 *
 * @param ready what the process said of itself and the connections of the nodes
 * @param lost how many messages got lost on the way between nodes, by topic
 * @param notices what DDS noticed of deadlines and liveliness
 * @param overrun how far the world fell behind the clock at most, in ns
 * @param hostNanos time on this machine for the steps
 */
public record ScenarioRun(
    Scenario scenario,
    Trace trace,
    RunLog log,
    JsonNode ready,
    Map<String, Long> lost,
    List<Notice> notices,
    long overrun,
    long hostNanos) {

  /** From here on the world was not the one that the nodes were to meet. */
  private static final long MOST_OVERRUN = 20_000_000L;

  /** The same, judged by another scenario's criteria. */
  public ScenarioRun with(Scenario other) {
    return new ScenarioRun(other, trace, log, ready, lost, notices, overrun, hostNanos);
  }

  /** Whether the world fell so far behind the clock that nothing can be concluded. */
  public boolean isOverrun() {
    return overrun > MOST_OVERRUN;
  }
}
