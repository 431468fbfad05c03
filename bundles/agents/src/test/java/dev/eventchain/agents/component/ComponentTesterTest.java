package dev.eventchain.agents.component;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.FindingLines;
import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.component.RequirementThresholds.Threshold;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests of components: errors in them, and their findings about components. */
class ComponentTesterTest {
  private static final Path FOLDER = Path.of("src/test/resources/component-tests");
  private static final String COMPONENT = "Braking_Decision";
  private static final SourceText CHAIN = SourceText.read(FOLDER.resolve("chain.json"));
  private static final Requirements REQUIREMENTS =
      Requirements.read(SourceText.read(FOLDER.resolve("requirements.md")));

  private static ComponentTester tests(Path file) {
    return ComponentTester.read(SourceText.read(file), CHAIN, COMPONENT, REQUIREMENTS);
  }

  @Test
  void goodTestsHaveNoFindings() {
    ComponentTester good = tests(FOLDER.resolve("good.yaml"));
    assertEquals(List.of(), good.diagnostics());
    assertEquals(13, good.count());
  }

  @ParameterizedTest
  @MethodSource
  void eachFaultOfTestsIsFoundWhereItIs(Path file) throws IOException {
    FindingLines.check(file, tests(file).diagnostics());
  }

  static List<Path> eachFaultOfTestsIsFoundWhereItIs() throws IOException {
    return ExpectedFile.inputs(FOLDER.resolve("bad"), ".yaml");
  }

  /**
   * Tests near 0 and near small whole numbers can be given, and what a further condition, a time,
   * another number or a state leaves open contradicts nothing.
   */
  @ParameterizedTest
  @MethodSource
  void whatRequirementsLeaveOpenIsFree(Path file) throws IOException {
    Path folder = FOLDER.resolve("near");
    ComponentTester tests =
        ComponentTester.read(
            SourceText.read(file),
            SourceText.read(folder.resolve("chain.json")),
            "Level_Lamp",
            Requirements.read(SourceText.read(folder.resolve("requirements.md"))));
    FindingLines.check(file, tests.diagnostics());
    assertEquals(file.endsWith("right.yaml"), tests.diagnostics().isEmpty(), file::toString);
  }

  static List<Path> whatRequirementsLeaveOpenIsFree() throws IOException {
    return ExpectedFile.inputs(FOLDER.resolve("near"), ".yaml");
  }

  @ParameterizedTest
  @MethodSource
  void eachWrongComponentFailsAtTheTest(Path file) throws IOException {
    ComponentProbe probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
    List<Diagnostic> found = tests(FOLDER.resolve("good.yaml")).run(probe, file);
    FindingLines.check(file, found);
    assertEquals(file.endsWith("right.py"), found.isEmpty(), file::toString);
  }

  static List<Path> eachWrongComponentFailsAtTheTest() throws IOException {
    return ExpectedFile.inputs(FOLDER.resolve("components"), ".py");
  }

  /** A component that raises as its tests say passes; one that raises otherwise, or not, fails. */
  @ParameterizedTest
  @MethodSource
  void anErrorIsExpected(Path file) throws IOException {
    ComponentProbe probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
    List<Diagnostic> found = tests(FOLDER.resolve("raising.yaml")).check(probe, file);
    FindingLines.check(file, found);
    assertEquals(file.endsWith("right.py"), found.isEmpty(), file::toString);
  }

  static List<Path> anErrorIsExpected() throws IOException {
    return ExpectedFile.inputs(FOLDER.resolve("raising"), ".py");
  }

  @Test
  void textThatIsNoYamlIsRefused() {
    SourceText text = SourceText.of("tests/Braking_Decision.yaml", "tests: [1, 2");
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class,
            () -> ComponentTester.read(text, CHAIN, COMPONENT, REQUIREMENTS));
    assertEquals("component.tests.format", e.diagnostics().get(0).id());
  }

  /** A gap is a warning to the user, but returns an answer to the model. */
  @Test
  void gapsAreErrorsOfProposals() {
    Path file = FOLDER.resolve("bad/gaps.yaml");
    assertTrue(
        tests(file).diagnostics().stream().allMatch(each -> each.severity() == Severity.WARNING));
    assertTrue(
        tests(file).complaints().stream().allMatch(each -> each.severity() == Severity.ERROR));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Full brake if TTC < 1.0s | (-Infinity, 1000.0) full braking_force",
        "brake if 1.0s ≤ TTC < 2.0s | [1000.0, 2000.0) some braking_force",
        "It shall not brake while the time to collision is 3 s or more | [3000.0, Infinity) none braking_force",
        "It shall warn while the time to collision is below 2.6 s | (-Infinity, 2600.0) some warning",
        "It shall signal an emergency when TTC falls below 500 ms | (-Infinity, 500.0) some",
        "It shall beep at a TTC of at most 2 seconds | (-Infinity, 2000.0] some",
        "It shall warn, not below a TTC of 5 s |",
        "It shall not warn at a speed below 5 km/h |",
        "It shall warn while the TTC is more than 5 s above the limit |",
        "It shall warn if the TTC is 2 s below that of the map |",
        "It shall warn while the ignition is on and the TTC is below 2 s | (-Infinity, 2000.0) unknown warning",
        "It shall warn when no driver reacts while the TTC is below 2 s | (-Infinity, 2000.0) unknown warning",
        "When the ignition is on, it shall warn while the TTC is below 2 s | (-Infinity, 2000.0) unknown warning",
        "It shall warn while the TTC is below 2 s, unless the driver brakes | (-Infinity, 2000.0) unknown warning",
        "It shall warn when the TTC has been below 2 s for 300 ms | (-Infinity, 2000.0) unknown warning",
        "It shall warn without delay when the TTC is below 2 s | (-Infinity, 2000.0) unknown warning",
        "It shall switch the warning off while the TTC is above 2 s | (2000.0, Infinity) unknown warning",
        "It shall set the braking force to 0 while the TTC is above 2 s | (2000.0, Infinity) unknown braking_force",
        "It shall set the braking force to 30 % while the TTC is below 2 s | (-Infinity, 2000.0) unknown braking_force",
        "The warning shall be inactive while the TTC is above 2 s | (2000.0, Infinity) unknown warning",
        "The braking shall be blocked while the TTC is above 2 s | (2000.0, Infinity) unknown braking_force",
        "It shall brake if TTC < 3 m |",
        "It shall hold the brake for at least 3 s |"
      })
  void thresholdsAreReadFromRequirements(String text, String expected) {
    WrittenRequirement item =
        Requirements.read(SourceText.of("r.md", "- R-1: " + text + ".\n")).items().get(0);
    List<String> found =
        RequirementThresholds.of(item, ChainView.component(CHAIN, COMPONENT)).stream()
            .map(ComponentTesterTest::words)
            .toList();
    assertEquals(expected == null ? List.of() : List.of(expected), found);
  }

  private static String words(Threshold threshold) {
    return "%s%s, %s%s %s %s"
        .formatted(
            threshold.leastIn() && Double.isFinite(threshold.least()) ? "[" : "(",
            threshold.least(),
            threshold.most(),
            threshold.mostIn() && Double.isFinite(threshold.most()) ? "]" : ")",
            threshold.effect().name().toLowerCase(Locale.ROOT),
            String.join(" ", threshold.outputs()))
        .strip();
  }
}
