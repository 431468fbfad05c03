package dev.eventchain.simulation.host;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.sandbox.ComponentRules;
import dev.eventchain.simulation.bench.BenchRules;
import java.util.List;
import java.util.Optional;

/** Rules of the findings about processes that run nodes. Some come as text from these processes. */
public final class HostRules {

  public static final Rule MESSAGE_DEFINITION = Rule.error("message.definition");
  public static final Rule MESSAGE_MALFORMED = Rule.error("message.malformed");
  public static final Rule NODE_CLASS_MISSING = Rule.error("node.class.missing");
  public static final Rule NODE_ENDPOINT_LATE = Rule.error("node.endpoint.late");
  public static final Rule NODE_FAILED = Rule.error("node.failed");
  public static final Rule NODE_SYNTAX = Rule.error("node.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule NODE_TIMEOUT = Rule.error("node.timeout");
  public static final Rule PROTOCOL_FRAME = Rule.error("protocol.frame");
  public static final Rule QOS_INCOMPATIBLE = Rule.warning("qos.incompatible");
  public static final Rule SIMULATION_LIMIT = Rule.error("simulation.limit");
  public static final Rule SIMULATION_PROCESS_ENDED = Rule.error("simulation.process.ended");
  public static final Rule SIMULATION_PROTOCOL = Rule.error("simulation.protocol");
  public static final Rule SIMULATION_RUN_TIMEOUT = Rule.error("simulation.run.timeout");
  public static final Rule SIMULATION_STEP_TIMEOUT = Rule.error("simulation.step.timeout");
  public static final Rule TOPIC_TYPE_MISMATCH = Rule.warning("topic.type.mismatch");

  private static final List<Rule> REPORTED =
      List.of(
          BenchRules.MESSAGE_UNKNOWN,
          MESSAGE_DEFINITION,
          MESSAGE_MALFORMED,
          NODE_CLASS_MISSING,
          NODE_ENDPOINT_LATE,
          NODE_FAILED,
          NODE_SYNTAX,
          NODE_TIMEOUT,
          PROTOCOL_FRAME,
          QOS_INCOMPATIBLE,
          SIMULATION_LIMIT,
          TOPIC_TYPE_MISMATCH);

  private HostRules() {}

  /** Returns the rule of an id that a process reported, which may be about a component. */
  public static Optional<Rule> find(String id) {
    return Rule.find(id, REPORTED).or(() -> ComponentRules.find(id));
  }
}
