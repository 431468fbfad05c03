package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests in which components a requirement ends, and which ones only contribute to them. */
class BranchesTest {

  private final SoftwareNode distance = node("Distance", "/scan", "/distance");
  private final SoftwareNode time = node("Time", "/distance", "/time");
  private final SoftwareNode warner = node("Warner", "/time", "/warning");
  private final SoftwareNode brake = node("Brake", "/time", "/brake");

  private static SoftwareNode node(String name, String input, String output) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    node.getInput().add(data(input));
    node.getOutput().add(data(output));
    return node;
  }

  private static Data data(String topic) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setTopicName(topic);
    data.setFieldName("data");
    return data;
  }

  private static void mark(SoftwareNode node) {
    Requirement requirement = EventchainFactory.eINSTANCE.createRequirement();
    requirement.setId("AEB-3");
    node.getOutput().get(0).getSatisfies().add(requirement);
  }

  private List<List<String>> of(SoftwareNode... components) {
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    for (SoftwareNode node : List.of(distance, time, warner, brake)) {
      chain.getSoftware().add(node);
      chain.getData().addAll(node.getInput());
      chain.getData().addAll(node.getOutput());
    }
    return new Branches(DataFlowIndex.of(chain)).of("AEB-3", List.of(components));
  }

  @Test
  void componentsContributeToTheOneInWhichTheDataFlowEnds() {
    assertEquals(List.of(List.of("Brake", "Distance")), of(distance, brake));
    assertEquals(List.of(List.of("Time", "Distance")), of(distance, time));
  }

  @Test
  void whatContributesToSeveralBranchesBelongsToNone() {
    assertEquals(List.of(List.of("Warner"), List.of("Brake")), of(distance, time, warner, brake));
  }

  @Test
  void componentsOfACycleAreBranchesOfTheirOwn() {
    distance.getInput().add(data("/time"));
    assertEquals(List.of(List.of("Distance"), List.of("Time")), of(distance, time));
    assertEquals(List.of("Brake", "Distance", "Time"), of(distance, time, brake).get(0));
  }

  @Test
  void onlyTheComponentsOfMarkedOutputsAreBranches() {
    Stream.of(time, brake).forEach(BranchesTest::mark);
    assertEquals(List.of(List.of("Time"), List.of("Brake")), of(distance, time, brake));
  }
}
