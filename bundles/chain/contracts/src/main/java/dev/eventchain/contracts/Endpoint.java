package dev.eventchain.contracts;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;

/**
 * One publisher or subscription as it will exist at run time: what a component writes to a topic,
 * or reads from it.
 *
 * @param data the fields, in the order of the component; at least one
 */
record Endpoint(SoftwareNode node, List<Data> data) {

  /** The component, as messages speak of it. */
  String name() {
    return "'" + node.getName() + "'";
  }

  /** The element that stands for the endpoint. */
  Data first() {
    return data.get(0);
  }

  /** Whether what is published leaves the chain: a message does so with all of its fields. */
  boolean isExternal() {
    return data.stream().anyMatch(Data::isExternal);
  }

  /** The element whose profile counts: generated nodes take the first that there is. */
  Data holderOfQos() {
    return data.stream().filter(d -> d.getQos() != null).findFirst().orElse(first());
  }
}
