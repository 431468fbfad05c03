package dev.eventchain.simulation.fault;

import dev.eventchain.documents.NumberRange;
import java.util.Arrays;
import java.util.List;

/** Kinds of faults. */
public enum FaultKind {
  /** The process of a node ends. */
  KILL("kill", Target.NODE, "", 0),
  /** The process of a node stops and continues, as by SIGSTOP and SIGCONT. */
  STOP("stop", Target.NODE, "", 0),
  /** Each activation of a node takes longer. */
  DELAY("delay", Target.NODE, "ms", 1e6),
  /** Everything that a node publishes is repeated several times. */
  FLOOD("flood", Target.NODE, "times", 1),
  /** Messages on a topic get lost. */
  DROP("drop", Target.TOPIC, "percent", 1e4),
  /** Messages on a topic are repeated several times. */
  REPEAT("repeat", Target.TOPIC, "times", 1),
  /** Messages on a topic arrive with altered bytes. */
  CORRUPT("corrupt", Target.TOPIC, "", 0),
  /** The clock jumps, and with it the time stamps of messages. */
  CLOCK_JUMP("clock_jump_ms", Target.NOTHING, "", 1e6),
  /** A sensor falls silent. */
  DEAD_SENSOR("dead_sensor", Target.SENSOR, "", 0);

  /** Target of a kind of fault. */
  enum Target {
    NODE,
    TOPIC,
    SENSOR,
    NOTHING
  }

  private static final double MOST_MILLISECONDS = 600_000;
  private static final int MOST_TIMES = 100;

  private final String key;
  private final Target target;
  private final String amount;
  private final double unit;

  FaultKind(String key, Target target, String amount, double unit) {
    this.key = key;
    this.target = target;
    this.amount = amount;
    this.unit = unit;
  }

  /** Returns all keys, in the order of this list. */
  static List<String> keys() {
    return Arrays.stream(values()).map(FaultKind::key).toList();
  }

  /** Returns the key in the file. */
  String key() {
    return key;
  }

  Target target() {
    return target;
  }

  /**
   * Returns the key of its amount; empty if it has none, or if the key of the kind holds the
   * amount.
   */
  String amount() {
    return amount;
  }

  /**
   * Returns the factor from the amount in the file to the configured one: ns, messages, or parts
   * per million.
   */
  double unit() {
    return unit;
  }

  /** Returns whether its amount has a key next to the target's. */
  boolean hasAmount() {
    return !amount.isEmpty();
  }

  /** Returns whether it affects the messages of a topic. */
  public boolean isAboutMessages() {
    return target == Target.TOPIC || target == Target.SENSOR;
  }

  /** Returns the range of its amount. */
  NumberRange range() {
    return switch (this) {
      case DELAY -> NumberRange.of(0.001, MOST_MILLISECONDS);
      case DROP -> NumberRange.of(0.0001, 100);
      case CLOCK_JUMP -> NumberRange.of(-MOST_MILLISECONDS, MOST_MILLISECONDS);
      default -> NumberRange.of(1, MOST_TIMES);
    };
  }

  /** Returns its name in the configuration of the process. */
  String configured() {
    return this == CLOCK_JUMP ? "clock_jump" : key;
  }
}
