package dev.eventchain.simulation.fault;

import dev.eventchain.documents.NumberRange;
import java.util.Arrays;
import java.util.List;

/** What can be wrong in a run. */
public enum FaultKind {
  /** A node's process ends. */
  KILL("kill", Target.NODE, "", 0),
  /** A node's process stops and continues, as by SIGSTOP and SIGCONT. */
  STOP("stop", Target.NODE, "", 0),
  /** Each activation of a node takes longer. */
  DELAY("delay", Target.NODE, "ms", 1e6),
  /** Everything that a node publishes is published several times more. */
  FLOOD("flood", Target.NODE, "times", 1),
  /** Messages on a topic get lost. */
  DROP("drop", Target.TOPIC, "percent", 1e4),
  /** Messages on a topic come several times more. */
  REPEAT("repeat", Target.TOPIC, "times", 1),
  /** Messages on a topic come with other bytes. */
  CORRUPT("corrupt", Target.TOPIC, "", 0),
  /** The clock shows another time, as do the stamps of messages. */
  CLOCK_JUMP("clock_jump_ms", Target.NOTHING, "", 1e6),
  /** A sensor falls silent. */
  DEAD_SENSOR("dead_sensor", Target.SENSOR, "", 0);

  /** What it happens to. */
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

  /** All keys, in the order of this list. */
  static List<String> keys() {
    return Arrays.stream(values()).map(FaultKind::key).toList();
  }

  /** The key in the file. */
  String key() {
    return key;
  }

  Target target() {
    return target;
  }

  /** The key of its amount; empty if it has none, or the key of the kind holds it. */
  String amount() {
    return amount;
  }

  /** What one of the amount is in the configuration: ns, messages, or parts of a million. */
  double unit() {
    return unit;
  }

  /** Whether its amount stands next to its target. */
  boolean hasAmount() {
    return !amount.isEmpty();
  }

  /** Whether it is about the messages of a topic. */
  public boolean isAboutMessages() {
    return target == Target.TOPIC || target == Target.SENSOR;
  }

  /** What its amount may be. */
  NumberRange range() {
    return switch (this) {
      case DELAY -> NumberRange.of(0.001, MOST_MILLISECONDS);
      case DROP -> NumberRange.of(0.0001, 100);
      case CLOCK_JUMP -> NumberRange.of(-MOST_MILLISECONDS, MOST_MILLISECONDS);
      default -> NumberRange.of(1, MOST_TIMES);
    };
  }

  /** What the process that runs the nodes calls it. */
  String configured() {
    return this == CLOCK_JUMP ? "clock_jump" : key;
  }
}
