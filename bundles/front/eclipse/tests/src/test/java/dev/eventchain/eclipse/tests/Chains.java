package dev.eventchain.eclipse.tests;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;

/** Event chains for tests of the picture. */
final class Chains {

  private Chains() {}

  /** Returns a chain whose components read and write the topics in texts such as "a b &gt; c". */
  static EventChain of(String... components) {
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    chain.setName("test");
    for (int i = 0; i < components.length; i++) {
      SoftwareNode node = add(chain, "N" + i);
      String[] sides = (" " + components[i] + " ").split(">", 2);
      for (String topic : sides[0].strip().split(" +")) {
        addData(chain, node, topic, true);
      }
      for (String topic : sides[1].strip().split(" +")) {
        addData(chain, node, topic, false);
      }
    }
    return chain;
  }

  static SoftwareNode add(EventChain chain, String name) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    chain.getSoftware().add(node);
    return node;
  }

  private static void addData(EventChain chain, SoftwareNode node, String topic, boolean isInput) {
    if (topic.isEmpty()) {
      return;
    }
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName(topic);
    data.setTopicName("/" + topic);
    chain.getData().add(data);
    (isInput ? node.getInput() : node.getOutput()).add(data);
  }
}
