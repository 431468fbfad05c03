package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.storyboard.position.RoutePositions;
import dev.eventchain.openscenario.storyboard.position.Trajectory;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Box;
import dev.eventchain.openscenario.storyboard.world.Entity;
import dev.eventchain.openscenario.storyboard.world.Footprint;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Checks of a scenario with its roads: places that are not there, and entities at its begin. */
public final class PlaceCheck {

  private static final Set<String> ABSOLUTE =
      Set.of("LanePosition", "RoadPosition", "GeoPosition", "RoutePosition", "TrajectoryPosition");

  /** Things that vehicles drive on. */
  private static final Set<String> FLAT =
      Set.of("patch", "roadMark", "crosswalk", "parkingSpace", "none");

  private final Findings findings = new Findings();
  private final Scene scene;

  private PlaceCheck(Scene scene) {
    this.scene = scene;
  }

  /** Returns the findings about positions and trajectories that are not relative. */
  public static List<Diagnostic> places(ScenarioElement storyboard, Scene scene) {
    PlaceCheck check = new PlaceCheck(scene);
    check.checkPlaces(storyboard);
    return check.findings.sorted();
  }

  private void checkPlaces(ScenarioElement element) {
    boolean isPlace =
        element.children().size() == 1
            && ABSOLUTE.contains(element.children().get(0).name())
            && !isRelative(element);
    try {
      if (isPlace) {
        Positions.read(element).in(scene);
      } else if (element.name().equals("FollowTrajectoryAction") && !isRelative(element)) {
        Trajectory.of(element).in(scene);
      } else {
        element.children().forEach(this::checkPlaces);
      }
    } catch (DiagnosticException e) {
      findings.addAll(e.diagnostics());
    }
  }

  private static boolean isRelative(ScenarioElement element) {
    return Findings.within(element).anyMatch(each -> each.has("entityRef"));
  }

  /** Returns the findings about positions that the standard lets be on either side of a route. */
  public static List<Diagnostic> routeSides(ScenarioElement storyboard, Scene scene) {
    PlaceCheck check = new PlaceCheck(scene);
    Findings.within(storyboard)
        .filter(each -> each.name().equals("RoutePosition"))
        .filter(each -> RoutePositions.isTwofold(each, scene, isRelative(each)))
        .forEach(
            each ->
                check.findings.add(
                    StoryboardRules.ROUTE_SIDE,
                    each.location(),
                    "The route leads against its road here, and the standard does not say whether"
                        + " a lane or t counts as on the road: it is taken as one looks along the"
                        + " route.",
                    "Say which in a scenario: `openscenario: {file: ..., route_positions: road}` or"
                        + " `route`."));
    return check.findings.sorted();
  }

  /** Returns the findings about entities at the begin of a storyboard. */
  public static List<Diagnostic> begin(ScenarioElement storyboard, Scene scene, String ego) {
    PlaceCheck check = new PlaceCheck(scene);
    List<Actor> there = new ArrayList<>();
    for (Actor each : scene.actors()) {
      if (each.state().exists()) {
        there.forEach(other -> check.checkApart(other, each, ego));
        there.add(each);
      } else {
        check.checkPlaced(storyboard, each.entity(), ego);
      }
    }
    return check.findings.sorted();
  }

  private void checkPlaced(ScenarioElement storyboard, Entity entity, String ego) {
    String name = entity.name();
    boolean later =
        Findings.within(storyboard)
            .anyMatch(
                each ->
                    each.name().equals("EntityAction")
                        && scene.entities().named(each.text("entityRef")).contains(name)
                        && each.child("AddEntityAction").isPresent());
    if (!later || name.equals(ego)) {
      findings.add(
          StoryboardRules.UNPLACED,
          entity.written().location(),
          "'" + name + "' has no place when the storyboard begins.",
          "Give it a TeleportAction in Init, or leave it out.");
    }
  }

  private void checkApart(Actor first, Actor second, String ego) {
    boolean touch =
        isBody(first.entity())
            && isBody(second.entity())
            && areLevel(first, second)
            && footprint(first).touches(footprint(second));
    if (touch) {
      String names = first.entity().name() + "' and '" + second.entity().name();
      boolean ofEgo = first.entity().name().equals(ego) || second.entity().name().equals(ego);
      findings.addAll(
          List.of(
              Diagnostic.of(
                      StoryboardRules.OVERLAP,
                      "'" + names + "' are in the same place when the storyboard begins.",
                      second.entity().written().location())
                  .withHint("Place them apart in Init.")
                  .withRelated(first.entity().written().location())
                  .withSeverity(ofEgo ? Severity.ERROR : Severity.WARNING)));
    }
  }

  private static boolean isBody(Entity entity) {
    return entity.box().length() > 0
        && !(entity.kind().equals("miscellaneous") && FLAT.contains(entity.category()));
  }

  private static boolean areLevel(Actor first, Actor second) {
    Box one = first.entity().box();
    Box other = second.entity().box();
    double apart = first.state().pose().z() + one.z() - second.state().pose().z() - other.z();
    return Math.abs(apart) <= (one.height() + other.height()) / 2;
  }

  private static Footprint footprint(Actor actor) {
    return Footprint.of(actor.state().pose(), actor.entity().box());
  }
}
