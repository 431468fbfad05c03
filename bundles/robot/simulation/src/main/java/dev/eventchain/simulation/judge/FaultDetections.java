package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostFailures;
import dev.eventchain.simulation.host.RunLog.Affected;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.measure.InputAges;
import dev.eventchain.simulation.measure.InputAges.TooOld;
import dev.eventchain.simulation.measure.MeasureRules;
import dev.eventchain.simulation.run.FaultRun;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.verdict.FaultVerdict.Detection;
import dev.eventchain.simulation.verdict.FaultVerdict.Means;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * Detections of a fault: findings of the run with the fault that the run without it lacks. Excluded
 * are: silent components, whose finding presupposes knowledge of the fault; deadline and liveliness
 * events of DDS, whose clock is not simulated; and the end of a run, which may be due to a limit of
 * the simulation.
 */
final class FaultDetections {

  private final SimulatedChain chain;
  private final UserFiles files;
  private final FaultRun faulty;
  private final ScenarioRun without;

  FaultDetections(SimulatedChain chain, UserFiles files, FaultRun faulty, ScenarioRun without) {
    this.chain = chain;
    this.files = files;
    this.faulty = faulty;
    this.without = without;
  }

  /** Returns all detections in the order of time; those without one come last. */
  List<Detection> all() {
    List<Detection> all = new ArrayList<>();
    inputs(all);
    losses(all);
    all.sort(
        Comparator.comparingDouble((Detection it) -> it.time().orElse(Double.POSITIVE_INFINITY))
            .thenComparing(Detection::means));
    return all;
  }

  /** Collects the first time at which each input was too old only because of the fault. */
  private void inputs(List<Detection> all) {
    Set<String> known = new HashSet<>();
    InputAges.tooOld(without, chain, time -> time).forEach(it -> known.add(key(it) + it.time()));
    Set<String> told = new HashSet<>();
    for (TooOld each : InputAges.tooOld(faulty.run(), chain, faulty.fault()::clock)) {
      boolean caused =
          each.time() >= faulty.fault().start() && !known.contains(key(each) + each.time());
      if (caused && told.add(key(each))) {
        all.add(
            new Detection(
                each.command() ? Means.CHECK : Means.SOFTWARE,
                MeasureRules.INPUT_TOO_OLD,
                each.node(),
                each.words(),
                OptionalDouble.of(World.seconds(each.time()))));
      }
    }
  }

  private static String key(TooOld each) {
    return each.node() + " " + each.topic() + " " + each.command() + " ";
  }

  /** Collects the nodes that failed. */
  private void losses(List<Detection> all) {
    for (Map.Entry<String, Affected> each : faulty.run().log().affected().entrySet()) {
      if (each.getValue().loss().isObject()) {
        Diagnostic found = HostFailures.inUserCode(each.getValue().loss(), files);
        double time = World.seconds(each.getValue().loss().path("time").asLong());
        all.add(
            new Detection(
                Means.FAILURE,
                found.kind(),
                each.getKey(),
                found.message(),
                OptionalDouble.of(time)));
      }
    }
  }
}
