package dev.eventchain.simulation.measure;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.Signal;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.world.Trace.Outside;
import dev.eventchain.simulation.world.World;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Findings on values that the signals of the vehicle never have, as their catalogue says. */
public final class ValueRanges {

  /** The first such value of a field. */
  private record First(String scenario, Outside value) {}

  private final SimulatedChain chain;

  private ValueRanges(SimulatedChain chain) {
    this.chain = chain;
  }

  /** Returns a finding for each field with such a value, with the first one of all scenarios. */
  public static List<Diagnostic> in(List<ScenarioRun> runs, SimulatedChain chain) {
    Map<String, First> fields = new LinkedHashMap<>();
    for (ScenarioRun run : runs) {
      for (Outside value : run.trace().outside()) {
        fields.putIfAbsent(
            value.topic() + " " + value.path(), new First(run.scenario().name(), value));
      }
    }
    ValueRanges ranges = new ValueRanges(chain);
    return fields.values().stream().map(ranges::finding).toList();
  }

  private Diagnostic finding(First first) {
    Outside value = first.value();
    boolean written = chain.topicsWritten().contains(value.topic());
    String message =
        String.format(
            Locale.ROOT,
            "Scenario %s: %s '%s' as '%s' of %s after %.2f s, but its signal %s.",
            first.scenario(),
            written ? "the software wrote" : "the simulated vehicle sent",
            Printable.line(String.valueOf(value.value())),
            value.path(),
            value.topic(),
            World.seconds(value.time()),
            values(value));
    return written
        ? Diagnostic.of(
                MeasureRules.OUTPUT_RANGE,
                message,
                SourceLocation.NONE.withElement(chain.writer(value.topic())))
            .withHint("Limit the output in the component, or correct the catalogue.")
        : Diagnostic.of(MeasureRules.INPUT_RANGE, message, provided(value))
            .withHint("Limit the quantity in bench.yaml or the scenario, or its noise.");
  }

  private SourceLocation provided(Outside value) {
    Bench.Provided provided = chain.bench().provided().get(value.topic());
    return provided.fields().stream()
        .filter(field -> field.path().equals(value.path()))
        .map(Bench.Field::location)
        .findFirst()
        .orElse(provided.location());
  }

  /** Returns the values that the signal has, in words. */
  private String values(Outside value) {
    Signal.Field field =
        chain.bench().limited(value.topic()).stream()
            .filter(each -> each.path().equals(value.path()))
            .findFirst()
            .orElseThrow();
    Signal.Values values = field.values();
    if (value.value() instanceof String) {
      return "is one of " + Printable.line(String.join(", ", values.texts()));
    }
    String from = values.least().isPresent() ? " from " + number(values.least().orElse(0)) : "";
    String to = values.most().isPresent() ? " to " + number(values.most().orElse(0)) : "";
    String unit = field.unit().isEmpty() ? "" : " " + Printable.line(field.unit());
    return "goes" + (from.isEmpty() ? " up" : from) + (to.isEmpty() ? " upwards" : to) + unit;
  }

  private static String number(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(MathContext.DECIMAL32).stripTrailingZeros().toPlainString()
        : String.valueOf(value);
  }
}
