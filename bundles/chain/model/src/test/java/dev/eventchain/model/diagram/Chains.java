package dev.eventchain.model.diagram;

import dev.eventchain.model.eventchain.ComponentOrigin;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.Random;

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
      for (String topic : sides[0].strip().split(" +", -1)) {
        addData(chain, node, topic, true);
      }
      for (String topic : sides[1].strip().split(" +", -1)) {
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

  static Data addData(EventChain chain, SoftwareNode node, String topic, boolean isInput) {
    if (topic.isEmpty()) {
      return null;
    }
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName(topic);
    data.setTopicName("/" + topic);
    chain.getData().add(data);
    (isInput ? node.getInput() : node.getOutput()).add(data);
    return data;
  }

  /** Returns a random chain, with cycles, loops, shared topics and names of any length. */
  static EventChain random(long seed) {
    Random random = new Random(seed);
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    int topics = 1 + random.nextInt(12);
    for (int count = random.nextInt(14); count > 0; count--) {
      SoftwareNode node = add(chain, "x".repeat(random.nextInt(4) == 0 ? random.nextInt(200) : 5));
      node.setOrigin(random.nextBoolean() ? ComponentOrigin.GENERATED : ComponentOrigin.EXISTING);
      for (int ends = random.nextInt(5); ends > 0; ends--) {
        Data data = addData(chain, node, "t" + random.nextInt(topics), random.nextBoolean());
        data.setExternal(random.nextInt(8) == 0);
      }
      if (random.nextInt(3) == 0) {
        node.setNextstep(chain.getSoftware().get(random.nextInt(chain.getSoftware().size())));
      }
    }
    return chain;
  }
}
