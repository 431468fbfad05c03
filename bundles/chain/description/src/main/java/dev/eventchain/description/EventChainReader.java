package dev.eventchain.description;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.jsonmodels.InstanceRules;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.jsonmodels.Names;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Processors;
import dev.eventchain.model.PythonNames;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.Processor;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.Origins;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Reader that converts an event-chain description directly into a model. The description is the
 * JSON array of the paper's Appendix A, or the object around it of {@link EventChainSchema}.
 * Optional additions are:
 *
 * <ul>
 *   <li>of components {@code frequency} (Hz), {@code requirements} (ids), {@code
 *       worst_case_execution_time} and {@code best_case_execution_time} (ms), {@code memory} (MiB),
 *       {@code synchronized} topics with a {@code tolerance} (ms), and a {@code processor} with a
 *       {@code priority};
 *   <li>of ports {@code worst_case_transport_time} (ms), and of outputs that leave the chain {@code
 *       consumer} ("external") and {@code requirements};
 *   <li>of values {@code type}, {@code unit}, {@code component_unit}, {@code maximum_age} (ms) and
 *       {@code safe_value}.
 * </ul>
 *
 * <p>Each element's origin is its JSON pointer in the description, so that later findings in the
 * model point back to it.
 */
public final class EventChainReader {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  private static final NumberRange NOT_NEGATIVE = NumberRange.atLeast(0);

  private static final NumberRange PRIORITIES =
      NumberRange.of(Integer.MIN_VALUE, Integer.MAX_VALUE);

  /** Features of values that their port states. */
  private static final Set<EStructuralFeature> OF_PORTS =
      Set.of(
          Literals.DATA__TOPIC_NAME,
          Literals.DATA__MESSAGE_TYPE,
          Literals.DATA__QOS,
          Literals.DATA__WORST_CASE_TRANSPORT_TIME);

  private final Document text;
  private final Origins origins = new Origins();
  private final List<Diagnostic> diagnostics = new ArrayList<>();
  private final EventChain chain = FACTORY.createEventChain();
  private final Map<String, Requirement> requirements = new LinkedHashMap<>();
  private final OptionalDouble defaultFrequency;
  private boolean requirementsKnown = true;

  private EventChainReader(Document description, OptionalDouble defaultFrequency) {
    this.text = description;
    this.defaultFrequency = defaultFrequency;
  }

  /**
   * Reads a description.
   *
   * @param name the chain's name
   * @param written the requirements that the description may name
   * @param defaultFrequency Hz, for components whose description gives none; empty leaves it unset
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if the description is not JSON
   */
  public static Modeled<EventChain> read(
      SourceText description,
      String name,
      List<WrittenRequirement> written,
      OptionalDouble defaultFrequency) {
    EventChainReader reader =
        new EventChainReader(JsonDocument.parse(description), defaultFrequency);
    reader.chain.setName(name);
    written.forEach(reader::addRequirement);
    reader.readComponents();
    return reader.result();
  }

  /** Reads the components of a software base as an event chain without requirements. */
  public static Modeled<EventChain> readExisting(Document components) {
    EventChainReader reader = new EventChainReader(components, OptionalDouble.empty());
    reader.requirementsKnown = false;
    reader.read(components.objects(reader.diagnostics::add));
    return reader.result();
  }

  private Modeled<EventChain> result() {
    return new Modeled<>(chain, origins, diagnostics.stream().sorted().toList());
  }

  private void addRequirement(WrittenRequirement item) {
    Requirement requirement = FACTORY.createRequirement();
    requirement.setId(item.id());
    requirement.setText(item.text());
    chain.getRequirements().add(requirement);
    requirements.put(item.id(), requirement);
    origins.put(requirement, item.location());
  }

  private void readComponents() {
    read(EventChainSchema.objects(text, diagnostics::add));
    JsonNode components = EventChainSchema.components(text.root());
    if (components.isArray() && components.isEmpty()) {
      find(DescriptionRules.CHAIN_EMPTY, "The description contains no component.", text.at(""));
    }
    linkNextSteps();
  }

  private void read(List<ObjectReader> components) {
    origins.put(chain, text.at(""));
    components.forEach(this::readComponent);
    refuseDuplicates(chain.getSoftware());
  }

  private void readComponent(ObjectReader json) {
    SoftwareNode node = FACTORY.createSoftwareNode();
    chain.getSoftware().add(node);
    origins.put(node, json.location());
    origins.putFeatures(node, feature -> ChainNames.of(feature).map(json::at));
    node.setName(name(json, "component"));
    json.text(ChainNames.DESCRIPTION).ifPresent(node::setDescription);
    OptionalDouble frequency = json.number(ChainNames.FREQUENCY, NumberRange.above(0));
    if (frequency.isPresent() || json.value(ChainNames.FREQUENCY).isEmpty()) {
      frequency = frequency.isPresent() ? frequency : defaultFrequency;
      frequency.ifPresent(node::setFrequency);
    }
    json.number(ChainNames.BEST_CASE_EXECUTION_TIME, NOT_NEGATIVE)
        .ifPresent(node::setBestCaseExecutionTime);
    json.number(ChainNames.WORST_CASE_EXECUTION_TIME, NOT_NEGATIVE)
        .ifPresent(node::setWorstCaseExecutionTime);
    json.number(ChainNames.MEMORY, NOT_NEGATIVE).ifPresent(node::setMemory);
    json.value(ChainNames.IMPLEMENTATION);
    json.value(ChainNames.FILE);
    json.value(ChainNames.NODE);
    node.getSatisfies().addAll(readRequirements(json));
    readPorts(json, ChainNames.INPUT, node.getInput(), port -> value -> {});
    readPorts(json, ChainNames.OUTPUT, node.getOutput(), this::readConsumer);
    SynchronizationReader.read(json, text, node);
    readDeployment(json, node);
    json.refuseOthers();
  }

  private void readDeployment(ObjectReader json, SoftwareNode node) {
    String name = json.has(ChainNames.PROCESSOR) ? json.requiredText(ChainNames.PROCESSOR) : "";
    if (!name.isBlank()) {
      int known = chain.getProcessors().size();
      Processor processor = Processors.map(node, name, chain);
      if (chain.getProcessors().size() > known) {
        origins.put(processor, json.at(ChainNames.PROCESSOR));
      }
    }
    json.wholeNumber(ChainNames.PRIORITY, PRIORITIES)
        .ifPresent(priority -> node.setPriority((int) priority));
  }

  private List<Requirement> readRequirements(ObjectReader json) {
    List<Requirement> found = new ArrayList<>();
    List<String> ids = json.texts(ChainNames.REQUIREMENTS);
    for (int i = 0; i < ids.size(); i++) {
      Requirement requirement = requirements.get(ids.get(i));
      if (requirement == null && requirementsKnown) {
        diagnostics.add(
            Diagnostic.of(
                    InstanceRules.REFERENCE_UNRESOLVED,
                    "There is no requirement '" + ids.get(i) + "'.",
                    text.at(Document.below(json.pointerTo(ChainNames.REQUIREMENTS), i)))
                .withHint(NearestName.hint(ids.get(i), requirements.keySet())));
      } else if (requirement != null) {
        found.add(requirement);
      }
    }
    return found;
  }

  private void readPorts(
      ObjectReader json,
      String side,
      List<Data> data,
      Function<ObjectReader, Consumer<Data>> more) {
    Set<String> names = new HashSet<>();
    json.objects(side).forEach(port -> readPort(port, names, data, more));
  }

  /** Reads whether an output leaves the chain, and the requirements that ask for it. */
  private Consumer<Data> readConsumer(ObjectReader port) {
    Optional<String> consumer = port.text(ChainNames.CONSUMER);
    if (consumer.isPresent() && !consumer.get().equals(ChainNames.EXTERNAL)) {
      port.find(
          Diagnostic.of(
                  DescriptionRules.CONSUMER_UNKNOWN,
                  "'" + Names.printable(consumer.get()) + "' is not a consumer.",
                  port.at(ChainNames.CONSUMER))
              .withHint(
                  "Write \"external\" for an output that leaves the chain; leave it out"
                      + " otherwise."));
    }
    List<Requirement> asking = readRequirements(port);
    return value -> {
      value.setExternal(consumer.isPresent());
      value.getSatisfies().addAll(asking);
    };
  }

  private void readPort(
      ObjectReader port,
      Set<String> names,
      List<Data> data,
      Function<ObjectReader, Consumer<Data>> more) {
    String topic =
        checked(port, ChainNames.TOPIC, RosNames::isTopic, DescriptionRules.TOPIC_ILLEGAL);
    String type =
        checked(
            port, ChainNames.MESSAGE_TYPE, RosNames::isMessageType, DescriptionRules.TYPE_ILLEGAL);
    Optional<QosProfile> qos = QosReader.read(port);
    OptionalDouble transport = port.number(ChainNames.WORST_CASE_TRANSPORT_TIME, NOT_NEGATIVE);
    if (port.value(ChainNames.VALUES).map(json -> json.isArray() && json.isEmpty()).orElse(true)) {
      find(
          InstanceRules.FEATURE_MISSING,
          "The topic '" + topic + "' has no values.",
          port.location());
    }
    Consumer<Data> completion = more.apply(port);
    for (ObjectReader json : port.objects(ChainNames.VALUES)) {
      Data value = readValue(json, names);
      origins.putFeatures(value, feature -> placeOf(feature, port, json));
      completion.accept(value);
      value.setTopicName(topic);
      value.setMessageType(type);
      qos.map(EcoreUtil::copy).ifPresent(value::setQos);
      transport.ifPresent(value::setWorstCaseTransportTime);
      chain.getData().add(value);
      data.add(value);
    }
    port.refuseOthers();
  }

  private static Optional<SourceLocation> placeOf(
      EStructuralFeature feature, ObjectReader port, ObjectReader value) {
    return ChainNames.of(feature).map(OF_PORTS.contains(feature) ? port::at : value::at);
  }

  private Data readValue(ObjectReader json, Set<String> names) {
    Data value = FACTORY.createData();
    origins.put(value, json.location());
    value.setName(name(json, "value"));
    if (!names.add(value.getName()) && !value.getName().isEmpty()) {
      find(
          DescriptionRules.NAME_DUPLICATE,
          "There is already a value '" + value.getName() + "' on this side of the component.",
          json.at(ChainNames.NAME));
    }
    value.setFieldName(
        checked(json, ChainNames.FIELD, RosNames::isFieldPath, DescriptionRules.FIELD_ILLEGAL));
    json.text(ChainNames.DESCRIPTION).ifPresent(value::setDescription);
    json.text(ChainNames.TYPE).ifPresent(value::setType);
    json.text(ChainNames.UNIT).ifPresent(value::setUnit);
    json.text(ChainNames.COMPONENT_UNIT).ifPresent(value::setComponentUnit);
    json.number(ChainNames.MAXIMUM_AGE, NumberRange.above(0)).ifPresent(value::setMaximumAge);
    safeValue(json).ifPresent(value::setSafeValue);
    json.refuseOthers();
    return value;
  }

  /** Returns a number, a Boolean or a string as written. */
  private Optional<String> safeValue(ObjectReader json) {
    Optional<JsonNode> value = json.value(ChainNames.SAFE_VALUE);
    if (value.isPresent() && !value.get().isValueNode()) {
      find(
          InstanceRules.VALUE_TYPE,
          "A safe value is a number, true, false or a string.",
          json.at(ChainNames.SAFE_VALUE));
    }
    return value.filter(JsonNode::isValueNode).map(JsonNode::asText);
  }

  private String name(ObjectReader json, String what) {
    String name = json.requiredText(ChainNames.NAME);
    if (!name.isBlank() && !PythonNames.isFreeIdentifier(name)) {
      diagnostics.add(
          Diagnostic.of(
                  DescriptionRules.NAME_ILLEGAL,
                  "'" + Names.printable(name) + "' cannot be the name of a " + what + ".",
                  json.at(ChainNames.NAME))
              .withHint(
                  "Names are Python identifiers: letters, digits and underscores; they cannot"
                      + " begin with a digit, or be a keyword."));
    }
    return name;
  }

  private String checked(ObjectReader json, String property, Predicate<String> legal, Rule rule) {
    String value = json.requiredText(property);
    if (!value.isBlank() && !legal.test(value)) {
      String message =
          "'" + Names.printable(value) + "' is not a legal " + property.replace('_', ' ') + ".";
      diagnostics.add(
          Diagnostic.of(rule, message, json.at(property)).withHint(ChainNames.ruleOf(property)));
    }
    return value;
  }

  private void refuseDuplicates(List<SoftwareNode> nodes) {
    Map<String, SoftwareNode> seen = new HashMap<>();
    for (SoftwareNode node : nodes) {
      // File and package names are component names in lower case.
      SoftwareNode earlier = seen.putIfAbsent(node.getName().toLowerCase(Locale.ROOT), node);
      if (earlier != null && !node.getName().isEmpty()) {
        diagnostics.add(
            Diagnostic.of(
                    DescriptionRules.NAME_DUPLICATE,
                    "There is already a component '"
                        + earlier.getName()
                        + "' in line "
                        + origins.locate(earlier).line()
                        + ".",
                    origins.locate(node))
                .withHint("Names of components must differ in more than upper and lower case."));
      }
    }
  }

  /**
   * Links the main line: the next step is the first later component that reads a topic of this one.
   */
  private void linkNextSteps() {
    List<SoftwareNode> nodes = chain.getSoftware();
    for (int i = 0; i < nodes.size(); i++) {
      Set<String> written = topics(nodes.get(i), nodes.get(i).getOutput());
      Optional<SoftwareNode> next =
          nodes.subList(i + 1, nodes.size()).stream()
              .filter(node -> !Collections.disjoint(written, topics(node, node.getInput())))
              .findFirst();
      next.ifPresent(nodes.get(i)::setNextstep);
    }
  }

  private static Set<String> topics(SoftwareNode node, List<Data> data) {
    return data.stream()
        .flatMap(value -> TopicIndex.nameOf(value, node).stream())
        .collect(Collectors.toSet());
  }

  private void find(Rule rule, String message, SourceLocation location) {
    diagnostics.add(Diagnostic.of(rule, message, location));
  }
}
