package dev.eventchain.simulation.formula;

import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.world.Trace;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A quantity that formulas may read.
 *
 * @param name how they name it
 * @param unit its unit, as it is written
 * @param truth whether it is true or false: 1 or 0
 * @param meaning what it is, for people
 * @param samples its values in coherent units, one for each state of the trace; NaN where it has
 *     none
 * @param absence why it says nothing in a trace, "nothing ahead"; empty if it says something
 * @param basis the signals that it is computed from; empty if it is computed from none
 */
public record Signal(
    String name,
    String unit,
    boolean truth,
    String meaning,
    Function<Trace, double[]> samples,
    Function<Trace, Optional<String>> absence,
    Set<Signal> basis) {

  /** Where formulas look names up. */
  public interface Source {

    /** The signal of a name, if there is one. */
    Optional<Signal> find(String name);

    /** Names for hints. */
    Collection<String> names();
  }

  /** A signal that is computed from no other. */
  public Signal(
      String name,
      String unit,
      boolean truth,
      String meaning,
      Function<Trace, double[]> samples,
      Function<Trace, Optional<String>> absence) {
    this(name, unit, truth, meaning, samples, absence, Set.of());
  }

  /** This one, and all that it is computed from. */
  public Stream<Signal> origins() {
    return Stream.concat(Stream.of(this), basis.stream().flatMap(Signal::origins));
  }

  /** The name of the topic that it is a field of; empty if it is of none. */
  public Optional<String> topic() {
    return name.startsWith("/") ? Optional.of(topicOf(name)) : Optional.empty();
  }

  /** The path of its field, if it is one of a topic. */
  public String field() {
    return name.substring(name.indexOf('.') + 1);
  }

  /** The name of the topic in the name of a topic's signal. */
  public static String topicOf(String signal) {
    int dot = signal.indexOf('.');
    return dot < 0 ? signal : signal.substring(0, dot);
  }

  /** A value of it in its own unit. */
  public double inUnit(double coherent) {
    double zero = dimension().coherent(0.0);
    return (coherent - zero) / (dimension().coherent(1.0) - zero);
  }

  /**
   * The values of samples that hold until the next one.
   *
   * @param before what holds before the first one
   * @return one for each state of a trace
   */
  public static double[] held(Trace trace, List<Trace.Sample> samples, double before) {
    double[] values = new double[trace.states().size()];
    double value = before;
    int next = 0;
    for (int i = 0; i < values.length; i++) {
      long time = trace.states().get(i).time();
      while (next < samples.size() && samples.get(next).time() <= time) {
        value = samples.get(next++).value();
      }
      values[i] = value;
    }
    return values;
  }

  public Unit dimension() {
    return Unit.parse(unit).orElseThrow();
  }
}
