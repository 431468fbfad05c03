package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Trace;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;

/** Signals of the road, the vehicle and its commands. */
public final class WorldSignals implements Signal.Source {

  /** Radius of the earth at the equator in m, as in WGS 84 and in CARLA's {@code GeoLocation}. */
  private static final double EARTH_RADIUS = 6_378_137.0;

  private static final Map<String, Signal> SIGNALS = new LinkedHashMap<>();

  static {
    add(
        "ego.position",
        "m",
        "how far along the road the front bumper is",
        ofStates(Trace.State::position));
    add("ego.speed", "m/s", "speed along its own axis", ofStates(Trace.State::speed));
    // 0.0 - x instead of -x, to avoid an acceleration of -0
    add("ego.acceleration", "m/s2", "negative in braking", ofStates(s -> 0.0 - s.deceleration()));
    add("ego.offset", "m", "front bumper left of the lane's centre", ofPose(Trace.Pose::offset));
    add("ego.heading", "rad", "to the left of the road", ofPose(Trace.Pose::heading));
    add("ego.yaw_rate", "rad/s", "to the left", ofPose(Trace.Pose::yawRate));
    addOnMap("ego.x", "m", "front bumper on the map", (state, place) -> place.x());
    addOnMap("ego.y", "m", "front bumper on the map", (state, place) -> place.y());
    addOnMap("ego.yaw", "rad", "on the map, to the left", (state, place) -> place.heading());
    addOnMap(
        "ego.orientation.z",
        "1",
        "yaw as quaternion, z",
        (state, place) -> StrictMath.sin(place.heading() / 2));
    addOnMap(
        "ego.orientation.w",
        "1",
        "yaw as quaternion, w",
        (state, place) -> StrictMath.cos(place.heading() / 2));
    addOnMap(
        "ego.acceleration.x",
        "m/s2",
        "on the map, that of turning included",
        (state, place) -> turned(0.0 - state.deceleration(), 0.0 - aside(state), place.heading()));
    addOnMap(
        "ego.acceleration.y",
        "m/s2",
        "on the map, that of turning included",
        (state, place) -> turned(aside(state), 0.0 - state.deceleration(), place.heading()));
    add(
        "ego.acceleration.left",
        "m/s2",
        "across its own axis, by turning",
        ofStates(WorldSignals::aside));
    addOnMap(
        "ego.latitude",
        "deg",
        "front bumper, by the Mercator projection of CARLA",
        (state, place) -> latitude(place.y()));
    addOnMap(
        "ego.longitude",
        "deg",
        "front bumper, by the Mercator projection of CARLA",
        (state, place) -> StrictMath.toDegrees(place.x() / EARTH_RADIUS));
    addLane("lane.left", "m", "front bumper's middle to the left line", Road::toTheLeft);
    addLane("lane.right", "m", "front bumper's middle to the right line", Road::toTheRight);
    addLane("lane.width", "m", "from line to line", (road, at) -> road.laneWidth(at.along()));
    addLane(
        "lane.curvature",
        "1/m",
        "of the road, to the left",
        (road, at) -> road.curvature(at.along()));
    addTruth("lead.present", "whether a vehicle is in the path", s -> Double.isFinite(s.gap()));
    addAhead("gap", "m", "bumper to bumper", Trace.State::gap);
    addAhead("lead.speed", "m/s", "speed of the nearest in the path", Trace.State::leadSpeed);
    addAhead("ttc", "s", "true time to collision", Trace.State::timeToCollision);
    addCommand("brake", "last brake command, 0 to 1", Trace.Command::pedal);
    addCommand("throttle", "last throttle command, 0 to 1", Trace.Command::throttle);
    addCommand("steering", "last steering command, -1 (left) to 1", Trace.Command::steering);
  }

  private static void add(
      String name, String unit, String meaning, Function<Trace, double[]> samples) {
    Function<Trace, Optional<String>> never = trace -> Optional.empty();
    SIGNALS.put(name, new Signal(name, unit, false, meaning, samples, never));
  }

  private static void addTruth(String name, String meaning, Predicate<Trace.State> value) {
    Function<Trace, Optional<String>> never = trace -> Optional.empty();
    SIGNALS.put(
        name,
        new Signal(name, "1", true, meaning, ofStates(s -> value.test(s) ? 1.0 : 0.0), never));
  }

  private static void addAhead(
      String name, String unit, String meaning, ToDoubleFunction<Trace.State> value) {
    SIGNALS.put(
        name, new Signal(name, unit, false, meaning, ofStates(value), WorldSignals::nothingAhead));
  }

  private static void addLane(
      String name, String unit, String meaning, ToDoubleBiFunction<Road, Road.Station> value) {
    add(
        name,
        unit,
        meaning,
        trace ->
            trace.states().stream()
                .mapToDouble(state -> value.applyAsDouble(trace.road(), station(state)))
                .toArray());
  }

  private static Road.Station station(Trace.State state) {
    return new Road.Station(state.position(), state.pose().offset());
  }

  /**
   * Adds a signal of the pose on the map, which at the start has the road along its x axis. The yaw
   * is from -pi to pi.
   */
  private static void addOnMap(
      String name, String unit, String meaning, ToDoubleBiFunction<Trace.State, Road.Place> value) {
    add(
        name,
        unit,
        meaning,
        trace ->
            trace.states().stream()
                .mapToDouble(state -> value.applyAsDouble(state, onMap(trace.road(), state)))
                .toArray());
  }

  private static Road.Place onMap(Road road, Trace.State state) {
    Road.Place place = road.place(state.position(), state.pose().offset());
    double yaw = StrictMath.IEEEremainder(place.heading() + state.pose().heading(), 2.0 * Math.PI);
    return new Road.Place(place.x(), place.y(), yaw);
  }

  /**
   * Returns the latitude in degrees of a way to the north from the equator, by the inverse of the
   * Mercator projection on a sphere. The origin of the map is at 0° N, 0° E, as in CARLA's towns.
   */
  private static double latitude(double north) {
    return StrictMath.toDegrees(
        2 * StrictMath.atan(StrictMath.exp(north / EARTH_RADIUS)) - Math.PI / 2);
  }

  /** Returns the acceleration to the left that turning takes. */
  private static double aside(Trace.State state) {
    return state.speed() * state.pose().yawRate();
  }

  /** Returns {@code own} along an axis and {@code other} across it, both turned by an angle. */
  private static double turned(double own, double other, double angle) {
    return own * StrictMath.cos(angle) + other * StrictMath.sin(angle);
  }

  private static void addCommand(
      String name, String meaning, ToDoubleFunction<Trace.Command> value) {
    SIGNALS.put(
        name,
        new Signal(name, "1", false, meaning, ofCommands(name, value), WorldSignals::noCommand));
  }

  private static Function<Trace, double[]> ofStates(ToDoubleFunction<Trace.State> value) {
    return trace -> trace.states().stream().mapToDouble(value).toArray();
  }

  private static Function<Trace, double[]> ofPose(ToDoubleFunction<Trace.Pose> value) {
    return ofStates(state -> value.applyAsDouble(state.pose()));
  }

  /**
   * Returns values of commands, which hold until the next one; before the first one they are 0, and
   * in a trace without the signal there are none.
   */
  private static Function<Trace, double[]> ofCommands(
      String name, ToDoubleFunction<Trace.Command> value) {
    return trace ->
        trace.isWithout(name)
            ? Signal.held(trace, List.of(), Double.NaN)
            : Signal.held(
                trace,
                trace.commands().stream()
                    .map(each -> new Trace.Sample(each.time(), value.applyAsDouble(each)))
                    .toList(),
                0.0);
  }

  private static Optional<String> nothingAhead(Trace trace) {
    return trace.minimalGap().isEmpty() ? Optional.of("nothing ahead") : Optional.empty();
  }

  private static Optional<String> noCommand(Trace trace) {
    return trace.commands().isEmpty() ? Optional.of("no command came") : Optional.empty();
  }

  @Override
  public Optional<Signal> find(String name) {
    return Optional.ofNullable(SIGNALS.get(name));
  }

  @Override
  public Collection<String> names() {
    return SIGNALS.keySet();
  }

  /** Returns whether a signal is one of the world, and not an input. */
  public static boolean isKnown(String name) {
    return SIGNALS.containsKey(name);
  }

  /** Returns all signals, in the order for display. */
  public static List<Signal> all() {
    return List.copyOf(SIGNALS.values());
  }
}
