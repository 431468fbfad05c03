package dev.eventchain.simulation.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Set;

/** Recording of a scenario: states at fixed intervals, and every command. */
public final class Trace {

  /**
   * State at a moment.
   *
   * @param time in ns
   * @param speed of the ego along its own axis, in m/s; negative backwards
   * @param gap to the nearest vehicle in the path, in m; infinite if there is none
   * @param timeToCollision in s, from the true distance and closing speed; infinite without an
   *     approach
   * @param deceleration of the ego, in m/s2
   * @param position of the ego's front bumper along the road since the start, in m
   * @param leadSpeed of the nearest vehicle in the path, in m/s; NaN if there is none
   * @param pose the pose of the ego in its lane
   */
  public record State(
      long time,
      double speed,
      double gap,
      double timeToCollision,
      double deceleration,
      double position,
      double leadSpeed,
      Pose pose) {}

  /**
   * Pose of the ego in its lane; all values are positive to the left.
   *
   * @param offset of the middle of the front bumper from the centre of the lane, in m
   * @param heading from the direction of the road, in rad
   * @param yawRate in rad/s
   */
  public record Pose(double offset, double heading, double yawRate) {

    /** Pose in the middle of the lane, straight ahead. */
    public static final Pose STRAIGHT = new Pose(0.0, 0.0, 0.0);
  }

  /** A command: its publication time, in ns, and its positions of the pedals. */
  public record Command(long time, double pedal, double throttle, double steering) {

    public boolean brakes() {
      return pedal > 0.0;
    }

    public boolean brakesFully() {
      return pedal >= FULL;
    }
  }

  /** Smallest pedal position that counts as full brake; float32 cannot always hold exactly 1. */
  public static final double FULL = 0.99;

  /** A value of a message, and its publication time, in ns. */
  public record Sample(long time, double value) {}

  /**
   * Nearest echoes of a scan, except those of the road.
   *
   * @param time since the start, in s
   */
  public record Outline(double time, List<Double> x, List<Double> y) {

    /** Copies the lists. */
    public Outline {
      x = List.copyOf(x);
      y = List.copyOf(y);
    }
  }

  private final Map<String, Script> inputs;
  private final Road road;
  private Shape shape = Shape.USUAL;
  private List<Actor> actors = List.of();
  private List<String> neverBegun = List.of();
  private List<Director.Happening> happenings = List.of();
  private final List<State> states = new ArrayList<>();
  private final Map<String, List<Sample>> samples = new HashMap<>();
  private final List<Command> commands = new ArrayList<>();
  private final List<Contact> fromBehind = new ArrayList<>();
  private final Map<String, Long> dropped = new HashMap<>();
  private final List<Outline> outlines = new ArrayList<>();
  private OptionalDouble impactSpeed = OptionalDouble.empty();
  private String impact = "";
  private String ignored = "";
  private final Map<String, Outside> outside = new LinkedHashMap<>();
  private boolean cut;
  private OptionalLong pedalsTaken = OptionalLong.empty();
  private OptionalLong wheelTaken = OptionalLong.empty();
  private final Set<String> hidden = new HashSet<>();

  /** Creates a trace without inputs. */
  public Trace() {
    this(Map.of(), Road.straight());
  }

  /**
   * Creates a trace.
   *
   * @param inputs scripts of the scenario, by the names of the bench's inputs
   */
  public Trace(Map<String, Script> inputs, Road road) {
    this.inputs = Map.copyOf(inputs);
    this.road = road;
  }

  /** Returns the road of the scenario. */
  public Road road() {
    return road;
  }

  /** Records the vehicle and the actors at the start. */
  void situation(Situation situation) {
    shape = situation.ego().shape();
    actors = situation.actors();
  }

  /** Returns the size of the ego. */
  public Shape shape() {
    return shape;
  }

  /** Records the actors as they have moved and will move, as far as that is known. */
  void actors(List<Actor> all) {
    actors = List.copyOf(all);
  }

  /** Returns the actors as they have moved. */
  public List<Actor> actors() {
    return actors;
  }

  /** Returns an actor as it has moved. */
  public Optional<Actor> actor(String name) {
    return actors.stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /** Records the maneuvers that should have begun before the end and did not, in words. */
  void neverBegun(List<String> maneuvers) {
    neverBegun = List.copyOf(maneuvers);
  }

  /** Returns the maneuvers that should have begun and did not, in words. */
  public List<String> neverBegun() {
    return neverBegun;
  }

  /** Records what a director has let happen up to now. */
  void happened(List<Director.Happening> all) {
    happenings = List.copyOf(all);
  }

  /** Returns what a director has let happen, in its order. */
  public List<Director.Happening> happenings() {
    return happenings;
  }

  /** Returns a trace of a single moment, with the last command before it. */
  Trace moment(State state) {
    Trace moment = new Trace(inputs, road);
    moment.shape = shape;
    moment.actors = actors;
    moment.happenings = happenings;
    moment.fromBehind.addAll(fromBehind);
    moment.state(state);
    if (!commands.isEmpty()) {
      moment.commands.add(commands.get(commands.size() - 1));
    }
    return moment;
  }

  /** Returns the script of an input of the bench; empty if the scenario has none for it. */
  public Optional<Script> input(String name) {
    return Optional.ofNullable(inputs.get(name));
  }

  /** Records the value of a field of a published message, by the name of its signal. */
  public void sample(String signal, long time, double value) {
    samples.computeIfAbsent(signal, name -> new ArrayList<>()).add(new Sample(time, value));
  }

  /** Returns a copy without the values of some signals of topics or commands. */
  public Trace without(Set<String> signals) {
    return without(signals, this);
  }

  /**
   * Returns a copy with the messages of another trace, without the values of some signals of topics
   * or commands.
   */
  public Trace without(Set<String> signals, Trace messages) {
    Trace other = new Trace(inputs, road);
    other.states.addAll(states);
    other.commands.addAll(commands);
    other.samples.putAll(messages.samples);
    other.samples.keySet().removeAll(signals);
    other.shape = shape;
    other.actors = actors;
    other.neverBegun = neverBegun;
    other.happenings = happenings;
    other.hidden.addAll(hidden);
    other.hidden.addAll(signals);
    other.impactSpeed = impactSpeed;
    other.impact = impact;
    other.cut = cut;
    other.fromBehind.addAll(fromBehind);
    return other;
  }

  /** Returns whether it was copied without the values of a signal. */
  public boolean isWithout(String signal) {
    return hidden.contains(signal);
  }

  /** Records that the run ended before its time: what would have come after it is unknown. */
  public void cutShort() {
    cut = true;
  }

  /** Returns whether the run ended before its time. */
  public boolean isCut() {
    return cut;
  }

  /** Records when the software first took the pedals or the wheel from the driver, in ns. */
  void taken(long time, boolean pedals, boolean wheel) {
    if (pedals && pedalsTaken.isEmpty()) {
      pedalsTaken = OptionalLong.of(time);
    }
    if (wheel && wheelTaken.isEmpty()) {
      wheelTaken = OptionalLong.of(time);
    }
  }

  /** Returns when the software took the pedals from the driver, in ns; empty if it did not. */
  public OptionalLong pedalsTaken() {
    return pedalsTaken;
  }

  /** Returns when the software took the wheel from the driver, in ns; empty if it did not. */
  public OptionalLong wheelTaken() {
    return wheelTaken;
  }

  /**
   * Ends the last value of a signal beyond its lifetime: the signal has no value from then on.
   *
   * @param lifetime lifetime of a value, in ns; 0 for unlimited
   */
  public void expire(String signal, long now, long lifetime) {
    List<Sample> known = samples(signal);
    if (lifetime == 0 || known.isEmpty()) {
      return;
    }
    Sample last = known.get(known.size() - 1);
    if (now - last.time() > lifetime && !Double.isNaN(last.value())) {
      known.add(new Sample(last.time() + lifetime, Double.NaN));
    }
  }

  /**
   * Returns the values of a signal in the order of time; NaN once it fell silent; empty if no
   * message came.
   */
  public List<Sample> samples(String signal) {
    return samples.getOrDefault(signal, List.of());
  }

  /**
   * Counts a message of a topic that was lost before it reached the nodes, as the bench defines.
   */
  public void drop(String topic) {
    dropped.merge(topic, 1L, Long::sum);
  }

  /** Returns the number of such losses of a topic. */
  public long dropped(String topic) {
    return dropped.getOrDefault(topic, 0L);
  }

  /** Records an outline of the lidar's view, for display. */
  public void outline(Outline outline) {
    outlines.add(outline);
  }

  public List<Outline> outlines() {
    return Collections.unmodifiableList(outlines);
  }

  public void state(State state) {
    states.add(state);
  }

  public void command(long time, VehicleCommand command) {
    commands.add(new Command(time, command.brake(), command.throttle(), command.steering()));
    if (ignored.isEmpty() && !command.ignored().isEmpty()) {
      ignored =
          String.format(Locale.ROOT, "%s after %.2f s", command.ignored(), World.seconds(time));
    }
  }

  /**
   * A value of a field that its signal never has.
   *
   * @param time in ns
   */
  public record Outside(String topic, String path, Object value, long time) {}

  /** Keeps such a value, if it is the first one of its field. */
  public void outside(Outside value) {
    outside.putIfAbsent(value.topic() + " " + value.path(), value);
  }

  /** Returns the first such value of each field. */
  public List<Outside> outside() {
    return List.copyOf(outside.values());
  }

  /** Returns the first command that the vehicle ignored, with its time; empty if there was none. */
  public String ignored() {
    return ignored;
  }

  /**
   * Records the impact, which ends the scenario.
   *
   * @param words the parties of the impact
   */
  public void impact(double speed, String words) {
    impactSpeed = OptionalDouble.of(speed);
    impact = words;
  }

  /** Records that an actor drove into the ego's rear. */
  void hitFromBehind(Contact contact) {
    fromBehind.add(contact);
  }

  /** Returns the parties of the impact; empty if there was none. */
  public String impact() {
    return impact;
  }

  /** Returns the rear impacts, in the order of time. */
  public List<Contact> fromBehind() {
    return Collections.unmodifiableList(fromBehind);
  }

  public List<State> states() {
    return Collections.unmodifiableList(states);
  }

  public List<Command> commands() {
    return Collections.unmodifiableList(commands);
  }

  /** Returns the last state. */
  public State end() {
    return states.get(states.size() - 1);
  }

  /** Returns the relative speed at the impact, in m/s. */
  public OptionalDouble impactSpeed() {
    return impactSpeed;
  }

  /** Returns the smallest gap to a vehicle in the path, in m; empty if there was none. */
  public OptionalDouble minimalGap() {
    return states.stream().mapToDouble(State::gap).filter(Double::isFinite).min();
  }

  public Optional<Command> firstBraking() {
    return commands.stream().filter(Command::brakes).findFirst();
  }

  /** Returns the last state that is not later than a time. */
  public State stateAt(long time) {
    int index = (int) Math.min(time / World.TRACE_STEP, states.size() - 1L);
    return states.get(index);
  }
}
