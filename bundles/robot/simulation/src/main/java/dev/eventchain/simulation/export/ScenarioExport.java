package dev.eventchain.simulation.export;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Situation;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A scenario as files that players of OpenSCENARIO XML read: {@code NAME.xosc} and its road, {@code
 * NAME.xodr}. What moves is where it is in the simulation, to some centimetres, until the software
 * demands something.
 *
 * @param files the contents by name; none if a part of the scenario cannot be said in the format
 * @param diagnostics why not ({@code export.condition}, {@code export.maneuver}), and what is left
 *     out ({@code export.input})
 */
public record ScenarioExport(Map<String, byte[]> files, List<Diagnostic> diagnostics) {

  /** Length of the road behind and ahead of everything, in m. */
  private static final double MARGIN = 200.0;

  /** Copies the list. */
  public ScenarioExport {
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Exports a scenario.
   *
   * @param software the name of the software under test
   */
  public static ScenarioExport of(Scenario scenario, String software) {
    List<Diagnostic> found = new ArrayList<>();
    Situation situation = scenario.situation();
    if (situation.director().isPresent()) {
      found.add(
          Diagnostic.of(
              ExportRules.MANEUVER,
              "Its situation comes from another file, which players of OpenSCENARIO can read.",
              scenario.location()));
      return new ScenarioExport(Map.of(), found);
    }
    EntityNames names = new EntityNames(situation.actors());
    List<Mover> movers = movers(situation, names);
    RoadFrame frame = frame(scenario, movers);
    Markup file = new OpenScenarioFile(scenario, frame, names, found::add).markup(movers, software);
    if (!found.isEmpty()) {
      return new ScenarioExport(Map.of(), found);
    }
    if (!scenario.inputs().isEmpty()) {
      found.add(inputs(scenario));
    }
    Map<String, byte[]> files = new TreeMap<>();
    files.put(scenario.name() + ".xosc", file.file());
    files.put(scenario.name() + ".xodr", road(scenario, frame).markup(scenario.name()).file());
    return new ScenarioExport(files, found);
  }

  private static Diagnostic inputs(Scenario scenario) {
    return Diagnostic.of(
            ExportRules.INPUT,
            "Players of OpenSCENARIO do not know the inputs of the bench: they stand in the file as"
                + " properties only.",
            scenario.locationOfPart("/inputs"))
        .withHint("No motion that the file describes depends on them; the software may.");
  }

  private static List<Mover> movers(Situation situation, EntityNames names) {
    List<Mover> movers = new ArrayList<>(List.of(Mover.ego(situation)));
    for (Actor actor : situation.actors()) {
      if (!actor.kind().isFurniture()) {
        String pointer = "/actors/" + (movers.size() - 1);
        movers.add(Mover.of(actor, names.of(actor.name()), pointer, situation.road()));
      }
    }
    return movers;
  }

  private static RoadFrame frame(Scenario scenario, List<Mover> movers) {
    Situation situation = scenario.situation();
    double behind = 0.0;
    double ahead = 0.0;
    for (Actor actor : situation.actors()) {
      behind = Math.max(behind, -actor.along(0.0));
      ahead = Math.max(ahead, actor.along(0.0));
    }
    double farthest = 0.0;
    for (Mover mover : movers) {
      farthest = Math.max(farthest, mover.motion().fastest() * scenario.duration());
    }
    // Whatever waits may turn out to drive at its fastest all the time, in either direction.
    return new RoadFrame(
        situation.road(),
        Math.ceil(behind + (oncoming(movers) ? farthest : 0.0) + MARGIN),
        Math.ceil(ahead + farthest + MARGIN));
  }

  private static boolean oncoming(List<Mover> movers) {
    return movers.stream().anyMatch(each -> StrictMath.cos(each.direction()) < 0.0);
  }

  /** Returns the road with the lanes in which vehicles drive, as far as there is room for them. */
  private static RoadFile road(Scenario scenario, RoadFrame frame) {
    double width = frame.laneWidth();
    double room = Math.floor((Road.WALL_DISTANCE - width / 2) / width);
    double left = 0.0;
    double right = 0.0;
    for (Actor actor : scenario.situation().actors()) {
      if (Mover.isVehicle(actor.kind()) && !actor.kind().isFurniture()) {
        double first = Math.rint(actor.across(0.0) / width);
        double last = Math.rint(actor.across(scenario.duration()) / width);
        left = Math.max(left, Math.min(room, Math.max(first, last)));
        right = Math.max(right, Math.min(room, -Math.min(first, last)));
      }
    }
    return new RoadFile(frame, (int) left, (int) right);
  }
}
