package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.run.OutputRecord;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests the standard faults of outputs of each kind. */
class StandardFaultsTest {

  private static final String TYPE = "demo_msgs/msg/Brake";
  private static final MessageCatalog CATALOG =
      MessageCatalog.ofTexts(
          Map.of(
              TYPE,
              """
              uint8 OFF=0
              uint8 FULL=2
              std_msgs/Header header
              uint8 state
              bool active
              float32 force
              float32[] profile
              string reason
              """));

  private final SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();

  private Data output(String field) {
    node.setName("Brake");
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName(field);
    data.setTopicName("/brake");
    data.setMessageType("demo_msgs/Brake");
    data.setFieldName(field);
    node.getOutput().add(data);
    return data;
  }

  private List<String> faults(double... forces) {
    MessageType type = CATALOG.find(TYPE).orElseThrow();
    OutputRecord record =
        new OutputRecord(Map.of("/brake", List.of("force", "profile", "state", "active")));
    for (double force : forces) {
      MessageValue message = MessageValue.of(type).set("force", force);
      message.set("profile", List.of(force, 2 * force));
      record.add("/brake", message);
    }
    return StandardFaults.of(Output.of(node, CATALOG), List.of(record)).stream()
        .map(OutputFault::words)
        .map(words -> words.replace(" of Brake", ""))
        .toList();
  }

  private static final List<String> OF_MESSAGES =
      List.of(
          "/brake stuck at its first value",
          "/brake never sent",
          "/brake delayed by 100 ms",
          "/brake delayed by 300 ms",
          "/brake delayed by 1000 ms",
          "/brake renewed by every 10th message only");

  private static List<String> ofField(List<String> all) {
    assertEquals(OF_MESSAGES, all.subList(0, OF_MESSAGES.size()));
    return all.subList(OF_MESSAGES.size(), all.size());
  }

  @Test
  void number() {
    output("force");
    assertEquals(
        List.of(
            "/brake.force stuck at 0",
            "/brake.force stuck at 0.5",
            "/brake.force with the other sign",
            "/brake.force scaled by 2",
            "/brake.force scaled by 0.5",
            "/brake.force shifted by 0.1",
            "/brake.force shifted by -0.1",
            "/brake.force with noise of 0.1"),
        ofField(faults(0, 0.5)));
  }

  @Test
  void numberWithUnitAndSafeValue() {
    Data force = output("force");
    force.setUnit("m/s2");
    force.setSafeValue("-3");
    assertEquals(
        List.of(
            "/brake.force stuck at -3 m/s2",
            "/brake.force stuck at 4 m/s2",
            "/brake.force with the other sign",
            "/brake.force scaled by 2",
            "/brake.force scaled by 0.5",
            "/brake.force shifted by 1 m/s2",
            "/brake.force shifted by -1 m/s2",
            "/brake.force with noise of 1 m/s2"),
        ofField(faults(2, 4)));
  }

  @Test
  void numberThatWasNeverSent() {
    output("force");
    assertEquals(List.of(), ofField(faults()));
  }

  @Test
  void truth() {
    output("active");
    assertEquals(
        List.of("/brake.active stuck at 0", "/brake.active stuck at 1", "/brake.active negated"),
        ofField(faults(1)));
  }

  @Test
  void enumeration() {
    output("state");
    assertEquals(List.of("/brake.state stuck at 0", "/brake.state stuck at 2"), ofField(faults(1)));
  }

  @Test
  void arrayOfNumbers() {
    output("profile");
    assertEquals(8, ofField(faults(1)).size());
  }

  @Test
  void textAndHeaderHaveFaultsOfMessagesOnlyOrNone() {
    output("reason");
    output("header.stamp.sec");
    assertEquals(List.of(), ofField(faults(1)));
  }

  @Test
  void eachOfSeveralFieldsMayBeStuckAtItsFirstValue() {
    output("active");
    output("state");
    List<String> fields = ofField(faults(1));
    assertEquals("/brake.active stuck at its first value", fields.get(0));
    assertEquals("/brake.state stuck at its first value", fields.get(4));
  }
}
