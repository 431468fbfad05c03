package dev.eventchain.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class TopicIndexTest {

  private final EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
  private final SoftwareNode writer = node("writer");
  private final SoftwareNode reader = node("reader");

  @Test
  void aRelativeNameIsThatOfTheRootNamespace() {
    writer.getOutput().add(data("a/x"));
    reader.getInput().add(data("/a/x"));
    reader.getInput().add(data("a/x"));
    TopicIndex index = TopicIndex.of(chain);
    assertEquals(1, index.topics().size());
    TopicIndex.Topic topic = index.find("/a/x").orElseThrow();
    assertEquals(List.of(new TopicIndex.Endpoint(writer, writer.getOutput())), topic.publishers());
    assertEquals(List.of(new TopicIndex.Endpoint(reader, reader.getInput())), topic.subscribers());
    assertTrue(index.find("a/x").isEmpty());
    assertEquals(List.of(reader), DataFlowIndex.of(chain).successors(writer));
  }

  @Test
  void aPrivateNameIsAnotherTopicForEachComponent() {
    Data shared = data("~/x");
    writer.getOutput().add(shared);
    reader.getInput().add(shared);
    SoftwareNode spy = node("spy");
    spy.getInput().add(data("writer/x"));
    TopicIndex index = TopicIndex.of(chain);
    assertEquals(
        List.of("/writer/x", "/reader/x"),
        index.topics().stream().map(TopicIndex.Topic::name).toList());
    assertEquals(List.of(spy), DataFlowIndex.of(chain).successors(writer));
    assertEquals(List.of(), DataFlowIndex.of(chain).producers(shared));
  }

  @Test
  void dataWithoutATopicAreOnNone() {
    writer.getOutput().add(data(null));
    reader.getInput().add(data(""));
    assertTrue(TopicIndex.of(chain).topics().isEmpty());
  }

  @Test
  void componentsInfluenceWhatIsDerivedFromTheirOutputs() {
    writer.getOutput().add(data("/x"));
    reader.getInput().add(data("/x"));
    reader.getOutput().add(data("/y"));
    SoftwareNode loop = node("loop");
    loop.getInput().add(data("/y"));
    loop.getOutput().add(data("/x"));
    SoftwareNode other = node("other");
    other.getOutput().add(data("/z"));
    SoftwareNode own = node("own");
    own.setImplementation(ComponentImplementation.NODE);
    own.getInput().add(data("/z"));
    own.getOutput().add(data("/w"));
    TopicIndex index = TopicIndex.of(chain);
    assertEquals(Set.of("/x", "/y"), index.influencedBy(List.of(writer)));
    assertEquals(Set.of("/z"), index.influencedBy(List.of(other)));
    assertEquals(Set.of(), index.influencedBy(List.of(own)));
  }

  private SoftwareNode node(String name) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    chain.getSoftware().add(node);
    return node;
  }

  private Data data(String topic) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setTopicName(topic);
    data.setFieldName("data");
    chain.getData().add(data);
    return data;
  }
}
