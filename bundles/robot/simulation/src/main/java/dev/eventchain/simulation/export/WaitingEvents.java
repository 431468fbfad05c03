package dev.eventchain.simulation.export;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.scenario.Circumstance;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.Maneuver;
import dev.eventchain.simulation.world.Motion;
import dev.eventchain.simulation.world.SpeedProfile;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The maneuvers of one script that begin by themselves, as events: each one once the one before it
 * has begun and its own start has come.
 */
final class WaitingEvents {

  private final Scenario scenario;
  private final Mover mover;
  private final Timeline timeline;
  private final Triggers triggers;
  private final Consumer<Diagnostic> findings;
  private final boolean isStraight;
  private final List<Markup> events = new ArrayList<>();

  /** The name of the event before; null if the maneuver before has a fixed time. */
  private String previous;

  /** Delay of that event after its maneuver, in s. */
  private double previousLag;

  /** The speed and the offset that the maneuvers before lead to. */
  private double speed;

  private double offset;

  /** The speed before the last change of it. */
  private double former;

  /** The time before which the next maneuver does not begin, in s. */
  private double earliest;

  /** The time at which the last move to the side has ended if it began as early as it can, in s. */
  private double settled;

  /** The time at which the last change of the speed has ended likewise, in s. */
  private double steady;

  WaitingEvents(
      Scenario scenario,
      Mover mover,
      Timeline timeline,
      Triggers triggers,
      Consumer<Diagnostic> findings) {
    this.scenario = scenario;
    this.mover = mover;
    this.timeline = timeline;
    this.triggers = triggers;
    this.findings = findings;
    this.isStraight = scenario.situation().road().isStraight();
    Motion motion = mover.motion();
    List<SpeedProfile.Change> changes = motion.speed().changes();
    this.speed = motion.speed().start();
    for (SpeedProfile.Change change : changes) {
      double before = motion.speed().speed(change.time());
      steady = change.time() + Math.abs(change.speed() - before) / change.acceleration();
      former = before;
      speed = change.speed();
    }
    this.settled = motion.line().end();
    this.offset = motion.line().offset(settled);
    this.earliest = World.seconds(motion.latest());
  }

  /** Notes a change of the speed, which may begin while the one before it is on its way. */
  private void accelerate(SpeedProfile.Change change, double begin) {
    double most = Math.abs(change.speed() - speed);
    if (begin < steady) {
      most = Math.max(most, Math.abs(change.speed() - former));
    }
    steady = begin + most / change.acceleration();
    former = speed;
    speed = change.speed();
  }

  /** Returns the events, in their order; of no use if there was a finding. */
  List<Markup> events() {
    List<Maneuver> waiting = mover.motion().waiting();
    int first = mover.motion().speed().changes().size() + mover.motion().line().changes().size();
    for (int i = 0; i < waiting.size(); i++) {
      String pointer = mover.pointer() + "/maneuvers/" + (first + i);
      add(waiting.get(i), i + 1, scenario.locationOfPart(pointer));
    }
    return events;
  }

  private void add(Maneuver maneuver, int number, SourceLocation place) {
    double begin =
        maneuver.start() instanceof Maneuver.After after
            ? earliest + World.seconds(after.time())
            : earliest;
    if (timeline.trajectories().stream().anyMatch(span -> span.to() > begin)) {
      refuse(place, "It may begin while the way before it is still driven as a whole.");
      return;
    }
    if (maneuver.change() instanceof SpeedProfile.Change change) {
      add(maneuver, number, place, ScriptedEvents.speed(change, pace()), 0.0);
      accelerate(change, begin);
    } else {
      side(maneuver, number, place, begin);
    }
    earliest = begin;
  }

  private double pace() {
    return mover.followsTheRoad() ? 1.0 - scenario.situation().road().curvature(0.0) * offset : 1.0;
  }

  private void side(Maneuver maneuver, int number, SourceLocation place, double begin) {
    LateralProfile.Change change = (LateralProfile.Change) maneuver.change();
    LateralProfile.Move move = LateralProfile.Move.of(change.at(begin), offset);
    boolean moves = move.from() != move.to();
    if (moves && !Timeline.isHalfWaveAhead(mover, move, speed, isStraight)) {
      refuse(
          place,
          "Without a fixed time, only half a wave can be written, on a straight road, of a vehicle that"
              + " turns and is fast beside what it does to the side.");
    } else if (moves && begin < steady) {
      refuse(place, "It may begin while the speed changes.");
    } else if (moves && begin < settled) {
      refuse(place, "It may begin before the one to the side before it has ended.");
    } else {
      add(
          maneuver,
          number,
          place,
          ScriptedEvents.laneChange(move),
          moves && speed > 0.0 ? mover.reach() / speed : 0.0);
    }
    settled = moves ? move.end() : settled;
    offset = move.to();
  }

  private void refuse(SourceLocation place, String message) {
    findings.accept(
        Diagnostic.of(
                ExportRules.MANEUVER, message + " OpenSCENARIO has no action for that.", place)
            .withHint("Give it a time (at_s), or export the other scenarios (--scenario NAME)."));
  }

  private void add(Maneuver maneuver, int number, SourceLocation place, Markup action, double lag) {
    String name = mover.entity() + " maneuver " + number;
    if (maneuver.start() instanceof Maneuver.When when) {
      List<List<Markup>> groups =
          triggers.groups(
              (Circumstance) when.condition(), scenario.locationOfPart(place.element() + "/when"));
      events.add(ScriptedEvents.event(name, action, afterPrevious(groups), lag));
    } else {
      after(name, action, World.seconds(((Maneuver.After) maneuver.start()).time()), lag);
    }
    previous = name;
    previousLag = lag;
  }

  private void after(String name, Markup action, double seconds, double lag) {
    Optional<String> before = Optional.ofNullable(previous);
    Markup condition =
        before
            .map(event -> Triggers.state(event, "startTransition"))
            .orElseGet(
                () -> Triggers.since(World.seconds(mover.motion().latest()) + seconds + lag));
    double delay = before.isPresent() ? Math.max(0.0, seconds + lag - previousLag) : 0.0;
    events.add(ScriptedEvents.event(name, action, List.of(List.of(condition)), delay));
  }

  /** Returns groups that also ask whether the maneuver before has begun. */
  private List<List<Markup>> afterPrevious(List<List<Markup>> groups) {
    double latest = World.seconds(mover.motion().latest());
    if (previous == null) {
      return latest == 0.0 ? groups : with(Triggers.since(latest), groups);
    }
    List<List<Markup>> all =
        new ArrayList<>(with(Triggers.state(previous, "runningState"), groups));
    all.addAll(with(Triggers.state(previous, "completeState"), groups));
    return all;
  }

  private static List<List<Markup>> with(Markup first, List<List<Markup>> groups) {
    List<List<Markup>> all = new ArrayList<>();
    for (List<Markup> group : groups) {
      List<Markup> longer = new ArrayList<>(List.of(first));
      longer.addAll(group);
      all.add(longer);
    }
    return all;
  }
}
