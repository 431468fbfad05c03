package dev.eventchain.simulation.run;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.verdict.FieldSamples;
import dev.eventchain.simulation.verdict.FieldSamples.Form;
import dev.eventchain.simulation.verdict.FieldSamples.Sample;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The numbers, truth values and arrays that nodes read and write in a run, message by message.
 * Strings and single messages are left out.
 */
public final class MessageSamples {

  private final Map<String, Map<String, Field>> topics = new LinkedHashMap<>();

  private static final class Field {
    private final String unit;
    private Form form = Form.NUMBER;
    private final List<Sample> samples = new ArrayList<>();

    Field(String unit) {
      this.unit = unit;
    }
  }

  /** Creates samples of the fields that the nodes of a chain read and write. */
  public MessageSamples(SimulatedChain chain) {
    chain.data().forEach((topic, data) -> topics.put(topic, fields(data)));
  }

  private static Map<String, Field> fields(List<Data> data) {
    Map<String, Field> fields = new LinkedHashMap<>();
    data.stream()
        .filter(each -> each.getFieldName() != null)
        .sorted(Comparator.comparing(each -> unit(each).isEmpty()))
        .forEach(each -> fields.putIfAbsent(each.getFieldName(), new Field(unit(each))));
    return fields;
  }

  private static String unit(Data data) {
    return data.getUnit() == null ? "" : data.getUnit();
  }

  /** Adds a message that arrives at, or is published by a node, at a time in ns. */
  void add(String topic, long time, MessageValue message) {
    topics
        .getOrDefault(topic, Map.of())
        .forEach((path, field) -> add(field, World.seconds(time), message, path));
  }

  private static void add(Field field, double time, MessageValue message, String path) {
    Object value = message.get(path);
    if (value instanceof Boolean truth) {
      field.form = Form.TRUTH;
      field.samples.add(single(time, truth ? 1.0 : 0.0));
    } else if (value instanceof Number) {
      field.samples.add(single(time, message.number(path)));
    } else if (value instanceof Collection<?> elements) {
      field.form = Form.LIST;
      field.samples.add(counted(time, elements.size()));
    } else if (value instanceof byte[] bytes && isRaw(message, path)) {
      field.form = Form.LIST;
      field.samples.add(counted(time, bytes.length));
    } else if (value.getClass().isArray()) {
      field.form = Form.ARRAY;
      Extent extent = new Extent();
      message.forEachNumber(path, extent::add);
      field.samples.add(extent.at(time));
    }
  }

  private static Sample single(double time, double value) {
    return new Sample(time, value, value, Double.isFinite(value) ? 1 : 0, 1);
  }

  private static Sample counted(double time, int size) {
    return new Sample(time, Double.NaN, Double.NaN, 0, size);
  }

  /** Returns whether bytes are those of an image or a point cloud, and not signed numbers. */
  private static boolean isRaw(MessageValue message, String path) {
    return message.type().resolve(path).type().orElseThrow().kind() != FieldType.Kind.INT8;
  }

  /** Common properties of the elements of an array. */
  private static final class Extent {
    private double least = Double.POSITIVE_INFINITY;
    private double most = Double.NEGATIVE_INFINITY;
    private int finite;
    private int size;

    void add(double element) {
      size++;
      if (Double.isFinite(element)) {
        finite++;
        least = Math.min(least, element);
        most = Math.max(most, element);
      }
    }

    Sample at(double time) {
      boolean hasAny = finite > 0;
      return new Sample(
          time, hasAny ? least : Double.NaN, hasAny ? most : Double.NaN, finite, size);
    }
  }

  /** Returns the samples of each field that a message came for, in the order of the chain. */
  public List<FieldSamples> fields() {
    List<FieldSamples> all = new ArrayList<>();
    topics.forEach(
        (topic, fields) ->
            fields.forEach(
                (path, field) -> {
                  if (!field.samples.isEmpty()) {
                    all.add(new FieldSamples(topic, path, field.unit, field.form, field.samples));
                  }
                }));
    return all;
  }
}
