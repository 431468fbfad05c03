package dev.eventchain.pipeline.generate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;

/** Tests message definitions as a model for templates. */
class MessageModelTest {

  /** A chain and its message definitions, from which a template case generates nodes. */
  private static final Path CASE =
      Path.of("../../mde/m2t/src/test/resources/cases/cyclonedds-python/fork-and-join/model.xmi");

  /** Definitions with fields of every kind, with defaults and bounds. */
  private static final Path MESSAGES =
      Path.of("../../../tests/end-to-end/src/test/resources/cyclonedds/msg");

  @Test
  void theModelOfTheTemplateCaseIsTheOneThatTheDefinitionsGive() throws IOException {
    XmiStore store = EventChainMetamodel.store(CASE.getParent());
    store.loadMetamodel(Path.of("../../../metamodel/messages.ecore"));
    EventChain chain = (EventChain) store.load(CASE).resource().getContents().get(0);
    EventChain copy = EcoreUtil.copy(chain);
    EObject messages = MessageModel.of(copy, MessageCatalog.of(List.of(MESSAGES)));
    assertEquals(
        Files.readString(CASE),
        new String(XmiStore.toBytes(List.of(copy, messages)), StandardCharsets.UTF_8));
  }

  @Test
  void aTypeStandsBehindAllThatItContains() {
    EObject model = model("sensor_msgs/LaserScan", "std_msgs/msg/Float32", "sensor_msgs/LaserScan");
    assertEquals(
        List.of(
            "builtin_interfaces/msg/Time",
            "std_msgs/msg/Header",
            "sensor_msgs/msg/LaserScan",
            "std_msgs/msg/Float32"),
        model.eContents().stream().map(type -> value(type, "name")).toList());
    EObject scan = model.eContents().get(2);
    assertEquals("sensor_msgs", value(scan, "packageName"));
    assertEquals("LaserScan", value(scan, "shortName"));
    EObject ranges = scan.eContents().get(8);
    assertEquals("ranges", value(ranges, "name"));
    assertEquals("float32", value(ranges, "primitive"));
    assertEquals("SEQUENCE", value(ranges, "shape").toString());
    assertEquals(model.eContents().get(1), value(scan.eContents().get(0), "message"));
  }

  @Test
  void typesThatAreNotDefinedAreLeftOut() {
    assertTrue(model("no_msgs/msg/Such", "", null).eContents().isEmpty());
  }

  private static EObject model(String... types) {
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    for (String type : types) {
      Data data = EventchainFactory.eINSTANCE.createData();
      data.setMessageType(type);
      chain.getData().add(data);
    }
    return MessageModel.of(chain, MessageCatalog.of(List.of()));
  }

  private static Object value(EObject object, String feature) {
    return object.eGet(object.eClass().getEStructuralFeature(feature));
  }
}
