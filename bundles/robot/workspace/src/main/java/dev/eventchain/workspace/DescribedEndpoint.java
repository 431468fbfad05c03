package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.messages.QosSettings;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** A port of a component: an endpoint with the fields that it uses, once for each topic. */
record DescribedEndpoint(
    boolean isOutput,
    String topic,
    String type,
    Optional<QosSettings> qos,
    Set<MessageFields.Leaf> fields) {

  /** Adds an endpoint, or its fields to the one of the same topic and type. */
  static void add(
      FoundEndpoint endpoint, List<MessageFields.Leaf> fields, List<DescribedEndpoint> all) {
    for (DescribedEndpoint other : all) {
      if (other.isOutput == endpoint.isPublisher()
          && other.topic.equals(endpoint.topic())
          && other.type.equals(endpoint.type())) {
        other.fields.addAll(fields);
        return;
      }
    }
    all.add(
        new DescribedEndpoint(
            endpoint.isPublisher(),
            endpoint.topic(),
            endpoint.type(),
            endpoint.qos(),
            new LinkedHashSet<>(fields)));
  }

  /** Returns the port without its values. */
  ObjectNode port() {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put(ChainNames.TOPIC, topic).put(ChainNames.MESSAGE_TYPE, type);
    qos.ifPresent(settings -> json.set(ChainNames.QOS_PROFILE, qos(settings)));
    return json;
  }

  /** Returns quality of service as a profile's name, a depth, or the policies that differ. */
  static JsonNode qos(QosSettings settings) {
    for (String name : List.of("default", "sensor_data", "system_default", "best_available")) {
      if (QosSettings.named(name).filter(settings::equals).isPresent()) {
        return JsonNodeFactory.instance.textNode(name);
      }
    }
    QosSettings plain = QosSettings.defaults();
    if (settings.equals(plain.withDepth(settings.depth())) && settings.depth() > 0) {
      return JsonNodeFactory.instance.numberNode(settings.depth());
    }
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    put(json, ChainNames.RELIABILITY, settings.reliability(), plain.reliability());
    put(json, ChainNames.DURABILITY, settings.durability(), plain.durability());
    put(json, ChainNames.HISTORY, settings.history(), plain.history());
    put(json, ChainNames.LIVELINESS, settings.liveliness(), plain.liveliness());
    json.put(ChainNames.DEPTH, settings.depth());
    settings.deadline().ifPresent(time -> json.put(ChainNames.DEADLINE, time.toNanos() / 1e6));
    settings.lease().ifPresent(time -> json.put(ChainNames.LEASE_DURATION, time.toNanos() / 1e6));
    return json;
  }

  private static <E extends Enum<E>> void put(ObjectNode json, String name, E value, E plain) {
    if (value != plain) {
      json.put(name, value.name());
    }
  }
}
