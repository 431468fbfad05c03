package dev.eventchain.agents.chain;

import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Port;
import dev.eventchain.description.ChainNames;
import java.util.HashMap;
import java.util.Map;

/** Checks that the components of a chain description are in the order of their data flow. */
final class OrderCheck {
  private final Findings findings;

  OrderCheck(Findings findings) {
    this.findings = findings;
  }

  void check(ChainView chain) {
    Map<String, Integer> writers = new HashMap<>();
    for (int i = 0; i < chain.components().size(); i++) {
      for (Port port : chain.components().get(i).outputs()) {
        writers.putIfAbsent(port.topic(), i);
      }
    }
    for (int i = 0; i < chain.components().size(); i++) {
      for (Port port : chain.components().get(i).inputs()) {
        int writer = writers.getOrDefault(port.topic(), -1);
        if (writer > i) {
          report(port, chain.components().get(writer));
        }
      }
    }
  }

  private void report(Port port, Component writer) {
    findings.add(
        ChainRules.ORDER,
        port.pointer() + "/" + ChainNames.TOPIC,
        "%s is written by '%s', which comes later in the chain."
            .formatted(port.topic(), writer.name()),
        "Put components into the order of the data flow, unless this is a feedback loop.");
  }
}
