package dev.eventchain.simulation.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.document.ResolvedScenario;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.StoryboardRun;
import dev.eventchain.openscenario.storyboard.world.Box;
import dev.eventchain.openscenario.storyboard.world.Entity;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import dev.eventchain.roads.LanePath;
import dev.eventchain.roads.LanePosition;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Chassis;
import dev.eventchain.simulation.world.Director;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.HumanDriver;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.SpeedProfile;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Requisites of a scenario: its storyboard, its roads, and the ego at the start.
 *
 * <p>The world has its origin where the ego's front bumper is at the start, in the middle of its
 * lane, and its x axis along that lane.
 */
final class Stage {

  /** Distance for which the ego's lane is followed, in m. */
  private static final double AHEAD = 20_000.0;

  private static final double BEHIND = 1_000.0;

  private final ResolvedScenario scenario;
  private final RoadMap roads;
  private final Optional<RouteSides> routeSides;
  private final Entity ego;
  private final EntityState start;
  private final Road road;
  private final Frame frame;
  private final Road.Place front;
  private final List<Actor> standing;
  private final boolean stops;
  private final List<Diagnostic> findings;
  private final double friction;

  /**
   * Sets the stage.
   *
   * @param network empty if the scenario has no roads
   * @param ego the name of an entity with a body
   * @param routeSides which side positions on routes mean, if somebody says it
   * @throws dev.eventchain.diagnostics.DiagnosticException if it cannot be played
   */
  Stage(
      ResolvedScenario scenario,
      Optional<RoadNetwork> network,
      RoadMap roads,
      String ego,
      Optional<RouteSides> routeSides) {
    this.routeSides = routeSides;
    this.scenario = scenario;
    this.roads = roads;
    StoryboardRun run =
        StoryboardRun.start(scenario.root(), scenario.parameters(), roads, ego, routeSides);
    this.ego = run.entities().find(ego).orElseThrow();
    this.start = run.states().get(ego);
    this.stops = run.hasStop();
    this.friction = run.friction();
    this.findings = run.findings();
    Pose bumper = start.pose().moved(this.ego.box().front(), this.ego.box().y());
    Optional<LanePath> path = network.flatMap(this::path);
    if (path.isPresent()) {
      LanePath lane = path.get();
      double along = lane.station(bumper.x(), bumper.y(), lane.origin()).along();
      dev.eventchain.roads.road.Pose origin = lane.pose(along, 0.0);
      this.frame = new Frame(origin.x(), origin.y(), origin.heading());
      this.road =
          FurnishedRoad.of(network.get(), lane, along)
              .orElseGet(() -> new EgoLane(network.get(), lane, along, frame));
    } else {
      this.frame = new Frame(bumper.x(), bumper.y(), bumper.heading());
      this.road = new OpenPlane();
    }
    this.front = frame.toWorld(bumper);
    Set<String> names = run.entities().objects().keySet();
    this.standing = network.map(it -> standing(it, names)).orElse(List.of());
  }

  /** Returns what stands at a road without furniture of its own. */
  private List<Actor> standing(RoadNetwork network, Set<String> names) {
    return road.isFurnished() ? List.of() : new RoadFurniture(network, frame, road, names).actors();
  }

  private Optional<LanePath> path(RoadNetwork network) {
    Optional<LanePoint> at = start.road();
    return at.flatMap(
        point -> {
          LanePosition lane = new LanePosition(point.road(), point.lane(), point.s(), 0.0);
          double direction =
              network.road(point.road()).orElseThrow().heading(point.s()) - start.pose().heading();
          return network.path(lane, StrictMath.cos(direction) >= 0.0, BEHIND, AHEAD);
        });
  }

  /** Returns what was found in the storyboard, which does not keep it from being played. */
  List<Diagnostic> findings() {
    return findings;
  }

  /** Returns whether a trigger stops the storyboard. */
  boolean stops() {
    return stops;
  }

  /** Returns the location of the trigger that stops the storyboard, or else of the storyboard. */
  SourceLocation end() {
    ScenarioElement storyboard = scenario.root().required("Storyboard");
    return storyboard.child("StopTrigger").filter(it -> stops).orElse(storyboard).location();
  }

  /** Returns the vehicle of a project with the body and the speed that the scenario gives it. */
  EgoVehicle vehicle(EgoVehicle usual) {
    Box box = ego.box();
    double wheelbase = Math.min(wheelbase(usual), box.front());
    Chassis chassis =
        new Chassis(
            wheelbase,
            usual.chassis().maximalSteeringAngle(),
            usual.chassis().handBrakeDeceleration(),
            usual.chassis().drag(),
            front.y(),
            StrictMath.IEEEremainder(front.heading(), 2.0 * Math.PI),
            usual.chassis().maximalYawRate());
    return new EgoVehicle(
        Math.max(0.0, start.speed()),
        usual.brakeDelay(),
        usual.brakeBuildUp(),
        usual.maximalDeceleration() * Math.min(1.0, friction),
        usual.coastingDeceleration(),
        usual.maximalAcceleration(),
        usual.lidar(),
        chassis,
        new Shape(box.length(), box.width(), box.z() + box.height() / 2, box.front() - wheelbase),
        usual.speedStep(),
        usual.commandTimeout());
  }

  /** Returns the distance of the axles, which a vehicle of the scenario says itself. */
  private double wheelbase(EgoVehicle usual) {
    return ego.written()
        .child("Vehicle")
        .flatMap(vehicle -> vehicle.child("Axles"))
        .flatMap(axles -> axles.child("FrontAxle"))
        .map(axle -> axle.number("positionX"))
        .filter(position -> position > 0.0)
        .orElse(usual.chassis().wheelbase());
  }

  /**
   * Returns the situation at the start.
   *
   * @param limit when the storyboard has to be at its end; empty if it need not
   */
  Situation situation(EgoVehicle vehicle, Optional<StoryboardDirector.Limit> limit) {
    Director.Source source = new Play(this, vehicle.shape(), limit);
    HumanDriver driver =
        new HumanDriver(
            new SpeedProfile(vehicle.speed(), List.of()),
            new LateralProfile(vehicle.chassis().offset(), List.of()),
            true);
    return new Situation(
        vehicle, driver, road, source.begin().actors(), Optional.empty(), Optional.of(source));
  }

  /** Plays the storyboard from its begin. */
  private record Play(Stage stage, Shape shape, Optional<StoryboardDirector.Limit> limit)
      implements Director.Source {

    @Override
    public Director begin() {
      String name = stage.ego.name();
      StoryboardRun run =
          StoryboardRun.start(
              stage.scenario.root(),
              stage.scenario.parameters(),
              stage.roads,
              name,
              stage.routeSides);
      return new StoryboardDirector(
          run, stage.frame, stage.road, name, shape, stage.standing, limit);
    }

    @Override
    public List<String> events() {
      List<String> names = new ArrayList<>();
      addEvents(stage.scenario.root().required("Storyboard"), names);
      return names.stream().distinct().toList();
    }

    private static void addEvents(ScenarioElement element, List<String> names) {
      if (element.name().equals("Event")) {
        names.add(element.text("name"));
      }
      element.children().forEach(child -> addEvents(child, names));
    }
  }
}
