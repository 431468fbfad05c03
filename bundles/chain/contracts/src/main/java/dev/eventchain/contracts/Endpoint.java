package dev.eventchain.contracts;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;

/**
 * A publisher or subscription at run time: the data that a component writes to a topic or reads
 * from it.
 *
 * @param data the fields, in the order of the component; at least one
 */
record Endpoint(SoftwareNode node, List<Data> data) {

  /** Returns the name of the component for messages. */
  String name() {
    return "'" + node.getName() + "'";
  }

  /** Returns the element that represents the endpoint. */
  Data first() {
    return data.get(0);
  }

  /** Returns whether the published message leaves the chain; it does so with all of its fields. */
  boolean isExternal() {
    return data.stream().anyMatch(Data::isExternal);
  }

  /**
   * Returns the element with the effective profile: as in generated nodes, the first that has one.
   */
  Data holderOfQos() {
    return data.stream().filter(d -> d.getQos() != null).findFirst().orElse(first());
  }
}
