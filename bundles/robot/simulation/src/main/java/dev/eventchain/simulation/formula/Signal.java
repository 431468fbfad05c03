package dev.eventchain.simulation.formula;

import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.world.Trace;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A quantity that formulas may read.
 *
 * @param name its name in formulas
 * @param unit its unit, as written
 * @param truth true if it is Boolean: 1 or 0
 * @param meaning its description, for users
 * @param samples its values in coherent units, one for each state of the trace; NaN for no value
 * @param absence why it has no values in a trace, such as "nothing ahead"; empty if it has some
 * @param basis the signals that it is computed from; may be empty
 * @param range all its values, from those of other signals
 * @param named the names of its values
 */
public record Signal(
    String name,
    String unit,
    boolean truth,
    String meaning,
    Function<Trace, double[]> samples,
    Function<Trace, Optional<String>> absence,
    Set<Signal> basis,
    Function<Range.Source, Range> range,
    NamedValues named) {

  /** Lookup of signals by name. */
  public interface Source {

    /** Returns the signal of a name, if there is one. */
    Optional<Signal> find(String name);

    /** Returns the known names, for hints. */
    Collection<String> names();

    /** Returns what to say of a topic that is not known, with a blank before it. */
    default String aboutTopics() {
      return " Topics are known if signals.json or bench.yaml describes them.";
    }

    /** Returns whether outputs of the software can be read here at all. */
    default boolean readsOutputs() {
      return true;
    }

    /**
     * Returns the outputs of the software that satisfy a requirement.
     *
     * @param kind {@code bool} or a unit of the wanted dimension; empty for any output
     * @return empty as long as it is not known which outputs the software has
     */
    default Optional<List<Signal>> outputs(String requirement, Optional<String> kind) {
      return Optional.empty();
    }
  }

  /** Creates a signal whose values have no names. */
  public Signal(
      String name,
      String unit,
      boolean truth,
      String meaning,
      Function<Trace, double[]> samples,
      Function<Trace, Optional<String>> absence,
      Set<Signal> basis,
      Function<Range.Source, Range> range) {
    this(name, unit, truth, meaning, samples, absence, basis, range, NamedValues.NONE);
  }

  /** Creates a signal that is not computed from others. */
  public Signal(
      String name,
      String unit,
      boolean truth,
      String meaning,
      Function<Trace, double[]> samples,
      Function<Trace, Optional<String>> absence) {
    this(
        name,
        unit,
        truth,
        meaning,
        samples,
        absence,
        Set.of(),
        ranges -> truth ? Range.upTo(1.0) : ranges.apply(name));
  }

  /** Returns this signal with names of its values. */
  public Signal withNames(NamedValues names) {
    return new Signal(name, unit, truth, meaning, samples, absence, basis, range, names);
  }

  /** Returns this signal and all signals that it is computed from. */
  public Stream<Signal> origins() {
    return Stream.concat(Stream.of(this), basis.stream().flatMap(Signal::origins));
  }

  /** Returns the name of its topic; empty if it is no field of a topic. */
  public Optional<String> topic() {
    return name.startsWith("/") ? Optional.of(topicOf(name)) : Optional.empty();
  }

  /** Returns the path of its field, if it is a field of a topic. */
  public String field() {
    return name.substring(name.indexOf('.') + 1);
  }

  /** Returns the topic in the name of a topic's signal. */
  public static String topicOf(String signal) {
    int dot = signal.indexOf('.');
    return dot < 0 ? signal : signal.substring(0, dot);
  }

  /** Returns in words which values it can have; empty if nothing is known. */
  String values(Range known) {
    boolean open = Double.isInfinite(known.least());
    boolean endless = Double.isInfinite(known.most());
    if (open && endless) {
      return "";
    }
    String least = rounded(known.least());
    String most = rounded(known.most());
    String values =
        open
            ? "at most " + most
            : endless
                ? "at least " + least
                : least.equals(most) ? "always " + least : "from " + least + " to " + most;
    return "In this scenario, "
        + name
        + " is "
        + values
        + (unit.equals("1") ? "." : " " + unit + ".");
  }

  private String rounded(double coherent) {
    BigDecimal value = BigDecimal.valueOf(inUnit(Double.isInfinite(coherent) ? 0.0 : coherent));
    BigDecimal hundredths = value.setScale(2, RoundingMode.HALF_EVEN);
    return hundredths.signum() == 0 ? "0" : hundredths.stripTrailingZeros().toPlainString();
  }

  /** Converts a coherent value into its own unit. */
  public double inUnit(double coherent) {
    double zero = dimension().coherent(0.0);
    return (coherent - zero) / (dimension().coherent(1.0) - zero);
  }

  /**
   * Returns the values of samples that hold until the next one.
   *
   * @param before the value before the first sample
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
