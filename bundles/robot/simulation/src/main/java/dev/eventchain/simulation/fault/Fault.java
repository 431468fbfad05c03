package dev.eventchain.simulation.fault;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.zip.CRC32;

/**
 * A fault in one run of one scenario.
 *
 * @param target name of a node or a topic; empty if the kind has no target
 * @param start start of the fault, in ns
 * @param end end of the fault (exclusive), in ns; {@link RunLog#NEVER}: until the end of the run
 * @param amount ns, messages, or parts of a million; 0 if the kind has none
 * @param expected the criteria that must hold in spite of it; empty if it is observed only
 * @param detection the required detection; empty if none is required
 * @param location its location in the file
 */
public record Fault(
    String name,
    Scenario scenario,
    FaultKind kind,
    String target,
    long start,
    long end,
    long amount,
    List<Expectation> expected,
    Optional<Detected> detection,
    SourceLocation location) {

  /**
   * Requirement that a fault is detected.
   *
   * @param within latest detection after its start, in s; empty for any time
   * @param location the location of the requirement in the file
   */
  public record Detected(OptionalDouble within, SourceLocation location) {}

  /** Copies the list. */
  public Fault {
    expected = List.copyOf(expected);
  }

  /** Returns the name of the recording of its run: that of the scenario, a dot and its own. */
  public String recording() {
    return scenario.name() + "." + name;
  }

  /** Returns whether the software must meet a requirement. */
  public boolean isJudged() {
    return !expected.isEmpty() || detection.isPresent();
  }

  /** Returns whether the fault is active at a time, in ns. */
  boolean isActive(long time) {
    return start <= time && time < end;
  }

  /**
   * Returns the seed for random effects, which depends only on the scenario's seed and the fault's
   * name.
   */
  long seed() {
    CRC32 digest = new CRC32();
    digest.update(name.getBytes(StandardCharsets.UTF_8));
    return scenario.seed() ^ (digest.getValue() << 20);
  }

  /** Returns the time on the clock of the nodes, in ns. */
  public long clock(long time) {
    return kind == FaultKind.CLOCK_JUMP && isActive(time) ? time + amount : time;
  }

  /** Returns the part of the configuration for the process of the nodes. */
  public ObjectNode toJson() {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("kind", kind.configured()).put("target", target).put("start", start);
    if (end < RunLog.NEVER) {
      json.put("end", end);
    } else {
      json.putNull("end");
    }
    return json.put("amount", amount).put("seed", seed());
  }

  /** Returns a description for users, such as {@code drop 50 percent of /scan from 2 s to 3 s}. */
  public String words() {
    String what =
        switch (kind) {
          case KILL -> "kill " + target;
          case STOP -> "stop " + target;
          case DELAY -> "delay each activation of " + target + " by " + number() + " ms";
          case FLOOD -> "flood: " + target + " publishes everything " + number() + " times more";
          case DROP -> "drop " + number() + " percent of " + target;
          case REPEAT -> "repeat messages on " + target + " " + number() + " times";
          case CORRUPT -> "corrupt messages on " + target;
          case CLOCK_JUMP -> "make the clock jump by " + number() + " ms";
          case DEAD_SENSOR -> "make the sensor of " + target + " die";
        };
    String from = what + String.format(Locale.ROOT, " from %s s", plain(start, 1e9));
    return end < RunLog.NEVER ? from + " to " + plain(end, 1e9) + " s" : from + " on";
  }

  private String number() {
    return plain(amount, kind.unit());
  }

  private static String plain(long amount, double unit) {
    return BigDecimal.valueOf(amount)
        .divide(BigDecimal.valueOf(unit))
        .stripTrailingZeros()
        .toPlainString();
  }
}
