package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Rule;

/** Rules of contracts, in the order of reports. */
@SuppressWarnings("ImmutableEnumChecker") // rules are immutable
public enum ContractRule {
  MESSAGE_UNKNOWN(Rule.error("contract.message.unknown")),
  FIELD_UNKNOWN(Rule.error("contract.field.unknown")),
  TYPE_MISMATCH(Rule.error("contract.type.mismatch")),
  AGE(Rule.error("contract.age.impossible")),
  TRANSPORT(Rule.error("contract.transport.impossible")),
  SAFE_VALUE(Rule.error("contract.value.unfit")),
  SYNCHRONIZED_IMPOSSIBLE(Rule.error("contract.synchronized.impossible")),
  SYNCHRONIZED_HEADER(Rule.error("contract.synchronized.header")),
  TOPIC_TYPE(Rule.error("contract.topic.type")),
  FIELD_UNSET(Rule.error("contract.field.unset")),
  UNIT_MISMATCH(Rule.error("contract.unit.mismatch")),
  UNIT_UNCONVERTED(Rule.error("contract.unit.unconverted")),
  QOS_AMBIGUOUS(Rule.warning("contract.qos.ambiguous")),
  QOS_INCOMPATIBLE(Rule.error("contract.qos.incompatible")),
  QOS_UNDECIDED(Rule.info("contract.qos.undecided")),
  PUBLISHER_MISSING(Rule.error("contract.publisher.missing")),
  CONSUMER_MISSING(Rule.error("contract.consumer.missing")),
  EXTERNAL_INPUT(Rule.error("contract.external.input")),
  PUBLISHERS_SEVERAL(Rule.warning("contract.publishers.several")),
  SIGNAL_TYPE(Rule.error("contract.signal.type")),
  SIGNAL_FIELD(Rule.warning("contract.signal.field")),
  SIGNAL_DIRECTION(Rule.error("contract.signal.direction")),
  NEXTSTEP_CYCLE(Rule.error("chain.nextstep.cycle")),
  FLOW_CYCLE(Rule.warning("chain.flow.cycle")),
  FLOW_DEADLOCK(Rule.error("chain.flow.deadlock")),
  LATENCY_UNCONNECTED(Rule.error("chain.latency.unconnected")),
  LATENCY_BOUND(Rule.error("chain.latency.bound")),
  LATENCY_UNKNOWN(Rule.info("chain.latency.unknown")),
  PROCESSOR_OVERLOADED(Rule.error("chain.processor.overloaded")),
  PROCESSOR_LATE(Rule.warning("chain.processor.late")),
  PROCESSOR_UNKNOWN(Rule.info("chain.processor.unknown"));

  private final Rule rule;

  ContractRule(Rule rule) {
    this.rule = rule;
  }

  /** Returns the rule; its severity is the highest of its findings. */
  public Rule rule() {
    return rule;
  }

  /** Returns the id of its findings. */
  public String id() {
    return rule.id();
  }
}
