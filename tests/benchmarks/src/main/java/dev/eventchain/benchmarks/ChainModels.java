package dev.eventchain.benchmarks;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;

/**
 * Chains of any size: lines of ten nodes, each with two inputs and two outputs, and an end-to-end
 * latency constraint per line.
 */
final class ChainModels {

  private static final int LINE = 10;
  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  private ChainModels() {}

  /**
   * Returns a chain without violations; its first node reads its own output, which is a warning.
   */
  static EventChain sound(int nodes) {
    EventChain chain = FACTORY.createEventChain();
    chain.setName("chain");
    for (int i = 0; i < nodes; i++) {
      chain.getSoftware().add(node(chain, i));
    }
    for (int i = 0; i < nodes; i++) {
      SoftwareNode node = chain.getSoftware().get(i);
      if (i % LINE != LINE - 1 && i + 1 < nodes) {
        node.setNextstep(chain.getSoftware().get(i + 1));
      }
    }
    for (int i = 0; i + LINE <= nodes; i += LINE) {
      LatencyConstraint constraint = FACTORY.createLatencyConstraint();
      constraint.setName("latency" + i);
      constraint.setFirst(chain.getSoftware().get(i));
      constraint.setLast(chain.getSoftware().get(i + LINE - 1));
      constraint.setMaximum(600.0);
      chain.getLatencyConstraints().add(constraint);
    }
    return chain;
  }

  private static SoftwareNode node(EventChain chain, int i) {
    SoftwareNode node = FACTORY.createSoftwareNode();
    node.setName("Node" + i);
    node.setFrequency(20.0);
    node.setBestCaseExecutionTime(1.0);
    node.setWorstCaseExecutionTime(2.0);
    for (int port = 0; port < 2; port++) {
      Data input = data("in" + port, topic(Math.max(0, i - 1), port));
      Data output = data("out" + port, topic(i, port));
      chain.getData().add(input);
      chain.getData().add(output);
      node.getInput().add(input);
      node.getOutput().add(output);
    }
    return node;
  }

  private static String topic(int node, int port) {
    return "/topic" + node + "/port" + port;
  }

  private static Data data(String name, String topic) {
    Data data = FACTORY.createData();
    data.setName(name);
    data.setTopicName(topic);
    data.setMessageType("std_msgs/msg/Float32");
    data.setFieldName("data");
    return data;
  }

  /**
   * Returns a chain with every kind of fault that the rules of the benchmarks find, some of them
   * often.
   */
  static EventChain faulty(int nodes) {
    EventChain chain = sound(nodes);
    for (int i = 0; i < nodes; i++) {
      SoftwareNode node = chain.getSoftware().get(i);
      switch (i % 101) {
        case 3 -> node.getInput().clear();
        case 8 -> node.getOutput().clear();
        case 12 -> node.setFrequency(10.0 + i % 20);
        case 25 -> node.setFrequency(0.0);
        case 31 -> node.setName("node" + i);
        case 37 -> node.setName("Node1");
        case 44 -> node.setNextstep(chain.getSoftware().get(i - i % LINE));
        case 52 -> node.getInput().get(0).setName("in1");
        case 58 -> node.getOutput().get(0).setTopicName(node.getOutput().get(1).getTopicName());
        case 63 -> node.getOutput().get(0).setTopicName("topic");
        case 66 -> node.setBestCaseExecutionTime(3.0);
        case 71 -> node.setWorstCaseExecutionTime(60.0);
        case 77 -> node.getInput().get(0).setTopicName("/nobody");
        case 84 -> node.getInput().get(1).setFieldName("");
        case 86 -> node.setName("X".repeat(70));
        case 90 -> node.setNextstep(chain.getSoftware().get((i + 40) % nodes));
        default -> {}
      }
    }
    chain.getLatencyConstraints().get(0).setMaximum(0.0);
    chain.getSoftware().get(0).setFrequency(1.0e9);
    chain.getSoftware().get(79).setNextstep(chain.getSoftware().get(80));
    chain.getData().add(data("spare", "/spare"));
    return chain;
  }
}
