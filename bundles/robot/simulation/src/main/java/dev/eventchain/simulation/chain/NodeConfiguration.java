package dev.eventchain.simulation.chain;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.node.NodePackage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.zip.CRC32;

/** The configuration of the process that runs the nodes. */
public final class NodeConfiguration {

  private final SimulatedChain chain;
  private final NodePackage generated;

  /**
   * Creates the configuration of the nodes of a chain.
   *
   * @param generated the generated package
   */
  public NodeConfiguration(SimulatedChain chain, NodePackage generated) {
    this.chain = chain;
    this.generated = generated;
  }

  /**
   * Returns the configuration of the process for a scenario.
   *
   * @param seed the seed of the scenario
   * @param phases those that the scenario sets, in ms, by the names of the nodes
   * @param published the topics that the world publishes
   * @param received the topics that the world receives
   */
  public ObjectNode of(
      long seed,
      Map<String, Double> phases,
      List<TypedTopic> published,
      List<TypedTopic> received) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    ArrayNode path = json.putArray("path").add(absolute(generated.folder()));
    if (generated.manifest().nodes().stream().anyMatch(node -> node.component().isEmpty())) {
      path.add(absolute(generated.folder().resolve(NodeManifest.NODES)));
    }
    replaced(json);
    json.putArray("messages").add(absolute(generated.messages()));
    ArrayNode configured = json.putArray("nodes");
    if (!chain.isAttached()) {
      for (SoftwareNode node : chain.nodes()) {
        double phase = phases.getOrDefault(node.getName(), phase(node, seed));
        configured.add(configuration(node, seed).put("phase_ms", phase));
      }
    }
    ArrayNode publishes = json.putArray("world_publishes");
    published.forEach(
        topic -> publishes.add(configuration(topic, chain.bench().offered(topic.name()))));
    ArrayNode subscribes = json.putArray("world_subscribes");
    received.forEach(topic -> subscribes.add(received(topic)));
    json.put("step_limit_s", generated.limits().processorTime().toNanos() / 1e9);
    json.put("wall_limit_s", generated.limits().wallTime().toNanos() / 1e9);
    return json;
  }

  /** Names the files that modules of nodes as they are are read from instead of their own. */
  private void replaced(ObjectNode json) {
    Map<String, Path> files = generated.replaced().files();
    for (NodeManifest.Node node : generated.manifest().nodes()) {
      if (node.component().isEmpty() && files.containsKey(node.name())) {
        json.withObject("/replaced")
            .put(absolute(generated.nodeFile(node)), absolute(files.get(node.name())));
      }
    }
    new TreeMap<>(generated.replaced().modules())
        .forEach(
            (module, file) ->
                json.withObject("/replaced")
                    .put(absolute(generated.folder().resolve(module)), absolute(file)));
  }

  private static String absolute(Path folder) {
    return folder.toAbsolutePath().normalize().toString();
  }

  private ObjectNode configuration(SoftwareNode software, long seed) {
    String name = software.getName();
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    NodeManifest.Node node = generated.manifest().find(name).orElseThrow();
    json.put("module", node.module());
    json.put("class", node.className());
    json.put("name", name);
    json.put("execution_time_ms", executionTime(software));
    if (node.component().isPresent()) {
      component(json.putObject("component"), node, node.component().get(), seed);
    } else {
      json.putNull("component");
      ObjectNode launch = json.putObject("node").put("name", node.launch().name());
      ObjectNode remappings =
          launch.put("namespace", node.launch().namespace()).putObject("remappings");
      new TreeMap<>(node.launch().remappings()).forEach(remappings::put);
      node.launch().arguments().ifPresent(given -> launch.set("arguments", given));
      node.launch().parameters().ifPresent(given -> launch.set("parameters", given));
    }
    return json;
  }

  private void component(
      ObjectNode json, NodeManifest.Node node, NodeManifest.Component known, long seed) {
    json.put("module", known.module());
    json.put("class", known.className());
    json.put("file", absolute(generated.componentFile(node, known)));
    json.put("seed", seed + "/" + node.name());
    json.put("restricted", generated.restricted().contains(node.name()));
    Path modules = generated.replaced().folders().get(node.name());
    if (modules != null) {
      json.putArray("path").add(absolute(modules));
    }
    ArrayNode inputs = json.putArray("inputs");
    known.inputs().forEach(inputs::add);
    ArrayNode outputs = json.putArray("outputs");
    known
        .outputs()
        .forEach(
            output -> outputs.addObject().put("name", output.name()).put("type", output.type()));
  }

  /** Describes a topic that the vehicle consumes, or that is only observed, with any QoS. */
  private ObjectNode received(TypedTopic topic) {
    return chain.bench().consumed().containsKey(topic.name())
        ? configuration(topic, chain.bench().requested(topic.name()))
        : configuration(topic);
  }

  private static ObjectNode configuration(TypedTopic topic) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    return json.put("topic", topic.name()).put("type", topic.type());
  }

  private static ObjectNode configuration(TypedTopic topic, QosSettings quality) {
    ObjectNode json = configuration(topic);
    json.putObject("qos")
        .put("best_effort", quality.reliability() == Reliability.BEST_EFFORT)
        .put("transient", quality.durability() == Durability.TRANSIENT_LOCAL)
        .put("manual", quality.liveliness() == Liveliness.MANUAL_BY_TOPIC)
        .put("deadline", quality.deadline().map(Duration::toNanos).orElse(0L))
        .put("lease", quality.lease().map(Duration::toNanos).orElse(0L));
    return json;
  }

  /** Returns the worst-case execution time of the model, in ms; 0 if it is not stated. */
  private static double executionTime(SoftwareNode node) {
    return node.isSetWorstCaseExecutionTime() ? node.getWorstCaseExecutionTime() : 0.0;
  }

  /**
   * Returns the phase of a node within its period, in ms, since nodes on a vehicle start at
   * arbitrary times. It depends only on the scenario's seed and the node's name.
   */
  private static double phase(SoftwareNode node, long seed) {
    CRC32 digest = new CRC32();
    digest.update(node.getName().getBytes(StandardCharsets.UTF_8));
    SplittableRandom random = new SplittableRandom(seed * 0x1_0000_0001L ^ digest.getValue());
    long microseconds = (long) (random.nextDouble() * SimulatedChain.period(node) * 1000);
    return microseconds / 1000.0;
  }
}
