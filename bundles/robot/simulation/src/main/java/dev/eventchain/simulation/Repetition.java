package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.run.MessageLog;
import dev.eventchain.simulation.run.MessageLog.Difference;
import dev.eventchain.simulation.run.MessageLog.Message;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.strength.StrengthTrials;
import dev.eventchain.simulation.world.World;
import java.lang.reflect.Array;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * One scenario that is driven twice, and the comparison of what was published. The second run is in
 * a new process that orders sets and hashes texts differently, as every other process does.
 */
final class Repetition {

  /** Seed of Python's hashes in the second run; all other runs have 0. */
  static final int HASH_SEED = 4_021;

  private static final int LONGEST_VALUE = 40;
  private static final String HINT =
      "Look for the order of a set, hash() and id() of objects, files, clocks and random numbers: the"
          + " same inputs have to give the same outputs.";

  private final SimulatedChain chain;
  private final Scenario scenario;
  private final MessageLog first = new MessageLog();
  private final MessageLog second = new MessageLog();

  private Repetition(SimulatedChain chain, Scenario scenario) {
    this.chain = chain;
    this.scenario = scenario;
  }

  /**
   * Returns the repetition of the shortest scenario; empty if the request leads to no verdict, or
   * the runs would differ without reason, in real time.
   */
  static Optional<Repetition> of(SimulationRequest request, SimulatedChain chain) {
    boolean isRepeated =
        request.settings().driver() == SimulationDriver.LOCKSTEP && request.settings().complete();
    return (isRepeated ? request.scenarios().stream() : Stream.<Scenario>empty())
        .min(Comparator.comparing(Scenario::duration).thenComparing(Scenario::name))
        .map(shortest -> new Repetition(chain, shortest));
  }

  Scenario scenario() {
    return scenario;
  }

  /** Returns the log of the first run. */
  MessageLog first() {
    return first;
  }

  /** Returns the log of the second run. */
  MessageLog second() {
    return second;
  }

  /** Returns the finding that the runs differ; empty if they do not. */
  Optional<Diagnostic> finding() {
    return first.differenceFrom(second).map(this::finding);
  }

  /** Returns the finding that only the second run could not be finished. */
  Diagnostic ended(Diagnostic cause) {
    String message = "the second run ended: " + cause.message();
    return finding(message, cause.location().element());
  }

  private Diagnostic finding(Difference difference) {
    Message earliest =
        Stream.concat(difference.first().stream(), difference.second().stream())
            .min(Comparator.comparingLong(Message::time))
            .orElseThrow();
    String writer = chain.writer(earliest.topic());
    String what =
        String.format(
            Locale.ROOT,
            "'%s' did not repeat itself after %.3f s: %s",
            writer,
            World.seconds(earliest.time()),
            words(difference, earliest));
    return finding(what, writer);
  }

  private Diagnostic finding(String what, String component) {
    return Diagnostic.of(
            SimulationRules.SIMULATION_NOT_REPEATABLE,
            "Scenario " + scenario.name() + " was driven twice, and " + what,
            SourceLocation.NONE.withElement(component))
        .withHint(HINT);
  }

  private String words(Difference difference, Message earliest) {
    boolean both = difference.first().isPresent() && difference.second().isPresent();
    if (both && isSameMoment(difference)) {
      return values(difference.first().get(), difference.second().get())
          .orElse("the content of " + earliest.topic() + " was another one in the second run.");
    }
    boolean inFirst = difference.first().filter(earliest::equals).isPresent();
    return earliest.topic()
        + " was then published in the "
        + (inFirst ? "first" : "second")
        + " run only.";
  }

  private static boolean isSameMoment(Difference difference) {
    Message one = difference.first().orElseThrow();
    Message other = difference.second().orElseThrow();
    return one.time() == other.time() && one.topic().equals(other.topic());
  }

  /** Returns the first field with two values, in words. */
  private Optional<String> values(Message one, Message other) {
    Optional<MessageType> type =
        chain.typedTopicsWritten().stream()
            .filter(topic -> topic.name().equals(one.topic()))
            .map(TypedTopic::type)
            .flatMap(name -> chain.catalog().find(name).stream())
            .findFirst();
    if (type.isEmpty() || !one.isWhole() || !other.isWhole()) {
      return Optional.empty();
    }
    MessageValue before = CdrCodec.decode(type.get(), one.bytes());
    MessageValue after = CdrCodec.decode(type.get(), other.bytes());
    List<String> paths = StrengthTrials.recorded(chain).getOrDefault(one.topic(), List.of());
    return paths.stream()
        .filter(path -> !Objects.deepEquals(before.get(path), after.get(path)))
        .findFirst()
        .map(
            path ->
                "%s of %s was %s in the first run, and %s in the second."
                    .formatted(path, one.topic(), shown(before.get(path)), shown(after.get(path))));
  }

  private static String shown(Object value) {
    StringBuilder text = new StringBuilder();
    if (value.getClass().isArray()) {
      for (int i = 0; i < Array.getLength(value) && text.length() <= LONGEST_VALUE; i++) {
        text.append(i == 0 ? "" : ", ").append(Array.get(value, i));
      }
    } else {
      text.append(value);
    }
    return text.length() <= LONGEST_VALUE
        ? text.toString()
        : text.substring(0, LONGEST_VALUE) + "...";
  }
}
