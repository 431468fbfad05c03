package dev.eventchain.simulation;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/** What the road and the vehicle have to say, and what the vehicle is told. */
final class WorldSignals implements Signal.Source {

  private static final Map<String, Signal> SIGNALS = new TreeMap<>();

  static {
    // 0.0 - x and not -x, since nobody wants to read of an acceleration of -0.
    add("ego.speed", "m/s", ofStates(Trace.State::speed), WorldSignals::always);
    add("ego.acceleration", "m/s2", ofStates(s -> 0.0 - s.deceleration()), WorldSignals::always);
    add("gap", "m", ofStates(Trace.State::gap), WorldSignals::ahead);
    add("ttc", "s", ofStates(Trace.State::timeToCollision), WorldSignals::ahead);
    add("brake", "1", ofCommands(Trace.Command::pedal), WorldSignals::commanded);
    add("throttle", "1", ofCommands(Trace.Command::throttle), WorldSignals::commanded);
  }

  private static void add(
      String name,
      String unit,
      Function<Trace, double[]> samples,
      Function<Trace, Optional<String>> absence) {
    SIGNALS.put(name, new Signal(name, unit, samples, absence));
  }

  private static Function<Trace, double[]> ofStates(ToDoubleFunction<Trace.State> value) {
    return trace -> trace.states().stream().mapToDouble(value).toArray();
  }

  /** A command holds until the next one; before the first one the pedals are not pressed. */
  private static Function<Trace, double[]> ofCommands(ToDoubleFunction<Trace.Command> value) {
    return trace -> {
      List<Trace.State> states = trace.states();
      List<Trace.Command> commands = trace.commands();
      double[] samples = new double[states.size()];
      double inForce = 0.0;
      int next = 0;
      for (int i = 0; i < samples.length; i++) {
        while (next < commands.size() && commands.get(next).time() <= states.get(i).time()) {
          inForce = value.applyAsDouble(commands.get(next++));
        }
        samples[i] = inForce;
      }
      return samples;
    };
  }

  private static Optional<String> always(Trace trace) {
    return Optional.empty();
  }

  private static Optional<String> ahead(Trace trace) {
    return trace.minimalGap().isEmpty() ? Optional.of("nothing ahead") : Optional.empty();
  }

  private static Optional<String> commanded(Trace trace) {
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
}
