package dev.eventchain.agents.component;

import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Port;
import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Values at the limits that the vehicle's signals state for the inputs of a component: the least
 * and the greatest number, their neighbours on both sides, and all texts of an enumeration.
 */
final class SignalLimits {

  private final Map<String, List<Object>> byInput = new HashMap<>();

  private SignalLimits() {}

  /** Returns the limits of a component's inputs, in the units of messages. */
  static SignalLimits of(Component component, List<Signal> signals) {
    SignalLimits limits = new SignalLimits();
    for (Port port : component.inputs()) {
      for (Value value : port.values()) {
        values(port, value, signals)
            .map(stated -> limits(stated, value.fieldType()))
            .ifPresent(found -> limits.byInput.putIfAbsent(value.name(), found));
      }
    }
    return limits;
  }

  /** Returns the values of an input; empty if its signal states no limits. */
  List<Object> of(Value input) {
    return byInput.getOrDefault(input.name(), List.of());
  }

  private static Optional<Signal.Values> values(Port port, Value value, List<Signal> signals) {
    String topic = RosNames.resolve(port.topic(), "");
    return signals.stream()
        .filter(signal -> RosNames.resolve(signal.topic(), "").equals(topic))
        .flatMap(signal -> signal.fields().stream())
        .filter(field -> field.path().equals(value.field()))
        .map(Signal.Field::values)
        .findFirst();
  }

  private static List<Object> limits(Signal.Values stated, String type) {
    List<Object> limits = new ArrayList<>();
    if (type.equals("string")) {
      limits.addAll(stated.texts());
    } else if (type.matches(FieldType.NUMBER)) {
      limits.addAll(around(stated.least(), type));
      limits.addAll(around(stated.most(), type));
    }
    return limits;
  }

  /** Returns a limit between its neighbours, as far as the type has them. */
  private static List<Object> around(OptionalDouble limit, String type) {
    if (limit.isEmpty()) {
      return List.of();
    }
    double at = limit.getAsDouble();
    if (type.equals("float32") || type.equals("float")) {
      float nearest = (float) at;
      return List.of(
          (double) Math.nextDown(nearest), (double) nearest, (double) Math.nextUp(nearest));
    }
    if (type.equals("float64") || type.equals("double")) {
      return List.of(Math.nextDown(at), at, Math.nextUp(at));
    }
    List<Object> whole = new ArrayList<>();
    for (long number = Math.round(at) - 1; number <= Math.round(at) + 1; number++) {
      if (ProbeValue.isInteger(number, type)) {
        whole.add(number);
      }
    }
    return whole;
  }
}
