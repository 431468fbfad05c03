package dev.eventchain.simulation.chain;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.world.Actuator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Simulated part of a chain: the nodes that run, their times and their topics. */
public final class SimulatedChain {

  private static final double MILLISECONDS = 1e3;
  private static final double NANOSECONDS = 1e6;

  /** Default maximum age of a sample, in periods of its topic's writer. */
  private static final double USUAL_PERIODS = 5;

  private final List<SoftwareNode> nodes;
  private final TopicIndex topics;
  private final EventChain chain;
  private final Bench bench;
  private final MessageCatalog catalog;
  private final boolean attached;
  private final Set<String> hosted;

  /**
   * Collects the simulated nodes.
   *
   * @param bench the connection of the nodes with the world
   * @param catalog the message types that the nodes use
   * @param attached true if the nodes run elsewhere
   * @param hosted the names of nodes that are hosted as they are
   */
  public SimulatedChain(
      EventChain chain, Bench bench, MessageCatalog catalog, boolean attached, Set<String> hosted) {
    this.chain = chain;
    this.hosted = Set.copyOf(hosted);
    this.bench = bench;
    this.catalog = catalog;
    this.attached = attached;
    // Elsewhere, nodes that are not components may run as well.
    this.nodes =
        chain.getSoftware().stream()
            .filter(node -> attached || isHosted(node) || hosted.contains(node.getName()))
            .toList();
    this.topics = TopicIndex.of(chain);
  }

  /** Returns the nodes of a chain that are components rather than nodes by themselves. */
  public static List<SoftwareNode> components(EventChain chain) {
    return chain.getSoftware().stream().filter(SimulatedChain::isHosted).toList();
  }

  /** Returns whether a node is generated around a component, and so always hosted. */
  private static boolean isHosted(SoftwareNode node) {
    return node.getImplementation() == ComponentImplementation.COMPONENT;
  }

  /** Returns the same nodes on another bench. */
  public SimulatedChain on(Bench other) {
    return new SimulatedChain(chain, other, catalog, attached, hosted);
  }

  /** Returns the connection of the nodes with the world. */
  public Bench bench() {
    return bench;
  }

  /** Returns whether the nodes run elsewhere, so that their activations are not visible. */
  public boolean isAttached() {
    return attached;
  }

  /** Returns the message types that the nodes use. */
  public MessageCatalog catalog() {
    return catalog;
  }

  /** Returns the data flow between all nodes of the chain. */
  public DataFlowIndex flow() {
    return DataFlowIndex.of(chain);
  }

  /** Returns the nodes, in chain order. */
  public List<SoftwareNode> nodes() {
    return nodes;
  }

  /**
   * Returns a finding for each node of the chain that is not simulated and therefore not tested.
   */
  public List<Diagnostic> leftOut() {
    return chain.getSoftware().stream()
        .filter(node -> !nodes.contains(node))
        .map(
            node ->
                Diagnostic.of(
                        ChainRules.NODE_LEFT_OUT,
                        "The component '"
                            + node.getName()
                            + "' is a node itself, so it is not simulated.",
                        SourceLocation.NONE.withElement(node.getName()))
                    .withHint(
                        "Describe its class and file, or make it a component; see the rule's page."))
        .toList();
  }

  /** Returns the full names of all topics that nodes read. */
  public Set<String> topicsRead() {
    return topicsOfAll(TopicIndex.Topic::subscribers);
  }

  /** Returns the full names of all topics that nodes write. */
  public Set<String> topicsWritten() {
    return topicsOfAll(TopicIndex.Topic::publishers);
  }

  private Set<String> topicsOfAll(Function<TopicIndex.Topic, List<TopicIndex.Endpoint>> side) {
    return topics.topics().stream()
        .filter(topic -> side.apply(topic).stream().anyMatch(this::isSimulated))
        .map(TopicIndex.Topic::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns the data that nodes read or write, by the full names of their topics. */
  public Map<String, List<Data>> data() {
    Map<String, List<Data>> data = new LinkedHashMap<>();
    for (TopicIndex.Topic topic : topics.topics()) {
      data.put(
          topic.name(),
          Stream.concat(topic.publishers().stream(), topic.subscribers().stream())
              .filter(this::isSimulated)
              .flatMap(endpoint -> endpoint.data().stream())
              .toList());
    }
    return data;
  }

  /** Returns all topics that nodes write, with their types. */
  public List<TypedTopic> typedTopicsWritten() {
    return topics.topics().stream().flatMap(topic -> written(topic).stream()).toList();
  }

  /** Returns the topics that nodes write and the vehicle consumes, in the bench's order. */
  public List<String> taken() {
    Set<String> written = topicsWritten();
    return bench.consumed().keySet().stream().filter(written::contains).toList();
  }

  private Optional<TypedTopic> written(TopicIndex.Topic topic) {
    return topic.publishers().stream()
        .filter(this::isSimulated)
        .flatMap(endpoint -> endpoint.data().stream())
        .flatMap(data -> Optional.ofNullable(data.getMessageType()).stream())
        .findFirst()
        .map(type -> new TypedTopic(topic.name(), RosNames.fullMessageType(type)));
  }

  /** Returns the signals that the simulated components write, for reports. */
  public ChainSignals chainSignals() {
    return ChainSignals.of(
        topics.topics().stream()
            .filter(topic -> topic.publishers().stream().anyMatch(this::isSimulated))
            .toList(),
        catalog,
        bench);
  }

  /** Returns the first topic of the bench that a node reads; empty if none is read. */
  public String entry() {
    Set<String> read = topicsRead();
    return bench.provided().keySet().stream().filter(read::contains).findFirst().orElse("");
  }

  /**
   * Returns the first topic by which a node commands the vehicle, or else the first that the
   * vehicle only observes, such as a lamp; empty if there is none.
   */
  public String exit() {
    return Stream.concat(commands().stream(), bench.consumed().keySet().stream())
        .filter(topicsWritten()::contains)
        .findFirst()
        .orElse("");
  }

  /**
   * Returns the topics that command the vehicle in this project: those that its bench or its
   * signals name, or that its nodes write.
   */
  public List<String> commands() {
    Set<String> written = topicsWritten();
    return bench.consumed().values().stream()
        .filter(Bench.Consumed::commands)
        .filter(topic -> !written.contains(topic.topic()) || isDriven(topic))
        .map(Bench.Consumed::topic)
        .filter(topic -> written.contains(topic) || bench.isOwn(topic))
        .toList();
  }

  /** Returns whether a node writes a field of the topic that drives an actuator. */
  private boolean isDriven(Bench.Consumed topic) {
    return topic.fields().stream()
        .filter(field -> field.actuator().isPresent())
        .anyMatch(field -> isWritten(topic.topic(), field.path()));
  }

  /** Returns whether a node writes a field that drives one of the actuators. */
  public boolean drives(Actuator... actuators) {
    Set<Actuator> wanted = Set.of(actuators);
    return bench.consumed().values().stream()
        .anyMatch(
            topic ->
                topic.fields().stream()
                    .filter(field -> field.actuator().filter(wanted::contains).isPresent())
                    .anyMatch(field -> isWritten(topic.topic(), field.path())));
  }

  /** Returns whether a node writes a field. */
  public boolean isWritten(String topic, String path) {
    return endpoints(topic, TopicIndex.Topic::publishers)
        .flatMap(endpoint -> endpoint.data().stream())
        .map(Data::getFieldName)
        .anyMatch(written -> written != null && RosNames.overlap(written, path));
  }

  /** Returns the latency constraints of the chain. */
  public List<LatencyConstraint> latencyConstraints() {
    return chain.getLatencyConstraints();
  }

  /**
   * Returns the time from the measurement to the arrival of a topic's messages that a latency
   * constraint counts, in ns.
   */
  public long latencyBefore(String topic, LatencyConstraint constraint) {
    Bench.Provided sensor = bench.provided().get(topic);
    return sensor == null ? 0 : sensor.transfer().countedIn(constraint);
  }

  /** Returns the full names of the topics that a node reads. */
  public Set<String> topicsReadBy(SoftwareNode node) {
    return topics.readBy(node);
  }

  /** Returns the full names of the topics that a node writes. */
  public Set<String> topicsWrittenBy(SoftwareNode node) {
    return topics.writtenBy(node);
  }

  /** Returns the components of the chain that write a topic, simulated or not. */
  public List<String> writers(String topic) {
    return topics.find(topic).stream()
        .flatMap(found -> found.publishers().stream())
        .map(endpoint -> endpoint.node().getName())
        .distinct()
        .toList();
  }

  /** Returns the name of the first node that reads a topic; empty if there is none. */
  public String reader(String topic) {
    return endpoints(topic, TopicIndex.Topic::subscribers)
        .findFirst()
        .map(endpoint -> endpoint.node().getName())
        .orElse("");
  }

  /** Returns the name of the last node that writes a topic; empty if there is none. */
  public String writer(String topic) {
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
   * Returns the default maximum age of a topic's samples, in ms: five periods of its slowest
   * writer; 0, which is no limit, if the writers are unknown.
   */
  public double usualAge(String topic) {
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
   * Returns the lifetime of a topic's samples, in ns: the longest age that one of its ends accepts,
   * see {@link #usualAge}; 0 for unlimited.
   */
  public long lifetime(String topic) {
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

  /** Returns the period of a node, in ms; 0 if it has none. */
  public static double period(SoftwareNode node) {
    return node.isSetFrequency() && node.getFrequency() > 0
        ? MILLISECONDS / node.getFrequency()
        : 0.0;
  }
}
