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
    text(json, ChainNames.NAME, node.getName());
    text(json, ChainNames.DESCRIPTION, node.getDescription());
    if (node.isSetFrequency()) {
      json.put(ChainNames.FREQUENCY, node.getFrequency());
    }
    if (node.isSetBestCaseExecutionTime()) {
      json.put(ChainNames.BEST_CASE_EXECUTION_TIME, node.getBestCaseExecutionTime());
    }
    if (node.isSetWorstCaseExecutionTime()) {
      json.put(ChainNames.WORST_CASE_EXECUTION_TIME, node.getWorstCaseExecutionTime());
    }
    if (node.isSetMemory()) {
      json.put(ChainNames.MEMORY, node.getMemory());
    }
    synchronization(json, node);
    deployment(json, node);
    ArrayNode requirements = json.putArray(ChainNames.REQUIREMENTS);
    node.getSatisfies().stream().map(Requirement::getId).forEach(requirements::add);
    json.set(ChainNames.INPUT, ports(node.getInput()));
    json.set(ChainNames.OUTPUT, ports(node.getOutput()));
    return json;
  }

  private static void synchronization(ObjectNode json, SoftwareNode node) {
    if (!node.getSynchronized().isEmpty()) {
      ArrayNode topics = json.putArray(ChainNames.SYNCHRONIZED);
      node.getSynchronized().stream().map(Data::getTopicName).distinct().forEach(topics::add);
    }
    if (node.isSetTolerance()) {
      json.put(ChainNames.TOLERANCE, node.getTolerance());
    }
  }

  private static void deployment(ObjectNode json, SoftwareNode node) {
    if (node.getMappedTo() != null) {
      text(json, ChainNames.PROCESSOR, node.getMappedTo().getName());
    }
    if (node.isSetPriority()) {
      json.put(ChainNames.PRIORITY, node.getPriority());
    }
  }

  /** Returns the ports; adjacent data that agree in all that a port states share one. */
  private static ArrayNode ports(List<Data> all) {
    ArrayNode ports = JsonNodeFactory.instance.arrayNode();
    Data previous = null;
    ArrayNode values = null;
    for (Data data : all) {
      if (previous == null || !samePort(previous, data)) {
        ObjectNode port = ports.addObject();
        text(port, ChainNames.TOPIC, data.getTopicName());
        text(port, ChainNames.MESSAGE_TYPE, data.getMessageType());
        Optional.ofNullable(data.getQos())
            .ifPresent(qos -> port.set(ChainNames.QOS_PROFILE, qos(qos)));
        transport(data).ifPresent(it -> port.put(ChainNames.WORST_CASE_TRANSPORT_TIME, it));
        consumer(port, data);
        values = port.putArray(ChainNames.VALUES);
      }
      values.add(value(data));
      previous = data;
    }
    return ports;
  }

  private static Optional<Double> transport(Data data) {
    return data.isSetWorstCaseTransportTime()
        ? Optional.of(data.getWorstCaseTransportTime())
        : Optional.empty();
  }

  private static void consumer(ObjectNode port, Data data) {
    if (data.isExternal()) {
      port.put(ChainNames.CONSUMER, ChainNames.EXTERNAL);
    }
    if (!data.getSatisfies().isEmpty()) {
      ArrayNode requirements = port.putArray(ChainNames.REQUIREMENTS);
      data.getSatisfies().stream().map(Requirement::getId).forEach(requirements::add);
    }
  }

  private static boolean samePort(Data one, Data other) {
    return Objects.equals(one.getTopicName(), other.getTopicName())
        && Objects.equals(one.getMessageType(), other.getMessageType())
        && one.isExternal() == other.isExternal()
        && transport(one).equals(transport(other))
        && one.getSatisfies().equals(other.getSatisfies())
        && EcoreUtil.equals(one.getQos(), other.getQos());
  }

  private static ObjectNode value(Data data) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    text(json, ChainNames.NAME, data.getName());
    text(json, ChainNames.FIELD, data.getFieldName());
    text(json, ChainNames.TYPE, data.getType());
    text(json, ChainNames.UNIT, data.getUnit());
    text(json, ChainNames.COMPONENT_UNIT, data.getComponentUnit());
    if (data.isSetMaximumAge()) {
      json.put(ChainNames.MAXIMUM_AGE, data.getMaximumAge());
    }
    text(json, ChainNames.SAFE_VALUE, data.getSafeValue());
    text(json, ChainNames.DESCRIPTION, data.getDescription());
    return json;
  }

  /** Returns the quality of service; the name alone if no policy differs from the profile. */
  private static JsonNode qos(QosProfile qos) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    text(json, ChainNames.PROFILE, qos.getName());
    for (EStructuralFeature policy :
        EventchainPackage.Literals.QOS_PROFILE.getEStructuralFeatures()) {
      if (policy.isUnsettable() && qos.eIsSet(policy)) {
        json.putPOJO(ChainNames.of(policy).orElseThrow(), plain(qos.eGet(policy)));
      }
    }
    return json.size() == 1 && json.has(ChainNames.PROFILE) ? json.get(ChainNames.PROFILE) : json;
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
