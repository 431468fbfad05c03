package dev.eventchain.simulation;

import dev.eventchain.messages.Unit;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Function;

/**
 * A quantity that formulas may read.
 *
 * @param name how they name it
 * @param unit its unit, as it is written
 * @param samples its values in coherent units, one for each state of the trace
 * @param absence why it says nothing in a trace, "nothing ahead"; empty if it says something
 */
record Signal(
    String name,
    String unit,
    Function<Trace, double[]> samples,
    Function<Trace, Optional<String>> absence) {

  /** Where formulas look names up. */
  interface Source {

    /** The signal of a name, if there is one. */
    Optional<Signal> find(String name);

    /** Names for hints. */
    Collection<String> names();
  }

  /** A value of it in its own unit. */
  double inUnit(double coherent) {
    double zero = dimension().coherent(0.0);
    return (coherent - zero) / (dimension().coherent(1.0) - zero);
  }

  Unit dimension() {
    return Unit.parse(unit).orElseThrow();
  }
}
