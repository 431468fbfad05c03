package dev.eventchain.simulation.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.Signal;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.Signal.Field;
import dev.eventchain.model.Signal.NamedNumber;
import dev.eventchain.model.Signal.Values;
import dev.eventchain.simulation.formula.NamedValues;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Names of the values of fields: those of catalogues, and constants of messages. */
class FieldNamesTest {

  private static final OptionalDouble NONE = OptionalDouble.empty();
  private static final Bench BENCH = bench("provides: {}");

  private static Bench bench(String text) {
    return Bench.parse(
        SourceText.of("bench.yaml", text),
        List.of(
            signal("/seat", "std_msgs/msg/String", new Values(NONE, NONE, List.of("A", "B"))),
            signal(
                "/gear",
                "std_msgs/msg/UInt8",
                new Values(NONE, NONE, List.of(), List.of(new NamedNumber("Reverse", 7)))),
            signal(
                "/mode",
                "std_msgs/msg/UInt8",
                new Values(
                    NONE,
                    NONE,
                    List.of(),
                    List.of(new NamedNumber("Reserved", 3), new NamedNumber("Reserved", 4)))),
            signal("/free", "std_msgs/msg/String", Values.ANY),
            signal("/door", "demo_msgs/msg/GarageGate", Values.ANY),
            sign("/sign", "km/h"),
            sign("/bare", "")),
        MessageCatalog.of(List.of(Path.of("src/test/resources/benches/msg"))));
  }

  private static Signal signal(String topic, String type, Values values) {
    Field field = new Field("data", "", "", values, SourceLocation.NONE);
    return new Signal(
        topic, type, Direction.PROVIDED, Optional.empty(), List.of(field), SourceLocation.NONE);
  }

  private static Signal sign(String topic, String unit) {
    List<Field> fields =
        List.of(
            new Field("kind", "uint8", "", SourceLocation.NONE),
            new Field("limit", "uint8", unit, SourceLocation.NONE));
    return new Signal(
        topic,
        "demo_msgs/msg/TrafficSign",
        Direction.PROVIDED,
        Optional.empty(),
        fields,
        SourceLocation.NONE);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "/seat.data   | texts [A 0.0, B 1.0]",
        "/gear.data   | numbers [Reverse 7.0]",
        "/free.data   | unknown",
        "/door.state  | numbers [STATE_CLOSED 0.0, STATE_OPEN 1.0]",
        "/door.state_lamp | numbers [STATE_LAMP_LIT 2.0]",
        "/door.side   | numbers [LEFT 0.0, RIGHT 1.0]",
        "/door.count  | numbers []",
        "/door.colour | texts [red 0.0, green 1.0]",
        "/door.sides  | unknown",
        "/door.share  | numbers []",
        "/sign.kind   | numbers [NOTHING 0.0, LIMIT 1.0, END_OF_LIMIT 2.0]",
        "/sign.limit  | numbers []",
        "/bare.limit  | numbers [NOTHING 0.0, LIMIT 1.0, END_OF_LIMIT 2.0]",
      })
  void namesAreThoseOfTheCatalogueOrOfTheMessage(String signal, String expected) {
    String found = BENCH.signals().find(signal).map(it -> described(it.named())).orElse("unknown");
    assertEquals(expected, found);
  }

  @ParameterizedTest
  @CsvSource({
    "/gear, std_msgs/msg/UInt8, data, Reverse, 7",
    "/door, demo_msgs/msg/GarageGate, state, STATE_OPEN, 1",
    "/door, demo_msgs/msg/GarageGate, colour, green, green"
  })
  void aConstantOfTheBenchMayBeAName(
      String topic, String type, String path, String name, String value) {
    Bench bench = bench(constant(topic, type, path, name));
    Bench.Source source = bench.provided().get(topic).fields().get(0).source();
    assertEquals(value, ((Bench.Constant) source).value().toString());
  }

  @ParameterizedTest
  @CsvSource({
    "/gear, std_msgs/msg/UInt8, data, Revers, Did you mean `Reverse`?",
    "/mode, std_msgs/msg/UInt8, data, Reserved, Several numbers have this name: write one of them."
  })
  void aNameThatIsNoNumberIsRefused(
      String topic, String type, String path, String name, String hint) {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> bench(constant(topic, type, path, name)));
    Diagnostic finding = refused.diagnostics().get(0);
    assertEquals("bench.value.type", finding.id());
    assertEquals(hint, finding.hint());
  }

  private static String constant(String topic, String type, String path, String name) {
    return "provides: {%s: {type: %s, rate_hz: 10, fields: {%s: {constant: %s}}}}"
        .formatted(topic, type, path, name);
  }

  private static String described(NamedValues names) {
    List<String> all =
        names.values().stream().map(each -> each.name() + " " + each.number()).toList();
    return (names.isText() ? "texts " : "numbers ") + all;
  }
}
