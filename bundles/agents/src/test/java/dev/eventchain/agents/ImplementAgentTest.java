package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.component.ImplementationCheck;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.Signal;
import dev.eventchain.project.Requirements;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Components with one fault each, as models write them, and the findings about them. */
class ImplementAgentTest {
  private static final Path RESOURCES = Path.of("src/test/resources");
  private static final Path FOLDER = Path.of("src/test/resources/implement");
  private static final SourceText CHAIN = SourceText.read(FOLDER.resolve("chain.json"));
  private static final Requirements REQUIREMENTS =
      Requirements.read(SourceText.of("r.md", "- R-1: The system shall watch.\n- R-2: No.\n"));

  private static ComponentProbe probe;

  @BeforeAll
  static void python() {
    probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
  }

  @ParameterizedTest
  @MethodSource
  void eachFaultIsFoundWhereItIs(Path file) throws IOException {
    ImplementationCheck check =
        new ImplementationCheck(
            probe,
            ChainView.of(JsonDocument.parse(CHAIN).root()).components().get(0),
            Optional.empty(),
            List.of(),
            () -> MessageCatalog.of(List.of()));
    List<Diagnostic> found = check.check(SourceText.read(file));
    FindingLines.check(file, found);
  }

  static List<Path> eachFaultIsFoundWhereItIs() throws IOException {
    return ExpectedFile.inputs(RESOURCES.resolve("implement"), ".py");
  }

  @Test
  void aComponentThatFailsItsCallsIsRepairedWithThePlaceOfTheFault() {
    ScriptedModel model =
        new ScriptedModel()
            .answer("```python\n" + text("division-by-zero-speed.py") + "```")
            .answer("```python\n" + text("right.py") + "```");
    ImplementAgent agent = new ImplementAgent(AgentContext.of(model), probe, List.of());
    AgentResult result = agent.implement(CHAIN, "Time_Left", REQUIREMENTS, Optional.empty());
    assertEquals(text("right.py"), result.text());
    assertEquals(2, result.attempts().size());
    Diagnostic finding = result.attempts().get(0).findings().get(0);
    assertEquals("components/Time_Left.py", finding.location().file());
    assertEquals(3, finding.location().line());
    String repair = model.requests.get(1).messages().get(2).content();
    assertTrue(repair.contains("1. Line 3, column "), repair);
    assertTrue(repair.contains("> return {\"time_left\": min(distances, default=0.0) / speed}"));
  }

  @Test
  void thePromptHoldsTheDescriptionAndTheComponentsOwnRequirements() {
    String prompt = promptFor(CHAIN);
    assertTrue(prompt.contains("\"name\": \"Time_Left\""), prompt);
    assertTrue(prompt.contains("- R-1: The system shall watch.\n"), prompt);
    assertFalse(prompt.contains("R-2"), prompt);
  }

  @Test
  void aBudgetOfTimeOrMemoryDoesNotChangeThePrompt() {
    String budgets = "[{\"worst_case_execution_time\": 4.5, \"memory\": 12, ";
    String withBudgets = CHAIN.text().replaceFirst("\\[\\s*\\{", budgets);
    assertNotEquals(CHAIN.text(), withBudgets);
    assertEquals(promptFor(CHAIN), promptFor(SourceText.of("chain.json", withBudgets)));
  }

  /** What the message has is the node's business: the component has m/s, as in the other chain. */
  @Test
  void aPromptHasTheUnitsWithinTheComponent() {
    assertEquals(promptFor(CHAIN), promptFor(withWire("\"float32\", \"unit\": \"km/h\"")));
    String integer = promptFor(withWire("\"uint16\", \"unit\": \"km/h\""));
    assertEquals(promptFor(CHAIN).replace(SPEED, SPEED.replace("32", "64")), integer);
  }

  private static final String SPEED = "\"type\": \"float32\", \"unit\": \"m/s\"";

  private static SourceText withWire(String typeAndUnit) {
    String changed =
        CHAIN.text().replace(SPEED, "\"type\": " + typeAndUnit + ", \"component_unit\": \"m/s\"");
    assertNotEquals(CHAIN.text(), changed);
    return SourceText.of("chain.json", changed);
  }

  /** A byte of km/h is 0 to 70.8 m/s, and never infinite or not a number. */
  @Test
  void aComponentIsProbedWithWhatItsMessagesCanHold() {
    SourceText chain = withWire("\"uint8\", \"unit\": \"km/h\"");
    String assertion = "assert type(speed) is float and 0.0 <= speed <= %s / 3.6";
    assertEquals(0, failures(chain, List.of(), assertion.formatted("255.0")));
    assertEquals(1, failures(chain, List.of(), assertion.formatted("250.0")));
  }

  /** The limits of a catalogue are those of the message. */
  @ParameterizedTest
  @CsvSource({"assert speed != 130.0 / 3.6, 1", "assert speed != 131.0 / 3.6, 1", "assert True, 0"})
  void aComponentIsProbedAtTheLimitsOfItsSignals(String assertion, int failures) {
    SourceText chain = withWire("\"uint8\", \"unit\": \"km/h\"");
    assertEquals(0, failures(chain, List.of(), assertion));
    assertEquals(failures, failures(chain, List.of(speedUpTo(130)), assertion));
  }

  @Test
  void aNumberIsProbedOnBothSidesOfItsLimit() {
    List<Signal> signals = List.of(speedUpTo(130));
    assertEquals(1, failures(CHAIN, signals, "assert not 130.0 < speed < 130.1"));
    assertEquals(1, failures(CHAIN, signals, "assert not 129.9 < speed < 130.0"));
    assertEquals(0, failures(CHAIN, signals, "assert not 130.1 < speed < 140.0"));
  }

  @Test
  void aTextIsProbedWithAllThatItsSignalAllows() {
    SourceText chain =
        SourceText.of("chain.json", CHAIN.text().replace(SPEED, "\"type\": \"string\""));
    Signal.Values gears =
        new Signal.Values(OptionalDouble.empty(), OptionalDouble.empty(), List.of("PARK", "DRIVE"));
    String statement = "assert speed != \"DRIVE\"; speed = 1.0";
    assertEquals(0, failures(chain, List.of(), statement));
    assertEquals(1, failures(chain, List.of(speedWith(gears)), statement));
  }

  private static Signal speedUpTo(double most) {
    return speedWith(new Signal.Values(OptionalDouble.empty(), OptionalDouble.of(most), List.of()));
  }

  private static Signal speedWith(Signal.Values values) {
    return new Signal(
        "/sensor/speed",
        "std_msgs/msg/Float32",
        Signal.Direction.PROVIDED,
        Optional.empty(),
        List.of(new Signal.Field("data", "", "", values, SourceLocation.NONE)),
        SourceLocation.NONE);
  }

  /** Returns how many findings there are about a component that begins with a statement. */
  private static int failures(SourceText chain, List<Signal> signals, String statement) {
    ImplementationCheck check =
        new ImplementationCheck(
            probe,
            ChainView.component(chain, "Time_Left"),
            Optional.empty(),
            signals,
            () -> MessageCatalog.of(List.of()));
    String head = "def execute(self, distances, speed):\n";
    String code = text("right.py").replace(head, head + "        " + statement + "\n");
    assertNotEquals(text("right.py"), code);
    return check.check(SourceText.of("component.py", code)).size();
  }

  @Test
  void aTransportTimeDoesNotChangeThePrompt() {
    String stated =
        CHAIN.text().replaceAll("\"topic\":", "\"worst_case_transport_time\": 2.5, \"topic\":");
    assertNotEquals(CHAIN.text(), stated);
    assertEquals(promptFor(CHAIN), promptFor(SourceText.of("chain.json", stated)));
  }

  private static String promptFor(SourceText chain) {
    ScriptedModel model = new ScriptedModel().answer(text("right.py"));
    new ImplementAgent(AgentContext.of(model), probe, List.of())
        .implement(chain, "Time_Left", REQUIREMENTS, Optional.empty());
    return model.requests.get(0).messages().get(0).content();
  }

  @Test
  void aComponentThatTheChainDoesNotHaveIsRefused() {
    ImplementAgent agent =
        new ImplementAgent(AgentContext.of(new ScriptedModel()), probe, List.of());
    assertThrows(
        IllegalArgumentException.class,
        () -> agent.implement(CHAIN, "Other", REQUIREMENTS, Optional.empty()));
  }

  private static String text(String file) {
    return SourceText.read(FOLDER.resolve(file)).text();
  }
}
