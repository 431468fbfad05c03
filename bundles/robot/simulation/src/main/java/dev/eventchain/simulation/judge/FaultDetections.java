package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostFailures;
import dev.eventchain.simulation.host.RunLog.Affected;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.measure.InputAges;
import dev.eventchain.simulation.measure.InputAges.TooOld;
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
 * What tells of a fault in a run that does not do so in the run without it. That components did not
 * work at all is no such thing: that is known here because the fault is. Nor is what DDS notices of
 * deadlines and liveliness: its clock is not the simulated one. Nor is that a run could not
 * continue, which a limit of the simulation itself may have ended.
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

  /** In the order of time; those without one last. */
  List<Detection> all() {
    List<Detection> all = new ArrayList<>();
    inputs(all);
    losses(all);
    all.sort(
        Comparator.comparingDouble((Detection it) -> it.time().orElse(Double.POSITIVE_INFINITY))
            .thenComparing(Detection::means));
    return all;
  }

  /** The first time at which each input was too old and was not without the fault. */
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
                "simulation.input.too-old",
                each.node(),
                each.words(),
                OptionalDouble.of(World.seconds(each.time()))));
      }
    }
  }

  private static String key(TooOld each) {
    return each.node() + " " + each.topic() + " " + each.command() + " ";
  }

  /** The nodes that have failed. */
  private void losses(List<Detection> all) {
    for (Map.Entry<String, Affected> each : faulty.run().log().affected().entrySet()) {
      if (each.getValue().loss().isObject()) {
        Diagnostic found = HostFailures.inUserCode(each.getValue().loss(), files);
        double time = World.seconds(each.getValue().loss().path("time").asLong());
        all.add(
            new Detection(
                Means.FAILURE,
                found.id(),
                each.getKey(),
                found.message(),
                OptionalDouble.of(time)));
      }
    }
  }
}
