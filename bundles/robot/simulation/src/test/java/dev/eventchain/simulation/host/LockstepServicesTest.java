package dev.eventchain.simulation.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.host.NodeSession.Outbound;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.node.NodePackage;
import dev.eventchain.simulation.node.Replacements;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Nodes that ask each other in lock-step: definition, samples and log. */
class LockstepServicesTest {

  private static final Path FOLDER = Path.of("src/test/resources/services").toAbsolutePath();
  private static final long MILLISECOND = 1_000_000;
  private static final String REQUESTS = "rq/sumRequest";
  private static final String REPLIES = "rr/sumReply";

  @TempDir private Path work;

  private LockstepProcess start() throws IOException {
    Path messages = work.resolve("messages.json");
    Files.writeString(messages, MessageCatalog.of(List.of(FOLDER.resolve("msg"))).ownDefinitions());
    NodePackage nodes =
        new NodePackage(
            FOLDER.resolve("nodes"),
            new NodeManifest(SourceLocation.NONE, "nodes", List.of()),
            messages,
            Set.of(),
            NodeLimits.DEFAULT,
            List.of(),
            Replacements.NONE);
    PythonEnvironment python = PythonEnvironment.ensure(line -> {});
    return new LockstepProcess(new HostProgram(nodes, python, Confinement.detect()), 2, 0);
  }

  private ObjectNode configuration(String... nodes) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.putArray("path").add(FOLDER.resolve("nodes").toString());
    json.putArray("messages").add(work.resolve("messages.json").toString());
    ArrayNode configured = json.putArray("nodes");
    for (String node : nodes) {
      ObjectNode entry = configured.addObject().put("module", "nodes").put("class", node);
      entry.put("name", node).put("execution_time_ms", 2.0).putNull("component");
    }
    ArrayNode received = json.putArray("world_subscribes");
    received.addObject().put("topic", REQUESTS).put("type", "demo_srvs/srv/Sum_Request");
    received.addObject().put("topic", REPLIES).put("type", "demo_srvs/srv/Sum_Response");
    received.addObject().put("topic", "/heard").put("type", "std_msgs/msg/Int64");
    return json;
  }

  @Test
  void requestsAndAnswersAreSamplesOfTheRecord() throws IOException {
    ObjectNode configuration = configuration("Adder", "Asker");
    try (LockstepProcess process = start()) {
      process.session().configure(configuration);
      List<Outbound> samples = process.session().step(200 * MILLISECOND, List.of());
      assertEquals(
          List.of("0 at 102", "1 at 104", "2 at 106"),
          samples.stream().map(it -> it.topic() + " at " + it.time() / MILLISECOND).toList());
      assertEquals(42, samples.get(2).message().order(ByteOrder.LITTLE_ENDIAN).getLong(4));
      RunLog log = process.session().finish();
      new RunLogCheck(log, configuration, 200 * MILLISECOND).check(samples);
      assertEquals(Map.of(0L, 104 * MILLISECOND), log.publications().get(REPLIES));
      RunLog.Activation answered = log.nodes().get("Adder").get(0);
      assertEquals(List.of(new RunLog.SampleId(REQUESTS, 0)), answered.reads());
      assertEquals(List.of(new RunLog.SampleId(REPLIES, 0)), answered.writes());
    }
  }

  @Test
  void aServiceThatNobodyOffersIsAFinding() throws IOException {
    try (LockstepProcess process = start()) {
      DiagnosticException refused =
          assertThrows(
              DiagnosticException.class, () -> process.session().configure(configuration("Asker")));
      assertEquals("node.failed", refused.diagnostics().get(0).id());
      assertEquals(
          "Node Asker: RuntimeError: node 'Asker' waits for the service '/sum', but none of the nodes has"
              + " started it",
          refused.diagnostics().get(0).message());
    }
  }
}
