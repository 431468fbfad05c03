package dev.eventchain.simulation.run;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.Bench.Provided;
import dev.eventchain.simulation.bench.BenchRules;
import dev.eventchain.simulation.bench.ChosenText;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.sensor.Lidar;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.sensor.RoadScene;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;

/** A published topic, its reused message, and the time when it is due. */
final class Publisher {

  private static final String HEADER = "std_msgs/msg/Header";
  private static final long SECOND = 1_000_000_000L;
  private static final long CLOCK_PERIOD = SECOND / 20;

  /** Interval of the lidar outlines for display, in ns. */
  private static final long OUTLINE = SECOND * 2 / 5;

  private final TypedTopic topic;
  private final Optional<Provided> provided;
  private final MessageValue message;
  private final List<String> stamps;
  private final List<Signal> recorded;
  private final SplittableRandom random;
  private final long period;
  private long count;

  Publisher(
      TypedTopic topic,
      Optional<Provided> provided,
      MessageValue message,
      List<Signal> recorded,
      long seed) {
    this.topic = topic;
    this.provided = provided;
    this.message = message;
    this.recorded = recorded;
    this.random = new SplittableRandom(seed + topic.name().hashCode());
    this.period = provided.map(Provided::period).orElse(CLOCK_PERIOD);
    this.stamps = stamps(message.type());
  }

  /** Returns the paths of the stamps of all headers in a message, including nested messages. */
  private static List<String> stamps(MessageType type) {
    List<String> stamps = new ArrayList<>();
    addStamps(type, "", stamps);
    return stamps;
  }

  private static void addStamps(MessageType type, String prefix, List<String> stamps) {
    for (MessageType.Field field : type.fields()) {
      if (field.type().shape() == FieldType.Shape.SINGLE && field.type().message().isPresent()) {
        MessageType inner = field.type().message().get();
        if (inner.name().equals(HEADER)) {
          stamps.add(prefix + field.name() + ".stamp");
        } else {
          addStamps(inner, prefix + field.name() + ".", stamps);
        }
      }
    }
  }

  long due() {
    return count * period;
  }

  TypedTopic topic() {
    return topic;
  }

  /** Returns whether its messages have a time stamp. */
  boolean isStamped() {
    return !stamps.isEmpty();
  }

  /** Returns whether its messages are lidar scans. */
  boolean isLidar() {
    return provided.filter(Provided::lidar).isPresent();
  }

  /** Returns the last message. */
  MessageValue message() {
    return message;
  }

  /** Returns the fields that formulas read or reports show. */
  List<Signal> recorded() {
    return recorded;
  }

  /** Returns whether the message reaches the nodes. */
  boolean arrives(SampledRun moment) {
    return provided.filter(it -> it.transfer().loses(moment, random)).isEmpty();
  }

  /** Returns the latency of the transfer, in ns. */
  long latency() {
    return provided.map(it -> it.transfer().latency()).orElse(0L);
  }

  /**
   * Fills the message with the current values.
   *
   * @param shown the time on the clock, in ns
   */
  void fill(World world, SampledRun moment, Lidar lidar, long shown) {
    count++;
    if (provided.isEmpty()) {
      stamp(message, "clock", shown);
      return;
    }
    stamps.forEach(path -> stamp(message, path, shown));
    if (provided.get().lidar()) {
      RoadScene scene = RoadScene.of(world);
      lidar.scan(scene, message);
      if (world.now() % OUTLINE == 0) {
        world.trace().outline(lidar.outline(scene, World.seconds(world.now())));
      }
    }
    provided.get().scanner().ifPresent(it -> it.scan(world, random, message));
    provided.get().objects().ifPresent(it -> list(it, world, shown));
    for (Bench.Field field : provided.get().fields()) {
      if (field.source() instanceof Bench.Quantity quantity) {
        send(message, field, quantity.at(moment, random));
      } else if (field.source() instanceof Bench.Truth truth) {
        message.set(field.path(), truth.formula().holds(moment));
      } else if (field.source() instanceof ChosenText chosen) {
        message.set(field.path(), chosen.at(moment).orElseThrow(() -> noText(chosen, field)));
      }
    }
  }

  private void list(ObjectSensor objects, World world, long shown) {
    objects.fill(world, random, message);
    for (String list : objects.messageLists()) {
      for (Object each : (List<?>) message.get(list)) {
        MessageValue element = (MessageValue) each;
        stamps(element.type()).forEach(path -> stamp(element, path, shown));
      }
    }
  }

  /**
   * Writes a number into its field; one that does not fit ends the simulation instead of being
   * altered.
   */
  private static void send(MessageValue message, Bench.Field field, double value) {
    boolean whole =
        !(message.get(field.path()) instanceof Float
            || message.get(field.path()) instanceof Double);
    try {
      message.set(field.path(), whole && Double.isFinite(value) ? Math.rint(value) : value);
    } catch (IllegalArgumentException e) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(BenchRules.BENCH_VALUE_RANGE, e.getMessage(), field.location())
              .withHint("Limit it: `min(gap, 200 m)`, or give it another unit."));
    }
  }

  private static DiagnosticException noText(ChosenText chosen, Bench.Field field) {
    String message =
        String.format(
            Locale.ROOT, "'%s' is none of the %d texts.", chosen.text(), chosen.texts().size());
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(BenchRules.BENCH_VALUE_RANGE, message, field.location())
            .withHint("0 stands for the first text, 1 for the second one."));
  }

  private static void stamp(MessageValue message, String field, long now) {
    message.set(field + ".sec", (int) (now / SECOND));
    message.set(field + ".nanosec", now % SECOND);
  }
}
