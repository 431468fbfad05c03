package dev.eventchain.simulation.formula;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Contact;
import dev.eventchain.simulation.world.Director;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;

/**
 * Signals of the actors of one scenario, such as {@code actor('walker').gap}, besides those of
 * another source. An actor that drove into the ego's rear has no values from then on.
 */
public final class ActorSignals implements Signal.Source {

  private static final String STARTED = "started";
  private static final String ENDED = "ended";

  /** Hint where no actor can be read. */
  static final String NONE_KNOWN =
      "Actors are known in the formulas of a scenario, by the names that it gives them.";

  /** A quantity of an actor. */
  private enum Part {
    GAP(
        "gap",
        "m",
        "from the ego's front bumper along the road to the end of it that comes first; behind the ego, that is the far one") {
      @Override
      double of(Actor actor, Trace.State state, Trace trace) {
        return actor.rear(seconds(state)) - state.position();
      }
    },
    DISTANCE("distance", "m", "from the ego's body to its body, in any direction") {
      @Override
      double of(Actor actor, Trace.State state, Trace trace) {
        Road.Place front = trace.road().place(state.position(), state.pose().offset());
        double heading = front.heading() + state.pose().heading();
        Body ego = trace.shape().body(new Road.Place(front.x(), front.y(), heading));
        return ego.distance(actor.body(trace.road(), seconds(state)));
      }
    },
    TTC("ttc", "s", "gap by the closing speed, wherever it is across the road") {
      @Override
      double of(Actor actor, Trace.State state, Trace trace) {
        double gap = GAP.of(actor, state, trace);
        double closing = state.speed() - actor.speedAlong(seconds(state));
        boolean approaches = closing > 0.0 && gap > -2 * actor.reach(seconds(state));
        return approaches ? Math.max(0.0, gap) / closing : Double.POSITIVE_INFINITY;
      }
    },
    SPEED("speed", "m/s", "along the road, negative towards the ego") {
      @Override
      double of(Actor actor, Trace.State state, Trace trace) {
        return actor.speedAlong(seconds(state));
      }
    },
    OFFSET("offset", "m", "its middle left of the centre of the ego's lane") {
      @Override
      double of(Actor actor, Trace.State state, Trace trace) {
        return actor.across(seconds(state));
      }
    };

    private final String word;
    private final String unit;
    private final String meaning;

    Part(String word, String unit, String meaning) {
      this.word = word;
      this.unit = unit;
      this.meaning = meaning;
    }

    /** Returns its value in a state of the world. */
    abstract double of(Actor actor, Trace.State state, Trace trace);

    /** Returns the signals of the ego that it depends on. */
    Set<Signal> basis(WorldSignals world) {
      List<String> names =
          switch (this) {
            case GAP -> List.of("ego.position");
            case TTC -> List.of("ego.position", "ego.speed");
            case DISTANCE -> List.of("ego.position", "ego.offset", "ego.heading");
            case SPEED, OFFSET -> List.of();
          };
      return Set.copyOf(names.stream().map(name -> world.find(name).orElseThrow()).toList());
    }

    Range range() {
      return this == DISTANCE || this == TTC ? Range.upTo(Double.POSITIVE_INFINITY) : Range.ALL;
    }

    static double seconds(Trace.State state) {
      return World.seconds(state.time());
    }
  }

  private final Signal.Source others;
  private final Map<String, Signal> signals = new LinkedHashMap<>();

  /**
   * Adds the signals of a scenario's actors and events, by their names, to others.
   *
   * @param events those of a storyboard; none of other scenarios
   */
  public ActorSignals(Signal.Source others, Collection<String> actors, Collection<String> events) {
    this.others = others;
    for (String event : events) {
      add(happening(event, STARTED, "whether it has begun"));
      add(happening(event, ENDED, "whether it has ended"));
    }
    WorldSignals world = new WorldSignals();
    for (String actor : actors) {
      for (Part part : Part.values()) {
        add(signal(actor, part, world));
      }
    }
  }

  private void add(Signal signal) {
    signals.put(signal.name(), signal);
  }

  private static Signal happening(String event, String part, String meaning) {
    return new Signal(
        name("event", event, part),
        "1",
        true,
        meaning,
        trace -> samples(event, part.equals(STARTED), trace),
        trace -> Optional.empty());
  }

  /** Returns 1 from the first time on at which an event begins or ends. */
  private static double[] samples(String event, boolean begins, Trace trace) {
    long first =
        trace.happenings().stream()
            .filter(each -> each.event().equals(event) && each.begins() == begins)
            .mapToLong(Director.Happening::time)
            .findFirst()
            .orElse(Long.MAX_VALUE);
    return trace.states().stream()
        .mapToDouble(state -> state.time() >= first ? 1.0 : 0.0)
        .toArray();
  }

  private static Signal signal(String actor, Part part, WorldSignals world) {
    return new Signal(
        name(actor, part.word),
        part.unit,
        false,
        part.meaning,
        trace -> samples(actor, part, trace),
        trace -> Optional.empty(),
        part.basis(world),
        ranges -> part.range());
  }

  private static double[] samples(String name, Part part, Trace trace) {
    Actor actor = trace.actor(name).orElseThrow();
    long gone =
        trace.fromBehind().stream()
            .filter(contact -> contact.other().name().equals(name))
            .mapToLong(Contact::time)
            .min()
            .orElse(Long.MAX_VALUE);
    return trace.states().stream()
        .mapToDouble(
            state ->
                state.time() < gone && actor.exists(World.seconds(state.time()))
                    ? part.of(actor, state, trace)
                    : Double.NaN)
        .toArray();
  }

  private static String name(String actor, String part) {
    return name("actor", actor, part);
  }

  private static String name(String of, String name, String part) {
    String quote = name.contains("'") ? "\"" : "'";
    return of + "(" + quote + name + quote + ")." + part;
  }

  /** Returns the name of a signal as this source knows it, whatever its blanks and quotes. */
  static String named(String text) {
    return reading(text).map(it -> name(it.of(), it.name(), it.quantity())).orElse(text);
  }

  /**
   * A quantity of one actor or event.
   *
   * @param of {@code actor} or {@code event}
   * @param name its name
   * @param quantity such as {@code gap}
   */
  public record Reading(String of, String name, String quantity) {}

  /** Returns what a signal reads of an actor or an event; empty if it is no signal of one. */
  public static Optional<Reading> reading(String signal) {
    Matcher actor = FormulaTokens.ACTOR.matcher(signal);
    if (!actor.matches()) {
      return Optional.empty();
    }
    String name = actor.group("name") != null ? actor.group("name") : actor.group("other");
    return Optional.of(new Reading(actor.group("of"), name, actor.group("part")));
  }

  /** Returns whether a signal is one of an actor. */
  static boolean isOne(String name) {
    return FormulaTokens.ACTOR.matcher(name).matches();
  }

  /** A quantity of every actor, for documentation. */
  public record Quantity(String name, String unit, String meaning) {}

  /** Returns the quantities of an actor, in the order for display. */
  public static List<Quantity> quantities() {
    return List.of(Part.values()).stream()
        .map(part -> new Quantity(name("NAME", part.word), part.unit, part.meaning))
        .toList();
  }

  @Override
  public Optional<Signal> find(String name) {
    return Optional.ofNullable(signals.get(name)).or(() -> others.find(name));
  }

  @Override
  public Collection<String> names() {
    List<String> names = new ArrayList<>(others.names());
    names.addAll(signals.keySet());
    return names;
  }

  @Override
  public boolean readsOutputs() {
    return others.readsOutputs();
  }

  @Override
  public String aboutTopics() {
    return others.aboutTopics();
  }

  @Override
  public Optional<List<Signal>> outputs(String requirement, Optional<String> kind) {
    return others.outputs(requirement, kind);
  }
}
