package dev.eventchain.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import org.junit.jupiter.api.Test;

class DataFlowIndexTest {

  private final EventChain chain = EventchainFactory.eINSTANCE.createEventChain();

  @Test
  void followsForksAndJoinsInChainOrder() {
    SoftwareNode source = node("source", "", "/a.data");
    SoftwareNode right = node("right", "/a.data", "/b.data");
    SoftwareNode left = node("left", "/a.data", "/c.data");
    SoftwareNode sink = node("sink", "/c.data /b.data", "");
    DataFlowIndex index = DataFlowIndex.of(chain);
    assertEquals(List.of(right, left), index.successors(source));
    assertEquals(List.of(sink), index.successors(right));
    assertEquals(List.of(sink), index.successors(left));
    assertEquals(List.of(), index.successors(sink));
    assertEquals(List.of(), index.cycles());
    assertEquals(source.getOutput(), index.producers(left.getInput().get(0)));
  }

  @Test
  void needsTheFieldAndNotOnlyTheTopic() {
    SoftwareNode writer = node("writer", "", "/odometry.pose.position /odometry.twist");
    SoftwareNode part = node("part", "/odometry.pose.position.x", "");
    SoftwareNode whole = node("whole", "/odometry.pose", "");
    node("other", "/odometry.header", "");
    node("similar", "/odometry.pose.positions", "");
    assertEquals(List.of(part, whole), DataFlowIndex.of(chain).successors(writer));
  }

  @Test
  void findsCyclesOfAnyLength() {
    SoftwareNode alone = node("alone", "/x.data", "/x.data");
    SoftwareNode first = node("first", "/c.data", "/a.data");
    SoftwareNode second = node("second", "/a.data", "/b.data");
    SoftwareNode third = node("third", "/b.data", "/c.data");
    node("after", "/c.data", "/d.data");
    assertEquals(
        List.of(List.of(alone), List.of(first, second, third)), DataFlowIndex.of(chain).cycles());
  }

  @Test
  void walksALongCycleWithoutRecursion() {
    int length = 20_000;
    for (int i = 0; i < length; i++) {
      node("n" + i, "/t" + i + ".data", "/t" + (i + 1) % length + ".data");
    }
    List<List<SoftwareNode>> cycles = DataFlowIndex.of(chain).cycles();
    assertEquals(1, cycles.size());
    assertEquals(chain.getSoftware(), cycles.get(0));
  }

  @Test
  void countsAWriterAndReaderOfOneSharedDataOnce() {
    SoftwareNode writer = node("writer", "", "/a.data");
    SoftwareNode reader = node("reader", "", "");
    reader.getInput().add(writer.getOutput().get(0));
    assertEquals(List.of(reader), DataFlowIndex.of(chain).successors(writer));
  }

  @Test
  void ignoresDataWithoutATopicOrField() {
    SoftwareNode writer = node("writer", "", "/a.data");
    SoftwareNode reader = node("reader", "/a.data", "");
    reader.getInput().get(0).setFieldName(null);
    writer.getOutput().add(data(""));
    assertEquals(List.of(), DataFlowIndex.of(chain).successors(writer));
  }

  private SoftwareNode node(String name, String inputs, String outputs) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    chain.getSoftware().add(node);
    for (String input : inputs.isEmpty() ? new String[0] : inputs.split(" ")) {
      node.getInput().add(data(input));
    }
    for (String output : outputs.isEmpty() ? new String[0] : outputs.split(" ")) {
      node.getOutput().add(data(output));
    }
    return node;
  }

  private Data data(String topicAndField) {
    Data data = EventchainFactory.eINSTANCE.createData();
    int dot = topicAndField.indexOf('.');
    if (dot > 0) {
      data.setTopicName(topicAndField.substring(0, dot));
      data.setFieldName(topicAndField.substring(dot + 1));
    }
    chain.getData().add(data);
    return data;
  }
}
