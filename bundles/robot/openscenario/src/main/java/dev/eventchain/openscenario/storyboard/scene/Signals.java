package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.document.ScenarioElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The traffic signals, and the controllers that switch them. */
public final class Signals {

  /** A phase of a controller. */
  private record Phase(String name, double duration, Map<String, String> states) {}

  /** A controller. */
  private static final class Controller {
    private final List<Phase> phases = new ArrayList<>();
    private double start;

    Optional<Phase> phase(double time) {
      double cycle = phases.stream().mapToDouble(Phase::duration).sum();
      if (time < start || phases.isEmpty()) {
        return Optional.empty();
      }
      double rest = cycle > 0 ? (time - start) % cycle : 0;
      for (Phase each : phases) {
        // A nanosecond more, since sums of durations are not exact.
        if (rest + 1e-9 < each.duration() || cycle <= 0) {
          return Optional.of(each);
        }
        rest -= each.duration();
      }
      return Optional.of(phases.get(0));
    }

    double begin(String phase) {
      double begin = 0;
      for (Phase each : phases) {
        if (each.name().equals(phase)) {
          return begin;
        }
        begin += each.duration();
      }
      return 0;
    }
  }

  private final Map<String, Controller> controllers = new LinkedHashMap<>();
  private final Map<String, String> states = new LinkedHashMap<>();

  /** Reads them from a scenario. */
  public static Signals of(ScenarioElement scenario) {
    Signals result = new Signals();
    List<ScenarioElement> written =
        scenario
            .child("RoadNetwork")
            .flatMap(roads -> roads.child("TrafficSignals"))
            .map(signals -> signals.children("TrafficSignalController"))
            .orElse(List.of());
    for (ScenarioElement each : written) {
      Controller controller = new Controller();
      each.children("Phase").forEach(phase -> controller.phases.add(phase(phase)));
      result.controllers.put(each.text("name"), controller);
    }
    for (ScenarioElement each : written) {
      result.controllers.get(each.text("name")).start = delay(each, written, written.size());
    }
    return result;
  }

  /** Returns the delay with those of the controllers that one refers to. */
  private static double delay(ScenarioElement controller, List<ScenarioElement> all, int furthest) {
    double own = controller.number("delay", 0);
    Optional<ScenarioElement> reference =
        all.stream()
            .filter(each -> controller.optional("reference").equals(each.optional("name")))
            .findFirst();
    return reference.isPresent() && furthest > 0
        ? own + delay(reference.get(), all, furthest - 1)
        : own;
  }

  private static Phase phase(ScenarioElement phase) {
    Map<String, String> states = new LinkedHashMap<>();
    for (ScenarioElement each : phase.children("TrafficSignalState")) {
      states.put(each.text("trafficSignalId"), each.text("state"));
    }
    return new Phase(phase.text("name"), phase.number("duration"), states);
  }

  /** Returns whether there is a controller with a phase. */
  public boolean knows(String controller, String phase) {
    Controller found = controllers.get(controller);
    return found != null && found.phases.stream().anyMatch(each -> each.name().equals(phase));
  }

  /** Returns whether a controller is in a phase. */
  public boolean isIn(String controller, String phase, double time) {
    return controllers
        .get(controller)
        .phase(time)
        .filter(now -> now.name().equals(phase))
        .isPresent();
  }

  /** Puts a controller into a phase, from which it goes on. */
  public void enter(String controller, String phase, double time) {
    Controller found = controllers.get(controller);
    found.start = time - found.begin(phase);
  }

  /** Sets the state of a signal, which no controller changes from then on. */
  public void set(String signal, String state) {
    states.put(signal, state);
  }

  /** Returns the state of a signal; empty if nothing says it. */
  public Optional<String> state(String signal, double time) {
    String set = states.get(signal);
    if (set != null) {
      return Optional.of(set);
    }
    for (Controller each : controllers.values()) {
      Optional<String> state = each.phase(time).map(phase -> phase.states().get(signal));
      if (state.isPresent()) {
        return state;
      }
    }
    return Optional.empty();
  }
}
