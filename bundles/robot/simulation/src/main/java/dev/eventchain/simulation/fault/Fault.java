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
 * Something that goes wrong in one run of one scenario.
 *
 * @param target name of a node or a topic; empty if it happens to none
 * @param start from when on, in ns
 * @param end until when, in ns; that time is no longer part of it; {@link RunLog#NEVER}: to the end
 * @param amount ns, messages, or parts of a million; 0 if the kind has none
 * @param expected what must hold in spite of it; empty if it is observed only
 * @param detection whether it must be detected
 * @param location where the file says so
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
   * That a fault must be detected.
   *
   * @param within s from its start; empty if it does not matter when
   * @param location where the file asks for it
   */
  public record Detected(OptionalDouble within, SourceLocation location) {}

  /** Copies the list. */
  public Fault {
    expected = List.copyOf(expected);
  }

  /** Whether something is asked of the software. */
  public boolean isJudged() {
    return !expected.isEmpty() || detection.isPresent();
  }

  /** Whether there is something wrong at a time, in ns. */
  boolean isActive(long time) {
    return start <= time && time < end;
  }

  /** Of what is random: it depends on the scenario's seed and the fault's name only. */
  long seed() {
    CRC32 digest = new CRC32();
    digest.update(name.getBytes(StandardCharsets.UTF_8));
    return scenario.seed() ^ (digest.getValue() << 20);
  }

  /** The time on the clock that the nodes see, in ns. */
  public long clock(long time) {
    return kind == FaultKind.CLOCK_JUMP && isActive(time) ? time + amount : time;
  }

  /** The part of the configuration that tells the process of the nodes. */
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

  /** What happens, for people, such as {@code drop 50 percent of /scan from 2 s to 3 s}. */
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
