package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.verdict.ScenarioVerdict.Line;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Mover;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Scan;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Scene;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Contact;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** Scene of a scenario from above. */
final class SceneFromAbove {

  /** Distance from the ego up to which the picture shows something, in m. */
  private static final double SHOWN = 80.0;

  private final Situation situation;
  private final Trace trace;
  private final List<Trace.State> states;

  private SceneFromAbove(Situation situation, Trace trace, List<Trace.State> states) {
    this.situation = situation;
    this.trace = trace;
    this.states = states;
  }

  /**
   * Creates the scene.
   *
   * @param states the displayed states of the trace
   */
  static Scene of(Situation situation, Trace trace, List<Trace.State> states) {
    SceneFromAbove above = new SceneFromAbove(situation, trace, states);
    return new Scene(
        situation.road().curvature(0.0),
        situation.road().laneWidth(0.0),
        situation.road().isFurnished() ? Road.WALL_DISTANCE : 0.0,
        above.lines(),
        above.ego(),
        trace.actors().stream()
            .filter(actor -> actor.size().bottom() < situation.ego().shape().height())
            .map(above::mover)
            .toList(),
        trace.outlines().stream().map(each -> new Scan(each.time(), each.x(), each.y())).toList());
  }

  /** Returns the lines around the way of the ego, as far as the picture shows them. */
  private List<Line> lines() {
    double last = states.stream().mapToDouble(Trace.State::position).max().orElse(0.0);
    return situation.road().lines(-SHOWN, last + SHOWN).stream()
        .map(
            line ->
                new Line(
                    line.broken(),
                    line.places().stream().map(Road.Place::x).toList(),
                    line.places().stream().map(Road.Place::y).toList()))
        .toList();
  }

  private Mover ego() {
    Shape shape = situation.ego().shape();
    List<Road.Place> places = new ArrayList<>();
    for (Trace.State state : states) {
      Road.Place road = situation.road().place(state.position(), state.pose().offset());
      places.add(
          new Road.Place(road.x(), road.y(), road.heading() + state.pose().heading())
              .ahead(-shape.length() / 2));
    }
    return mover("ego", shape.length(), shape.width(), places);
  }

  private Mover mover(Actor actor) {
    Optional<Long> gone =
        trace.fromBehind().stream()
            .filter(contact -> contact.other().name().equals(actor.name()))
            .map(Contact::time)
            .findFirst();
    List<Road.Place> places = new ArrayList<>();
    for (Trace.State state : states) {
      boolean there =
          actor.exists(World.seconds(state.time()))
              && (gone.isEmpty() || state.time() < gone.get());
      places.add(
          there
              ? actor.body(situation.road(), World.seconds(state.time())).place()
              : new Road.Place(Double.NaN, Double.NaN, Double.NaN));
    }
    return mover(actor.name(), actor.size().length(), actor.size().width(), places);
  }

  private static Mover mover(String name, double length, double width, List<Road.Place> places) {
    return new Mover(
        name,
        length,
        width,
        column(places, Road.Place::x),
        column(places, Road.Place::y),
        column(places, Road.Place::heading));
  }

  /** Returns a column, with a single value for a constant. */
  private static List<Double> column(List<Road.Place> places, ToDoubleFunction<Road.Place> value) {
    List<Double> values = places.stream().map(value::applyAsDouble).toList();
    boolean constant = values.stream().distinct().count() == 1;
    return constant ? values.subList(0, 1) : values;
  }
}
