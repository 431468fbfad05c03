package dev.eventchain.simulation.strength;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.fault.OutputFault.Change;
import dev.eventchain.simulation.fault.OutputFault.Range;
import dev.eventchain.simulation.run.OutputRecord;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;

/** Standard faults of the outputs of a component. */
final class StandardFaults {

  /** Delays, in ms. */
  private static final List<Double> DELAYS = List.of(100.0, 300.0, 1000.0);

  private static final double EVERY = 10;

  private final List<OutputRecord> records;
  private final List<OutputFault> faults = new ArrayList<>();

  private StandardFaults(List<OutputRecord> records) {
    this.records = records;
  }

  /**
   * Returns the faults: those of whole messages for each topic, then those of its fields.
   *
   * @param outputs the outputs of one component
   * @param records what was published without faults, in each scenario
   */
  static List<OutputFault> of(List<Output> outputs, List<OutputRecord> records) {
    StandardFaults all = new StandardFaults(records);
    Map<String, List<Output>> byTopic = new LinkedHashMap<>();
    outputs.forEach(
        each -> byTopic.computeIfAbsent(each.topic(), topic -> new ArrayList<>()).add(each));
    byTopic.values().forEach(all::topic);
    return List.copyOf(all.faults);
  }

  private void topic(List<Output> fields) {
    Output any = fields.get(0);
    message(any, Change.FIRST, 0);
    message(any, Change.DROPPED, 0);
    DELAYS.forEach(delay -> message(any, Change.DELAYED, delay));
    message(any, Change.HELD, EVERY);
    for (Output field : fields) {
      if (fields.size() > 1 && field.kind().isSingle()) {
        field(field, Change.FIRST, 0);
      }
      switch (field.kind()) {
        case TRUTH -> truth(field);
        case ENUMERATION -> stuck(field, field.safe(), field.most());
        case NUMBER, NUMBERS -> number(field);
        case OTHER -> {}
      }
    }
  }

  private void message(Output output, Change change, double amount) {
    faults.add(
        new OutputFault(
            output.node(),
            output.topic(),
            output.message().name(),
            "",
            change,
            amount,
            "",
            new Range(0, 0)));
  }

  private void truth(Output output) {
    stuck(output, 0, 1);
    field(output, Change.NEGATED, 0);
  }

  private void number(Output output) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (OutputRecord record : records) {
      OutputRecord.Values values = record.of(output.topic(), output.path());
      least = Math.min(least, values.least());
      most = Math.max(most, values.most());
    }
    if (least > most) {
      return;
    }
    stuck(output, output.safe(), most);
    Magnitude size = Magnitude.of(output.unit(), least, most);
    field(output, Change.INVERTED, 0);
    field(output, Change.SCALED, size.factor());
    field(output, Change.SCALED, 1 / size.factor());
    field(output, Change.SHIFTED, size.shift());
    field(output, Change.SHIFTED, -size.shift());
    field(output, Change.NOISY, size.shift());
  }

  private void stuck(Output output, double... values) {
    DoubleStream.of(values)
        .map(value -> value + 0.0) // not -0
        .distinct()
        .sorted()
        .forEach(value -> field(output, Change.STUCK, value));
  }

  private void field(Output output, Change change, double amount) {
    faults.add(
        new OutputFault(
            output.node(),
            output.topic(),
            output.message().name(),
            output.path(),
            change,
            amount,
            output.unit(),
            output.range()));
  }
}
