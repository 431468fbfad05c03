package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests which requirements of a component the faults of each of its outputs count for. */
class OutputPurposeTest {

  private final SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();

  private void output(String topic, String... requirements) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setTopicName(topic);
    for (String id : requirements) {
      Requirement requirement = EventchainFactory.eINSTANCE.createRequirement();
      requirement.setId(id);
      data.getSatisfies().add(requirement);
    }
    node.getOutput().add(data);
  }

  private boolean mayServe(String topic, String requirement) {
    return new OutputPurpose(node).mayServe(topic, requirement);
  }

  @Test
  void anOutputMayServeEachRequirementOfItsComponent() {
    output("/brake_force");
    output("/warning");
    assertTrue(mayServe("/brake_force", "AEB-3"));
    assertTrue(mayServe("/warning", "AEB-4"));
  }

  @Test
  void anOutputThatIsMarkedServesNoOtherRequirement() {
    output("/brake_force");
    output("/emergency", "AEB-3");
    assertFalse(mayServe("/emergency", "AEB-4"));
    assertTrue(mayServe("/emergency", "AEB-3"));
    assertTrue(mayServe("/brake_force", "AEB-3"));
    assertTrue(mayServe("/brake_force", "AEB-4"));
    assertEquals(List.of("/emergency"), new OutputPurpose(node).markedWith("AEB-3").toList());
    assertEquals(List.of(), new OutputPurpose(node).markedWith("AEB-4").toList());
  }

  @Test
  void aRequirementThatNothingElseServesIsServedByAllOutputs() {
    output("/emergency", "AEB-3");
    assertTrue(mayServe("/emergency", "AEB-4"));
  }
}
