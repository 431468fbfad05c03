package dev.eventchain.model;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.Processor;
import dev.eventchain.model.eventchain.SoftwareNode;

/** Processors of a chain by name, for where components name them. */
public final class Processors {

  private Processors() {}

  /** Maps a component to the chain's processor of a name, which is added if there is none. */
  public static Processor map(SoftwareNode node, String name, EventChain chain) {
    Processor processor =
        chain.getProcessors().stream()
            .filter(each -> name.equals(each.getName()))
            .findFirst()
            .orElseGet(() -> added(name, chain));
    node.setMappedTo(processor);
    return processor;
  }

  private static Processor added(String name, EventChain chain) {
    Processor processor = EventchainFactory.eINSTANCE.createProcessor();
    processor.setName(name);
    chain.getProcessors().add(processor);
    return processor;
  }
}
