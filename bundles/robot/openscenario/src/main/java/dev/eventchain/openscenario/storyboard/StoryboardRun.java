package dev.eventchain.openscenario.storyboard;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.check.PlaceCheck;
import dev.eventchain.openscenario.storyboard.check.StoryboardCheck;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Signals;
import dev.eventchain.openscenario.storyboard.tree.Change;
import dev.eventchain.openscenario.storyboard.tree.Log;
import dev.eventchain.openscenario.storyboard.tree.Tree;
import dev.eventchain.openscenario.storyboard.world.Collisions;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.Entities;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A run of a storyboard in steps of simulated time. The same scenario and the same steps give the
 * same run.
 *
 * <p>An entity keeps its speed and its lane, unless an action decides otherwise. Its speed is that
 * along its lane or its way; a motion across it adds to that. Actions that follow others see them
 * as they were at the beginning of the step.
 */
public final class StoryboardRun {

  private final Scene scene;
  private final Log log;
  private final Tree tree;
  private final String ego;

  private final List<Diagnostic> findings = new ArrayList<>();

  private StoryboardRun(
      ScenarioElement scenario,
      Map<String, String> parameters,
      RoadMap roads,
      String ego,
      Optional<RouteSides> routeSides) {
    this.ego = ego;
    report(StoryboardCheck.findings(scenario, parameters.keySet(), ego));
    scene =
        new Scene(
            Entities.of(scenario),
            roads,
            Signals.of(scenario),
            routeSides.orElse(RouteSides.USUAL));
    parameters.forEach(scene.parameters()::set);
    scenario.child("VariableDeclarations").stream()
        .flatMap(declarations -> declarations.children().stream())
        .forEach(each -> scene.variables().set(each.text("name"), each.text("value")));
    ScenarioElement storyboard = scenario.required("Storyboard");
    report(PlaceCheck.places(storyboard, scene));
    if (routeSides.isEmpty()) {
      report(PlaceCheck.routeSides(storyboard, scene));
    }
    log = new Log(scene);
    tree = new Tree(storyboard, log);
    new Init(storyboard, scene).run();
    tree.start();
    report(PlaceCheck.begin(storyboard, scene, ego));
  }

  /** Keeps warnings, and ends with errors. */
  private void report(List<Diagnostic> found) {
    findings.addAll(found);
    if (Diagnostic.anyError(found)) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, findings);
    }
  }

  /**
   * Starts a run: the actions of {@code Init} are done, and what is triggered at time 0 has
   * happened.
   *
   * @param scenario the root, with all parameters and catalogs replaced
   * @param parameters the values of its parameters
   * @param ego the entity that {@link #handOver} is about
   * @param routeSides which side positions on routes mean; empty: {@link RouteSides#USUAL}, with a
   *     warning about each that would be elsewhere otherwise
   * @throws dev.eventchain.diagnostics.DiagnosticException if the scenario cannot be played
   */
  public static StoryboardRun start(
      ScenarioElement scenario,
      Map<String, String> parameters,
      RoadMap roads,
      String ego,
      Optional<RouteSides> routeSides) {
    return new StoryboardRun(scenario, parameters, roads, ego, routeSides);
  }

  /** Returns what was found before the run and does not hinder it. */
  public List<Diagnostic> findings() {
    return List.copyOf(findings);
  }

  /** Returns the simulated time in s. */
  public double time() {
    return scene.time();
  }

  /** Returns the entities by name, in the order of the scenario. */
  public Entities entities() {
    return scene.entities();
  }

  /** Returns the states now, by name, in the order of the scenario; also of what is not there. */
  public Map<String, EntityState> states() {
    Map<String, EntityState> states = new LinkedHashMap<>();
    for (Actor each : scene.actors()) {
      states.put(each.entity().name(), each.state());
    }
    return states;
  }

  /**
   * Returns the states after a time if nothing is triggered in between. Changes nothing. The speed,
   * acceleration and curvature of the ego are what the scenario wants of it.
   */
  public Map<String, EntityState> next(double dt) {
    Map<String, EntityState> states = states();
    scene.next(dt).forEach((name, next) -> states.put(name, next.state()));
    return states;
  }

  /**
   * Moves all by a step, and lets happen what happens at its end.
   *
   * @param dt in s
   * @param seen where the ego really is then; empty if it is where the scenario has it
   * @param collisions which entities touch then
   * @throws dev.eventchain.diagnostics.DiagnosticException if an action refers to what is not there
   */
  public void advance(double dt, Optional<EntityState> seen, Collisions collisions) {
    Map<String, EntityState> moved = new LinkedHashMap<>();
    seen.ifPresent(each -> moved.put(ego, each));
    scene.advance(dt, moved, collisions);
    tree.settle();
  }

  /**
   * Hands the ego over to software. From then on no action changes its speed or its way; those that
   * run go on in time, and end, without an effect on it.
   *
   * @param domains what the software decides
   */
  public void handOver(Set<ControlDomain> domains) {
    scene.actor(ego).release(domains);
  }

  /** Returns whether the ego has to follow a line, such as a trajectory, and not its lane. */
  public boolean isOnLine() {
    return scene.actor(ego).lateral().isLine();
  }

  /** Returns whether the storyboard has a stop trigger. */
  public boolean hasStop() {
    return tree.hasStop();
  }

  /** Returns whether the stop trigger held, or all stories of one without a stop are complete. */
  public boolean ended() {
    return tree.ended();
  }

  /** Returns what happened in the storyboard so far, in its order. */
  public List<Change> changes() {
    return log.changes();
  }

  /** Returns the factor of the environment on the friction of the road. */
  public double friction() {
    return scene.surroundings().friction();
  }

  /** Returns the values of the variables. */
  public Map<String, String> variables() {
    return scene.variables().all();
  }
}
