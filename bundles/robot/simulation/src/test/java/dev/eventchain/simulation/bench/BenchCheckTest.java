package dev.eventchain.simulation.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.Signal;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.Signal.Field;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests what is said about topics of a chain that a bench does not connect. */
class BenchCheckTest {

  private static final MessageCatalog MESSAGES =
      MessageCatalog.of(List.of(Path.of("src/test/resources/benches/msg")));

  private static Signal signal(String topic, String type, Direction direction, Field... fields) {
    return new Signal(
        topic, type, direction, Optional.empty(), List.of(fields), SourceLocation.NONE);
  }

  private static Field field(String path, String unit) {
    return new Field(path, "float32", unit, SourceLocation.NONE);
  }

  private static Data data(String topic) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setTopicName(topic);
    data.setFieldName("data");
    return data;
  }

  /** Returns the hints where a component reads one topic and writes another one. */
  private static List<String> hints(String read, String written, Signal... declared) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName("Brake");
    node.getInput().add(data(read));
    node.getOutput().add(data(written));
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    chain.getSoftware().add(node);
    chain.getData().addAll(node.getInput());
    chain.getData().addAll(node.getOutput());
    SourceText nothing = SourceText.of("bench.yaml", "provides: {}\nconsumes: {}\n");
    return Bench.parse(nothing, List.of(declared), MESSAGES)
        .check(chain, each -> SourceLocation.NONE)
        .stream()
        .filter(each -> each.is(BenchRules.BENCH_TOPIC_UNCONNECTED))
        .map(Diagnostic::hint)
        .toList();
  }

  @Test
  void topicsWhoseFieldsCanBeGuessedComeWithTheGuess() {
    Signal radar =
        signal(
            "/radar/front",
            "demo_msgs/msg/RadarFront",
            Direction.PROVIDED,
            field("range", "m"),
            field("range_rate", "km/h"),
            field("quality", ""));
    Signal brake =
        signal("/brake/request", "std_msgs/msg/Float32", Direction.CONSUMED, field("data", ""));
    assertEquals(
        List.of(
            "Say under `provides` of bench.yaml where its fields come from; `init` guesses"
                + " `range: min(gap, 200 m)`, `range_rate: lead.speed - ego.speed`.",
            "Say under `consumes` of bench.yaml what its fields do, or `observed: true`; `init`"
                + " guesses `data: brake`."),
        hints("/radar/front", "/brake/request", radar, brake));
  }

  /** Lists of objects are more than a line, and of some fields nothing can be guessed. */
  @Test
  void othersComeWithoutOne() {
    Signal objects = signal("/radar/objects", "demo_msgs/msg/ObjectList", Direction.PROVIDED);
    Signal lamp = signal("/lamp", "std_msgs/msg/Bool", Direction.CONSUMED);
    assertEquals(
        List.of(
            "Say under `provides` of bench.yaml where its fields come from.",
            "Say under `consumes` of bench.yaml what its fields do, or `observed: true`."),
        hints("/radar/objects", "/lamp", objects, lamp));
    assertEquals(
        List.of("Say under `provides` of bench.yaml where its fields come from."),
        hints("/unknown", "/else", lamp));
  }

  /** What a proposal says of a value that it cannot guess has to be a bench once it is done. */
  @Test
  void proposalsSayHowAValueOfAnyTypeGetsIntoItsMessage() {
    String door = proposal("std_msgs/msg/Bool", "bool", "");
    assertTrue(door.contains("# give `my.data > 0` to the field"), door);
    assertTrue(door.contains("#     my.data: {value: 0}\n"), door);
    String heat = proposal("std_msgs/msg/Float32", "float32", "K");
    assertTrue(heat.contains("# give its name to the field"), heat);
    assertTrue(heat.contains("#     my.data: {unit: \"K\", value: 0}\n"), heat);
    String ticks = proposal("std_msgs/msg/Float32", "float32", "tick\nx: 1");
    assertTrue(ticks.contains("#     my.data: {value: 0}\n"), ticks);
  }

  @Test
  void proposalsDoNotAskForStampsThatAreSetByThemselves() {
    Field stamp = new Field("header.stamp", "", "", SourceLocation.NONE);
    Field range = new Field("range", "float32", "m", SourceLocation.NONE);
    Signal signal =
        new Signal(
            "/parking/range",
            "sensor_msgs/msg/Range",
            Direction.PROVIDED,
            Optional.empty(),
            List.of(stamp, range),
            SourceLocation.NONE);
    String proposal = Bench.proposal(List.of(signal), MESSAGES, Map.of());
    assertTrue(proposal.contains("      range: "), proposal);
    assertFalse(proposal.contains("stamp"), proposal);
  }

  /** Units and axes of messages about the vehicle itself are standard; those of others are not. */
  @Test
  void proposalsKnowTheStateOfTheVehicleInStandardMessages() {
    Field[] fields =
        Stream.of(
                "header.stamp.sec",
                "pose.pose.position.x",
                "pose.pose.orientation.w",
                "twist.twist.linear.x",
                "twist.twist.linear.y",
                "twist.twist.angular.z")
            .map(path -> new Field(path, "float64", "", SourceLocation.NONE))
            .toArray(Field[]::new);
    Function<String, String> of =
        topic -> {
          Signal odometry = signal(topic, "nav_msgs/msg/Odometry", Direction.PROVIDED, fields);
          return Bench.proposal(List.of(odometry), MESSAGES, Map.of());
        };
    String own = of.apply("/robot/odom");
    assertTrue(
        own.contains(
            """
                fields:
                  pose.pose.position.x: {value: ego.x, unit: m}
                  pose.pose.orientation.w: ego.orientation.w
                  twist.twist.linear.x: {value: ego.speed, unit: m/s}
                  twist.twist.linear.y: 0
                  twist.twist.angular.z: {value: ego.yaw_rate, unit: rad/s}
            """),
        own);
    assertFalse(own.contains("stamp"), "stamps are set with each message");
    String others = of.apply("/lead/odom");
    assertTrue(others.contains("#      twist.twist.linear.x: ?"), others);
  }

  private static String proposal(String message, String type, String unit) {
    Field field = new Field("data", type, unit, SourceLocation.NONE);
    Signal signal = signal("/cabin/value", message, Direction.PROVIDED, field);
    return Bench.proposal(List.of(signal), MESSAGES, Map.of());
  }
}
