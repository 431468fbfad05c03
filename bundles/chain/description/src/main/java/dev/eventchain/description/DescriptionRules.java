package dev.eventchain.description;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about descriptions of chains. */
public final class DescriptionRules {

  public static final Rule CHAIN_EMPTY = Rule.error("modeler.chain.empty");
  public static final Rule CONSUMER_UNKNOWN = Rule.error("modeler.consumer.unknown");
  public static final Rule FIELD_ILLEGAL = Rule.error("modeler.field.illegal");
  public static final Rule NAME_DUPLICATE = Rule.error("modeler.name.duplicate");
  public static final Rule NAME_ILLEGAL = Rule.error("modeler.name.illegal");
  public static final Rule QOS_UNKNOWN = Rule.error("modeler.qos.unknown");
  public static final Rule SYNCHRONIZED_UNKNOWN = Rule.error("modeler.synchronized.unknown");
  public static final Rule TOPIC_ILLEGAL = Rule.error("modeler.topic.illegal");
  public static final Rule TYPE_ILLEGAL = Rule.error("modeler.type.illegal");

  private DescriptionRules() {}
}
