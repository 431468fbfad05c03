package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.simulation.host.HostChannel;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLogCheck;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.wire.NodeProcess.Said;
import dev.eventchain.simulation.wire.WireWorld.Arrived;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;

/** Nodes on DDS, each in its own process; subclasses define the passage of time. */
abstract class DdsSession implements NodeSession {

  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);
  private static final Comparator<Arrived> BY_STAMP =
      Comparator.<Arrived>comparingLong(it -> it.sample().sourceTimestamp())
          .thenComparingInt(Arrived::reader);

  final List<NodeProcess> nodes;
  final Supervisor supervisor;
  WireWorld world;
  Deliveries deliveries;

  /** Scenario time, in ns. */
  long now;

  private final DdsParticipant participant;
  private final MessageCatalog catalog;
  private final UserFiles files;
  private final Duration connecting;
  private final List<Arrived> arrived = new ArrayList<>();
  private final List<Outbound> commands = new ArrayList<>();
  private JsonNode configuration;
  private WireGraph graph;

  /** GUIDs of the nodes' readers of the clock. */
  private Set<String> clocks = Set.of();

  /**
   * Creates a session over running processes.
   *
   * @param participant the participant of the world
   * @param limits the limits of a node's answer
   */
  DdsSession(
      List<NodeProcess> nodes,
      DdsParticipant participant,
      MessageCatalog catalog,
      UserFiles files,
      NodeLimits limits) {
    this.nodes = List.copyOf(nodes);
    this.participant = participant;
    this.catalog = catalog;
    this.files = files;
    this.connecting = limits.wallTime();
    this.supervisor = new Supervisor(this.nodes, files, limits.wallTime());
    nodes.forEach(node -> node.listen(supervisor::said));
  }

  @Override
  public JsonNode configure(JsonNode newConfiguration) {
    int kind = configuration == null ? HostChannel.CONFIGURE : HostChannel.RESET;
    configuration = newConfiguration;
    leave();
    deliveries = null;
    supervisor.start();
    now = 0;
    arrived.clear();
    commands.clear();
    for (int node = 0; node < nodes.size(); node++) {
      nodes.get(node).ask(kind, alone(node), HostChannel.READY);
    }
    List<JsonNode> ready = answers();
    try {
      graph = WireGraph.of(ready, configuration);
      clocks =
          ready.stream().map(each -> each.required("clock").asText()).collect(Collectors.toSet());
    } catch (IllegalArgumentException e) {
      throw nodes.get(0).failures().garbage("an invalid READY frame: " + e.getMessage());
    }
    for (int node = 0; node < nodes.size(); node++) {
      nodes.get(node).reset(graph.writersOf(node).size(), graph.readersOf(node).size());
    }
    connect();
    return said(ready);
  }

  /** Returns the configuration of one node. */
  private ObjectNode alone(int node) {
    ObjectNode json = configuration.deepCopy();
    json.remove(List.of("world_publishes", "world_subscribes"));
    json.put("real_time", isInRealTime());
    ObjectNode alone = configuration.path("nodes").path(node).deepCopy();
    describe(alone);
    json.putArray("nodes").add(alone);
    return json;
  }

  private void connect() {
    world = new WireWorld(participant, graph, catalog, supervisor::arrived, () -> take(await()));
    deliveries = new Deliveries(graph, this::written, this::received);
    long latest = System.nanoTime() + connecting.toNanos();
    for (int node = 0; node < nodes.size(); node++) {
      JsonNode wanted = graph.connect(node, connecting, world::guid);
      nodes.get(node).ask(HostChannel.CONNECT, wanted, HostChannel.CONNECTED);
    }
    List<JsonNode> answers = answers(); // first, since connecting processes new output
    List<String> missing = new ArrayList<>();
    world
        .connect(clocks, Duration.ofNanos(Math.max(1, latest - System.nanoTime())))
        .forEach(what -> missing.add("the vehicle with " + what));
    for (int node = 0; node < nodes.size(); node++) {
      for (JsonNode each : answers.get(node).path("missing")) {
        String end = "node " + nodes.get(node).name() + " with its " + each.path(0).asText();
        missing.add(end + " on " + each.path(1).asText());
      }
    }
    if (!missing.isEmpty()) {
      throw NodeLoss.unmatched(missing, files);
    }
    begin();
  }

  /** Starts the scenario once everything is connected. */
  abstract void begin();

  /** Ends the scenario; samples on the way still arrive. */
  void end() {}

  /** Processes the final answers of the nodes apart from their logs. */
  void notice(List<JsonNode> finished) {}

  /** Adds further configuration for the host of a node. */
  void describe(ObjectNode node) {}

  /** Returns whether scenario time is wall time. */
  boolean isInRealTime() {
    return false;
  }

  /**
   * Checks a log.
   *
   * @throws IllegalArgumentException with the contradiction
   */
  abstract void check(RunLogCheck check, List<Outbound> published);

  private long written(WireEnd writer) {
    return writer.owner() == WireEnd.WORLD
        ? world.written(writer.index())
        : nodes.get(writer.owner()).written(writer.index());
  }

  private long received(WireEnd reader) {
    return reader.owner() == WireEnd.WORLD
        ? world.received(reader.index())
        : nodes.get(reader.owner()).received(reader.index());
  }

  private JsonNode said(List<JsonNode> ready) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.set("python", ready.get(0).path("python"));
    ArrayNode warnings = graph.warnings();
    ready.forEach(each -> each.path("warnings").forEach(warnings::add)); // within a node
    json.set("warnings", warnings);
    return json;
  }

  @Override
  public final List<Outbound> step(long until, List<Inbound> messages) {
    List<Outbound> published = new ArrayList<>();
    pass(until, messages, published);
    now = until;
    published.forEach(each -> commands.add(new Outbound(each.time(), each.topic(), NOTHING)));
    return published;
  }

  /**
   * Publishes messages now and advances time.
   *
   * @param published receives the messages that the nodes published
   */
  abstract void pass(long until, List<Inbound> messages, List<Outbound> published);

  /** Returns and removes the arrived samples, in the order of their creation. */
  final List<Arrived> takeArrived() {
    arrived.sort(BY_STAMP);
    List<Arrived> taken = List.copyOf(arrived);
    arrived.clear();
    return taken;
  }

  /** Processes events until a condition holds. */
  final void until(BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      take(await());
    }
  }

  private Optional<Object> await() {
    return supervisor.await(now, Optional.ofNullable(deliveries));
  }

  /** Waits until all nodes have answered, and all written samples have arrived or are lost. */
  final void settle() {
    until(() -> nodes.stream().allMatch(NodeProcess::isIdle) && deliveries.areComplete());
  }

  /** Processes an event, if there is one. */
  final void take(Optional<Object> event) {
    if (event.isPresent() && event.get() instanceof Arrived sample) {
      world.count(sample);
      arrived.add(sample);
    } else if (event.isPresent()) {
      Said said = (Said) event.get();
      said.node().take(said);
    }
  }

  /** Returns the answer of each node. */
  private List<JsonNode> answers() {
    until(() -> nodes.stream().allMatch(NodeProcess::isIdle));
    return nodes.stream().map(NodeProcess::answer).toList();
  }

  @Override
  public RunLog finish() {
    end();
    JsonNode nothing = JsonNodeFactory.instance.objectNode();
    nodes.forEach(node -> node.ask(HostChannel.FINISH, nothing, HostChannel.FINISHED));
    List<JsonNode> finished = answers();
    try {
      notice(finished);
      WireRecord record = new WireRecord();
      record.add(world.publications());
      leave();
      finished.forEach(record::add);
      RunLog log = RunLog.parse(record.toJson());
      check(new RunLogCheck(log, configuration, now), commands);
      return log;
    } catch (IllegalArgumentException e) {
      throw nodes.get(0).failures().garbage("an impossible record: " + e.getMessage());
    }
  }

  @Override
  public Map<String, Long> lost() {
    return deliveries.lost();
  }

  /** Closes the DDS entities; processes continue. */
  private void leave() {
    if (world != null) {
      world.close();
      world = null;
    }
  }
}
