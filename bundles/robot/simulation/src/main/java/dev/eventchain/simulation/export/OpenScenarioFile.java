package dev.eventchain.simulation.export;

import static java.util.stream.Collectors.joining;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.scenario.Circumstance;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.SpeedProfile;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/** The OpenSCENARIO file of a scenario. */
final class OpenScenarioFile {

  /** The date of all files: the same scenario is the same file. */
  static final String DATE = "2026-01-01T00:00:00";

  private final Scenario scenario;
  private final Situation situation;
  private final RoadFrame frame;
  private final EntityNames names;
  private final Triggers triggers;
  private final Consumer<Diagnostic> findings;
  private final List<Markup> parameters = new ArrayList<>();
  private final List<Markup> beginnings = new ArrayList<>();
  private final List<Markup> groups = new ArrayList<>();

  OpenScenarioFile(
      Scenario scenario, RoadFrame frame, EntityNames names, Consumer<Diagnostic> findings) {
    this.scenario = scenario;
    this.situation = scenario.situation();
    this.frame = frame;
    this.names = names;
    this.triggers = new Triggers(situation, names, findings);
    this.findings = findings;
  }

  /**
   * Returns the file; of no use if there was a finding with an error.
   *
   * @param software the name of the software under test
   */
  Markup markup(List<Mover> movers, String software) {
    movers.forEach(this::mover);
    situation.actors().stream().filter(each -> each.kind().isFurniture()).forEach(this::furniture);
    Markup entities = new Markup("Entities").add(EntityElements.ego(situation.ego(), software));
    for (Actor actor : situation.actors()) {
      entities.add(EntityElements.actor(actor, names.of(actor.name())));
    }
    Markup road = new Markup("LogicFile").with("filepath", scenario.name() + ".xodr");
    return new Markup("OpenSCENARIO")
        .add(
            header(),
            new Markup("ParameterDeclarations").add(parameters),
            new Markup("CatalogLocations"),
            new Markup("RoadNetwork").add(road),
            entities,
            storyboard());
  }

  private Markup header() {
    return new Markup("FileHeader")
        .with("revMajor", "1")
        .with("revMinor", "3")
        .with("date", DATE)
        .with("description", EntityElements.text(scenario.title()))
        .with("author", "Eventchain")
        .add(properties());
  }

  /** Returns what else the scenario says, for readers. */
  private Markup properties() {
    Map<String, String> all = new LinkedHashMap<>();
    all.put("scenario", scenario.name());
    all.put("title", scenario.title());
    all.put("seed", Long.toString(scenario.seed()));
    all.put("description", scenario.description());
    all.put("requirements", String.join(" ", scenario.requirements()));
    new TreeMap<>(scenario.inputs()).forEach((name, it) -> all.put("input." + name, steps(it)));
    int number = 0;
    for (Expectation each : scenario.criteria()) {
      if (!each.isOfEveryScenario()) {
        number++;
        all.put("criterion." + number, each.text());
      }
    }
    Markup properties = new Markup("Properties");
    all.forEach(
        (name, value) -> {
          if (!value.isEmpty()) {
            properties.add(EntityElements.property(name, value));
          }
        });
    return properties;
  }

  private static String steps(Script script) {
    return script.steps().stream()
        .map(it -> Markup.number(World.seconds(it.time())) + ":" + Markup.number(it.value()))
        .collect(joining(" "));
  }

  private Markup storyboard() {
    Markup storyboard =
        new Markup("Storyboard").add(new Markup("Init").add(new Markup("Actions").add(beginnings)));
    if (!groups.isEmpty()) {
      List<List<Markup>> start = List.of(List.of(Triggers.since(0.0)));
      Markup act =
          new Markup("Act")
              .with("name", "act")
              .add(groups)
              .add(Triggers.trigger("StartTrigger", start, 0.0));
      storyboard.add(new Markup("Story").with("name", "story").add(act));
    }
    List<List<Markup>> ends = new ArrayList<>();
    ends.add(List.of(Triggers.since(scenario.duration())));
    situation
        .end()
        .map(Circumstance.class::cast)
        .ifPresent(it -> ends.addAll(triggers.groups(it, scenario.locationOfPart("/end_when"))));
    return storyboard.add(Triggers.trigger("StopTrigger", ends, 0.0));
  }

  private void mover(Mover mover) {
    Timeline timeline = new Timeline(mover, scenario.duration(), frame.road().isStraight());
    ScriptedEvents events = new ScriptedEvents(mover, frame, timeline);
    boolean crosses = !mover.followsTheRoad() && mover.moves() && timeline.trajectories().isEmpty();
    if (crosses && (mover.motion().waits() && !isPlainCrossing(mover))) {
      findings.accept(
          Diagnostic.of(
                  ExportRules.MANEUVER,
                  "It moves across the road, and to the side or in a bend besides, and not at fixed"
                      + " times. OpenSCENARIO has no action for that.",
                  scenario.locationOfPart(mover.pointer()))
              .withHint("Give its maneuvers times (at_s)."));
      return;
    }
    boolean varies = timeline.trajectories().isEmpty() && !crosses;
    String speed = mover.motion().speed().start() == 0.0 ? "0" : speed(mover, events, varies);
    Markup begin = new Markup("Private").with("entityRef", mover.entity());
    begin.add(teleport(mover.place().apply(0.0), mover, varies), ScriptedEvents.step(speed));
    if (crosses) {
      double length = Math.max(1.0, mover.motion().fastest() * scenario.duration());
      begin.add(Trajectory.straight(mover, mover.entity() + " course", length));
    }
    beginnings.add(begin);
    WaitingEvents waiting = new WaitingEvents(scenario, mover, timeline, triggers, findings);
    events.group(waiting.events()).ifPresent(groups::add);
  }

  /** Returns whether it only moves straight ahead on a straight road. */
  private boolean isPlainCrossing(Mover mover) {
    return frame.road().isStraight()
        && mover.motion().line().moves().isEmpty()
        && mover.motion().waiting().stream()
            .allMatch(it -> it.change() instanceof SpeedProfile.Change);
  }

  private String speed(Mover mover, ScriptedEvents events, boolean varies) {
    double speed = mover.motion().speed().start();
    double pace = events.paceAt(0.0);
    if (!varies) {
      return Markup.number(speed * pace);
    }
    String name = names.parameter(mover.entity(), "speed");
    parameter(name, speed);
    return pace == 1.0 ? "$" + name : "${$" + name + " * " + Markup.number(pace) + "}";
  }

  private void parameter(String name, double value) {
    parameters.add(
        new Markup("ParameterDeclaration")
            .with("name", name)
            .with("parameterType", "double")
            .with("value", value));
  }

  private Markup teleport(Road.Place place, Mover mover, boolean varies) {
    Road road = frame.road();
    Road.Station station = road.station(place.x(), place.y(), mover.gap());
    double heading =
        StrictMath.IEEEremainder(place.heading() - road.heading(station.along()), 2.0 * Math.PI);
    double s = frame.s(station.along());
    String text = Markup.number(s);
    if (varies && !mover.entity().equals(EntityNames.EGO)) {
      String name = names.parameter(mover.entity(), "gap");
      parameter(name, mover.gap());
      String scaled =
          frame.scale() == 1.0 ? "$" + name : "$" + name + " * " + Markup.number(frame.scale());
      text = "${" + scaled + " + " + Markup.number(s - mover.gap() * frame.scale()) + "}";
    }
    return new Markup("PrivateAction")
        .add(
            new Markup("TeleportAction")
                .add(RoadFrame.lanePosition(text, station.across(), heading)));
  }

  private void furniture(Actor actor) {
    double reach = Mover.reach(actor);
    Mover still = Mover.of(actor, names.of(actor.name()), "", frame.road());
    Road.Place place = actor.body(frame.road(), 0.0).place().ahead(-reach);
    beginnings.add(
        new Markup("Private").with("entityRef", still.entity()).add(teleport(place, still, false)));
  }
}
