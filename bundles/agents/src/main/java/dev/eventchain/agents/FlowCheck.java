package dev.eventchain.agents;

import dev.eventchain.agents.ChainView.Component;
import dev.eventchain.agents.ChainView.Port;
import dev.eventchain.agents.ChainView.Value;
import dev.eventchain.agents.Signal.Direction;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Whether the data of a described chain flow: each topic, message type and field exists as a signal
 * or is new and set by a component of the chain, and both sides mean the same by it.
 */
final class FlowCheck {
  /** A component that writes a topic. */
  private record Producer(int position, Component component, Port port) {}

  private final ChainView chain;
  private final Map<String, Signal> signals;
  private final Findings findings;
  private final Map<String, Producer> producers = new LinkedHashMap<>();

  FlowCheck(ChainView chain, Map<String, Signal> signals, Findings findings) {
    this.chain = chain;
    this.signals = signals;
    this.findings = findings;
  }

  void check() {
    for (int i = 0; i < chain.components().size(); i++) {
      Component component = chain.components().get(i);
      component.ports().forEach(this::port);
      for (Port port : component.outputs()) {
        output(new Producer(i, component, port));
      }
    }
    for (int i = 0; i < chain.components().size(); i++) {
      for (Port port : chain.components().get(i).inputs()) {
        // A topic that is missing or no text is what the reader of descriptions reports.
        if (!port.topic().isEmpty()) {
          input(i, port);
        }
      }
    }
    chain.components().forEach(this::unused);
  }

  private void port(Port port) {
    Optional<String> type = MessageTypes.qualified(port.messageType());
    Signal signal = signals.get(port.topic());
    if (signal == null) {
      return;
    }
    if (type.isEmpty()) {
      return;
    }
    if (!type.get().equals(signal.messageType())) {
      findings.error(
          "agents.message.type",
          port.pointer() + "/message_type",
          "The messages of %s are %s, not %s."
              .formatted(port.topic(), signal.messageType(), port.messageType()),
          "");
    } else {
      port.values().forEach(value -> field(value, signal));
    }
  }

  private void field(Value value, Signal signal) {
    Optional<Signal.Field> field = signal.field(value.field());
    if (field.isEmpty()) {
      findings.error(
          "agents.field.unknown",
          value.pointer() + "/field",
          "The messages of %s have no field '%s'.".formatted(signal.topic(), value.field()),
          "The fields are " + String.join(", ", signal.fields().keySet()) + ".");
      return;
    }
    same("agents.field.type", "type", value, value.type(), field.get().type(), signal.topic());
    same("agents.unit.mismatch", "unit", value, value.unit(), field.get().unit(), signal.topic());
  }

  private void same(
      String id, String property, Value value, String here, String there, String topic) {
    if (!here.isEmpty() && !there.isEmpty() && !here.equals(there)) {
      findings.error(
          id,
          value.pointer() + "/" + property,
          "The %s of '%s' is given as '%s', but %s has '%s' there."
              .formatted(property, value.name(), here, topic, there),
          "Take the " + property + " of the signal, and convert inside of the component.");
    }
  }

  private void output(Producer producer) {
    Port port = producer.port();
    Signal signal = signals.get(port.topic());
    if (signal != null && signal.direction() == Direction.PROVIDED) {
      findings.error(
          "agents.topic.produced",
          port.pointer() + "/topic",
          "%s comes from the vehicle; no component may write it.".formatted(port.topic()),
          "Write another topic.");
    }
    Producer other = producers.putIfAbsent(port.topic(), producer);
    if (other != null) {
      findings.error(
          "agents.topic.produced",
          port.pointer() + "/topic",
          "%s is written by '%s' already.".formatted(port.topic(), other.component().name()),
          "One component writes a topic, with all fields that are needed.");
    }
  }

  private void input(int position, Port port) {
    Producer producer = producers.get(port.topic());
    Signal signal = signals.get(port.topic());
    if (producer != null) {
      fed(position, port, producer, signal == null);
    } else if (signal == null) {
      findings.error(
          "agents.topic.invented",
          port.pointer() + "/topic",
          "There is no signal %s, and no component of the chain writes it.".formatted(port.topic()),
          "Use an existing signal, or add the component that writes this one.");
    } else if (signal.direction() != Direction.PROVIDED) {
      findings.error(
          "agents.topic.unfed",
          port.pointer() + "/topic",
          "%s does not come from the vehicle, and no component of the chain writes it."
              .formatted(port.topic()),
          "Add the component that writes it, or use a signal of direction \"provided\".");
    }
  }

  private void fed(int position, Port port, Producer producer, boolean isNew) {
    if (isNew && !port.messageType().equals(producer.port().messageType())) {
      findings.error(
          "agents.message.type",
          port.pointer() + "/message_type",
          "'%s' writes %s to %s, not %s."
              .formatted(
                  producer.component().name(),
                  producer.port().messageType(),
                  port.topic(),
                  port.messageType()),
          "");
    }
    for (Value value : port.values()) {
      Optional<Value> source =
          producer.port().values().stream()
              .filter(v -> v.field().equals(value.field()))
              .findFirst();
      if (source.isEmpty()) {
        findings.error(
            "agents.field.unset",
            value.pointer() + "/field",
            "'%s' does not set the field '%s' of %s."
                .formatted(producer.component().name(), value.field(), port.topic()),
            "Read a field that is set, or set this one.");
      } else if (isNew) {
        Value set = source.get();
        same("agents.field.type", "type", value, value.type(), set.type(), port.topic());
        same("agents.unit.mismatch", "unit", value, value.unit(), set.unit(), port.topic());
      }
    }
    if (producer.position() > position) {
      findings.warning(
          "agents.order",
          port.pointer() + "/topic",
          "%s is written by '%s', which comes later in the chain."
              .formatted(port.topic(), producer.component().name()),
          "Put components into the order of the data flow, unless this is a feedback.");
    }
  }

  private void unused(Component component) {
    for (Port port : component.outputs()) {
      Signal signal = signals.get(port.topic());
      boolean wanted = signal != null && signal.direction() == Direction.CONSUMED;
      boolean read =
          chain.components().stream()
              .flatMap(other -> other.inputs().stream())
              .anyMatch(input -> input.topic().equals(port.topic()));
      if (!wanted && !read) {
        findings.warning(
            "agents.output.unused",
            port.pointer() + "/topic",
            "Nobody reads %s.".formatted(port.topic()),
            "Leave the output out, or the component if it is not needed.");
      }
    }
  }
}
