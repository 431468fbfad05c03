package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import java.util.Set;
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

  private Set<String> ofOthers(Set<String> own) {
    return new OutputPurpose(node).ofOthers("AEB-3", own, Set.of("/brake_force", "/warning"));
  }

  @Test
  void anOutputOfWhichOnlyOtherRequirementsNoticeFaultsIsTheirs() {
    output("/brake_force");
    output("/warning");
    assertEquals(Set.of("/warning"), ofOthers(Set.of("/brake_force")));
    assertEquals(Set.of(), ofOthers(Set.of()));
  }

  /** Otherwise, the design would ask for it, and nobody would say that it is not tested. */
  @Test
  void anOutputThatIsMarkedWithARequirementStaysItsOwn() {
    output("/brake_force", "AEB-3");
    output("/warning", "AEB-3", "AEB-4");
    assertEquals(Set.of(), ofOthers(Set.of("/brake_force")));
  }
}
