package dev.eventchain.description;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Writer that converts a model into an event-chain description for {@link EventChainReader}. */
public final class EventChainWriter {

  private EventChainWriter() {}

  /** Returns the description, pretty-printed with LF line ends and a final line break. */
  public static String write(EventChain chain) {
    ArrayNode components = JsonNodeFactory.instance.arrayNode();
    chain.getSoftware().forEach(node -> components.add(component(node)));
    return JsonLayout.of(components) + "\n";
  }

  private static ObjectNode component(SoftwareNode node) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    text(json, "name", node.getName());
    text(json, "description", node.getDescription());
    if (node.isSetFrequency()) {
      json.put("frequency", node.getFrequency());
    }
    if (node.isSetBestCaseExecutionTime()) {
      json.put("best_case_execution_time", node.getBestCaseExecutionTime());
    }
    if (node.isSetWorstCaseExecutionTime()) {
      json.put("worst_case_execution_time", node.getWorstCaseExecutionTime());
    }
    if (node.isSetMemory()) {
      json.put("memory", node.getMemory());
    }
    ArrayNode requirements = json.putArray("requirements");
    node.getSatisfies().stream().map(Requirement::getId).forEach(requirements::add);
    json.set("input", ports(node.getInput()));
    json.set("output", ports(node.getOutput()));
    return json;
  }

  /** Returns the ports; adjacent data with equal topic, type and quality of service share one. */
  private static ArrayNode ports(List<Data> all) {
    ArrayNode ports = JsonNodeFactory.instance.arrayNode();
    Data previous = null;
    ArrayNode values = null;
    for (Data data : all) {
      if (previous == null || !samePort(previous, data)) {
        ObjectNode port = ports.addObject();
        text(port, "topic", data.getTopicName());
        text(port, "message_type", data.getMessageType());
        Optional.ofNullable(data.getQos()).ifPresent(qos -> port.set("qos_profile", qos(qos)));
        consumer(port, data);
        values = port.putArray("values");
      }
      values.add(value(data));
      previous = data;
    }
    return ports;
  }

  private static void consumer(ObjectNode port, Data data) {
    if (data.isExternal()) {
      port.put("consumer", "external");
    }
    if (!data.getSatisfies().isEmpty()) {
      ArrayNode requirements = port.putArray("requirements");
      data.getSatisfies().stream().map(Requirement::getId).forEach(requirements::add);
    }
  }

  private static boolean samePort(Data one, Data other) {
    return Objects.equals(one.getTopicName(), other.getTopicName())
        && Objects.equals(one.getMessageType(), other.getMessageType())
        && one.isExternal() == other.isExternal()
        && one.getSatisfies().equals(other.getSatisfies())
        && EcoreUtil.equals(one.getQos(), other.getQos());
  }

  private static ObjectNode value(Data data) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    text(json, "name", data.getName());
    text(json, "field", data.getFieldName());
    text(json, "type", data.getType());
    text(json, "unit", data.getUnit());
    if (data.isSetMaximumAge()) {
      json.put("maximum_age", data.getMaximumAge());
    }
    text(json, "safe_value", data.getSafeValue());
    text(json, "description", data.getDescription());
    return json;
  }

  /** Returns the quality of service; the name alone if no policy differs from the profile. */
  private static JsonNode qos(QosProfile qos) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    text(json, "profile", qos.getName());
    for (EStructuralFeature policy :
        EventchainPackage.Literals.QOS_PROFILE.getEStructuralFeatures()) {
      if (policy.isUnsettable() && qos.eIsSet(policy)) {
        json.putPOJO(snakeCase(policy.getName()), plain(qos.eGet(policy)));
      }
    }
    return json.size() == 1 && json.has("profile") ? json.get("profile") : json;
  }

  private static String snakeCase(String feature) {
    return feature.replaceAll("(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
  }

  private static Object plain(Object value) {
    return value instanceof Number ? value : value.toString();
  }

  private static void text(ObjectNode json, String name, String value) {
    if (value != null) {
      json.put(name, value);
    }
  }
}
