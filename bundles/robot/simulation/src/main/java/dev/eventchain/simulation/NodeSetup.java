package dev.eventchain.simulation;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.CRC32;

/** What of a chain is simulated, and how: the nodes that were generated, their times and topics. */
final class NodeSetup {

  private static final double MILLISECONDS = 1e3;
  private static final double NANOSECONDS = 1e6;

  /** Periods of what writes a topic after which a sample is too old, where nothing else is said. */
  private static final double USUAL_PERIODS = 5;

  private final SimulationRequest request;
  private final List<SoftwareNode> nodes;
  private final TopicIndex topics;
  private final MessageCatalog catalog;

  /**
   * Finds the nodes of the request.
   *
   * @throws DiagnosticException (INPUT) if the manifest is not that of the chain ({@code
   *     simulation.manifest})
   */
  NodeSetup(SimulationRequest request) {
    this.request = request;
    this.catalog = MessageCatalog.of(request.messageFolders());
    List<SoftwareNode> components =
        request.chain().getSoftware().stream()
            .filter(node -> node.getImplementation() == ComponentImplementation.COMPONENT)
            .toList();
    // Others may run whatever they like for what is a node by itself.
    this.nodes = isAttached() ? List.copyOf(request.chain().getSoftware()) : components;
    this.topics = TopicIndex.of(request.chain());
    List<Diagnostic> problems =
        request.manifest().problems(request.chain(), request.packageFolder(), components);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
  }

  /** How the nodes and the world are connected. */
  Bench bench() {
    return request.bench();
  }

  /** The files that the user's code is in. */
  UserFiles userFiles() {
    return new UserFiles(request.packageFolder());
  }

  /** How the nodes are run, for people. */
  String driverWords() {
    return request.driverWords();
  }

  /** Whether the nodes are run elsewhere, so that what happens inside is not visible. */
  boolean isAttached() {
    return request.driver() == SimulationRequest.Driver.DDS_ATTACHED;
  }

  /** The message types that the nodes use. */
  MessageCatalog catalog() {
    return catalog;
  }

  /** The nodes, in chain order. */
  List<SoftwareNode> nodes() {
    return nodes;
  }

  /**
   * A finding for each node of the chain that is not simulated, so that it is not taken for tested.
   */
  List<Diagnostic> leftOut() {
    return request.chain().getSoftware().stream()
        .filter(node -> !nodes.contains(node))
        .map(
            node ->
                Diagnostic.warning(
                        "simulation.node.left-out",
                        "The component '"
                            + node.getName()
                            + "' is a node itself, so it is not simulated.",
                        SourceLocation.NONE.withElement(node.getName()))
                    .withHint("Describe it as a component to simulate it; see the rule's page."))
        .toList();
  }

  /** The full names of all topics that a node reads. */
  Set<String> topicsRead() {
    return topicsOfAll(TopicIndex.Topic::subscribers);
  }

  /** The full names of all topics that a node writes. */
  Set<String> topicsWritten() {
    return topicsOfAll(TopicIndex.Topic::publishers);
  }

  private Set<String> topicsOfAll(Function<TopicIndex.Topic, List<TopicIndex.Endpoint>> side) {
    return topics.topics().stream()
        .filter(topic -> side.apply(topic).stream().anyMatch(this::isSimulated))
        .map(TopicIndex.Topic::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Where recordings go; nowhere if none are wanted. */
  Optional<Path> recordings() {
    return request.recordings();
  }

  /** All topics that nodes write, if they are recorded. */
  List<BenchDriver.Topic> topicsToRecord() {
    return recordings().isEmpty()
        ? List.of()
        : topics.topics().stream().flatMap(topic -> written(topic).stream()).toList();
  }

  private Optional<BenchDriver.Topic> written(TopicIndex.Topic topic) {
    return topic.publishers().stream()
        .filter(this::isSimulated)
        .flatMap(endpoint -> endpoint.data().stream())
        .flatMap(data -> Optional.ofNullable(data.getMessageType()).stream())
        .findFirst()
        .map(type -> new BenchDriver.Topic(topic.name(), RosNames.fullMessageType(type)));
  }

  /** What the simulated components write, for reports. */
  ChainSignals chainSignals() {
    return ChainSignals.of(
        topics.topics().stream()
            .filter(topic -> topic.publishers().stream().anyMatch(this::isSimulated))
            .toList(),
        catalog,
        bench().consumed());
  }

  /** The first topic of the bench that a node reads; empty if none reads any. */
  String entry() {
    Set<String> read = topicsRead();
    return bench().provided().keySet().stream().filter(read::contains).findFirst().orElse("");
  }

  /**
   * The first topic by which a node commands the vehicle, or else the first that the vehicle only
   * receives, such as a lamp; empty if there is none.
   */
  String exit() {
    return Stream.concat(commands().stream(), bench().consumed().keySet().stream())
        .filter(topicsWritten()::contains)
        .findFirst()
        .orElse("");
  }

  /**
   * The topics that the vehicle is commanded by in this project: those that its bench or its
   * signals name, or that its nodes write.
   */
  List<String> commands() {
    Set<String> written = topicsWritten();
    return bench().consumed().values().stream()
        .filter(Bench.Consumed::commands)
        .filter(topic -> !written.contains(topic.topic()) || isDriven(topic))
        .map(Bench.Consumed::topic)
        .filter(topic -> written.contains(topic) || bench().isOwn(topic))
        .toList();
  }

  /** Whether a node writes a field of the topic that drives something. */
  private boolean isDriven(Bench.Consumed topic) {
    return topic.fields().stream()
        .filter(field -> field.actuator().isPresent())
        .anyMatch(field -> isWritten(topic.topic(), field.path()));
  }

  /** Whether a node writes a field that drives one of the actuators. */
  boolean drives(Actuator... actuators) {
    Set<Actuator> wanted = Set.of(actuators);
    return bench().consumed().values().stream()
        .anyMatch(
            topic ->
                topic.fields().stream()
                    .filter(field -> field.actuator().filter(wanted::contains).isPresent())
                    .anyMatch(field -> isWritten(topic.topic(), field.path())));
  }

  /** Whether a node writes a field. */
  boolean isWritten(String topic, String path) {
    return endpoints(topic, TopicIndex.Topic::publishers)
        .flatMap(endpoint -> endpoint.data().stream())
        .map(Data::getFieldName)
        .anyMatch(written -> written != null && RosNames.overlap(written, path));
  }

  /** Whether people have decided to live with a finding. */
  boolean isAccepted(Diagnostic finding) {
    return request.accepted().test(finding);
  }

  /** The latency constraints of the chain. */
  List<LatencyConstraint> latencyConstraints() {
    return request.chain().getLatencyConstraints();
  }

  /** The full names of the topics that a node reads. */
  Set<String> topicsReadBy(SoftwareNode node) {
    return topicsOf(node, TopicIndex.Topic::subscribers);
  }

  /** The full names of the topics that a node writes. */
  Set<String> topicsWrittenBy(SoftwareNode node) {
    return topicsOf(node, TopicIndex.Topic::publishers);
  }

  private Set<String> topicsOf(
      SoftwareNode node, Function<TopicIndex.Topic, List<TopicIndex.Endpoint>> side) {
    return topics.topics().stream()
        .filter(topic -> side.apply(topic).stream().anyMatch(end -> end.node() == node))
        .map(TopicIndex.Topic::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** The components of the chain that write a topic, simulated or not. */
  List<String> writers(String topic) {
    return topics.find(topic).stream()
        .flatMap(found -> found.publishers().stream())
        .map(endpoint -> endpoint.node().getName())
        .distinct()
        .toList();
  }

  /** Name of the first node that reads a topic; empty if none does. */
  String reader(String topic) {
    return endpoints(topic, TopicIndex.Topic::subscribers)
        .findFirst()
        .map(endpoint -> endpoint.node().getName())
        .orElse("");
  }

  /** Name of the last node that writes a topic; empty if none does. */
  String writer(String topic) {
    return endpoints(topic, TopicIndex.Topic::publishers)
        .reduce((first, second) -> second)
        .map(endpoint -> endpoint.node().getName())
        .orElse("");
  }

  private Stream<TopicIndex.Endpoint> endpoints(
      String topic, Function<TopicIndex.Topic, List<TopicIndex.Endpoint>> side) {
    return topics.find(topic).stream()
        .flatMap(found -> side.apply(found).stream())
        .filter(this::isSimulated);
  }

  private boolean isSimulated(TopicIndex.Endpoint endpoint) {
    return nodes.contains(endpoint.node());
  }

  /**
   * How old a sample of a topic may be where the model does not say it, in ms: five periods of the
   * slowest of its writers; 0, which is not a limit, if they are not known.
   */
  double usualAge(String topic) {
    List<Double> periods =
        topics.find(topic).stream()
            .flatMap(found -> found.publishers().stream())
            .map(end -> period(end.node()))
            .toList();
    return periods.isEmpty() || periods.contains(0.0)
        ? 0
        : USUAL_PERIODS * periods.stream().mapToDouble(Double::doubleValue).max().orElseThrow();
  }

  /**
   * For how long a sample of a topic says something, in ns: as long as the most patient of its ends
   * takes it, see {@link #usualAge}; 0 is for ever.
   */
  long lifetime(String topic) {
    double stated =
        topics.find(topic).stream()
            .flatMap(
                found -> Stream.concat(found.publishers().stream(), found.subscribers().stream()))
            .flatMap(end -> end.data().stream())
            .filter(Data::isSetMaximumAge)
            .mapToDouble(Data::getMaximumAge)
            .max()
            .orElse(0);
    return Math.round(Math.max(stated, usualAge(topic)) * NANOSECONDS);
  }

  /** The configuration of the process that runs the nodes. */
  ObjectNode configuration(Scenario scenario, BenchDriver driver) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.putArray("path").add(absolute(request.packageFolder()));
    ArrayNode messages = json.putArray("messages");
    request.messageFolders().forEach(folder -> messages.add(absolute(folder)));
    ArrayNode configured = json.putArray("nodes");
    if (!isAttached()) {
      nodes.forEach(node -> configured.add(configuration(node, scenario.seed())));
    }
    ArrayNode publishes = json.putArray("world_publishes");
    driver.published().forEach(topic -> publishes.add(configuration(topic)));
    ArrayNode subscribes = json.putArray("world_subscribes");
    driver.received().forEach(topic -> subscribes.add(configuration(topic)));
    json.put("step_limit_s", request.limits().processorTime().toNanos() / 1e9);
    json.put("wall_limit_s", request.limits().wallTime().toNanos() / 1e9);
    return json;
  }

  private static String absolute(Path folder) {
    return folder.toAbsolutePath().normalize().toString();
  }

  private ObjectNode configuration(SoftwareNode node, long seed) {
    String name = node.getName();
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    NodeManifest.Node generated = request.manifest().find(name).orElseThrow();
    json.put("module", generated.module());
    json.put("class", generated.className());
    json.put("name", name);
    json.put("execution_time_ms", executionTime(node));
    json.put("phase_ms", phase(node, seed));
    NodeManifest.Component known = generated.component();
    ObjectNode component = json.putObject("component");
    component.put("module", known.module());
    component.put("class", known.className());
    component.put("file", absolute(request.packageFolder().resolve(known.file())));
    component.put("restricted", request.generated().contains(name));
    ArrayNode inputs = component.putArray("inputs");
    known.inputs().forEach(inputs::add);
    ArrayNode outputs = component.putArray("outputs");
    known
        .outputs()
        .forEach(
            output -> outputs.addObject().put("name", output.name()).put("type", output.type()));
    return json;
  }

  private static ObjectNode configuration(BenchDriver.Topic topic) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    return json.put("topic", topic.name()).put("type", topic.type());
  }

  /** In ms: the model's worst case; none if it does not know one. */
  private static double executionTime(SoftwareNode node) {
    return node.isSetWorstCaseExecutionTime() ? node.getWorstCaseExecutionTime() : 0.0;
  }

  /** In ms; empty period is taken for none. */
  static double period(SoftwareNode node) {
    return node.isSetFrequency() && node.getFrequency() > 0
        ? MILLISECONDS / node.getFrequency()
        : 0.0;
  }

  /**
   * In ms: somewhere in the node's period, since nodes on a vehicle start when they start. It
   * depends on the scenario's seed and the node's name only.
   */
  private static double phase(SoftwareNode node, long seed) {
    CRC32 digest = new CRC32();
    digest.update(node.getName().getBytes(StandardCharsets.UTF_8));
    SplittableRandom random = new SplittableRandom(seed * 0x1_0000_0001L ^ digest.getValue());
    long microseconds = (long) (random.nextDouble() * period(node) * 1000);
    return microseconds / 1000.0;
  }
}
