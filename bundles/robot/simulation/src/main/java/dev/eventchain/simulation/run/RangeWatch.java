package dev.eventchain.simulation.run;

import dev.eventchain.messages.MessageValue;
import dev.eventchain.model.Signal.Field;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.world.Trace;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Compares single numbers and texts in messages with the values that their signals have. */
final class RangeWatch {

  private final Bench bench;
  private final Map<String, List<Field>> fields = new HashMap<>();

  RangeWatch(Bench bench) {
    this.bench = bench;
  }

  /** Returns whether a field of a topic has certain values only. */
  boolean watches(String topic) {
    return !limited(topic).isEmpty();
  }

  /** Notes the values of a message that their signals never have. */
  void look(String topic, MessageValue message, long time, Trace trace) {
    for (Field field : limited(topic)) {
      if (message.type().resolve(field.path()).type().isPresent()) {
        Object value = message.get(field.path());
        if (!field.values().hold(value)) {
          trace.outside(new Trace.Outside(topic, field.path(), value, time));
        }
      }
    }
  }

  private List<Field> limited(String topic) {
    return fields.computeIfAbsent(topic, bench::limited);
  }
}
