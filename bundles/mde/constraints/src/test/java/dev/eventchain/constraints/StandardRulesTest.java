package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.fixtures.TestModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests the standard rules of event chains, each with a bad model {@code standard/RULE/bad.xmi} and
 * the expected findings {@code expected.txt}. One good model breaks no rule.
 */
class StandardRulesTest {

  private static final Path METAMODEL = Path.of("..", "..", "..", "metamodel");
  private static final Path MODELS = Path.of("src", "test", "resources", "standard");
  private static final String PAPER =
      """
      context SoftwareNode
        inv HasInputAndOutputData:
          self.input->notEmpty() and self.output->notEmpty()
        inv NextstepFrequencyEqualOrHigher:
          self.nextstep->notEmpty() implies (self.nextstep.
          frequency >= self.frequency)
      """;

  private final TestModels models = new TestModels(MODELS, METAMODEL);
  private final EPackage metamodel = models.metamodel(METAMODEL.resolve("eventchain.ecore"));

  private OclRules rules(String text) {
    OclRules rules =
        OclRules.parse(List.of(SourceText.of("eventchain.ocl", text)), List.of(metamodel));
    assertEquals(List.of(), rules.diagnostics());
    return rules;
  }

  private OclRules standardRules() throws IOException {
    return rules(Files.readString(METAMODEL.resolve("eventchain.ocl")));
  }

  private static OclResult validate(OclRules rules, EObject model) {
    return OclValidator.validate(
        rules,
        List.of(model),
        element ->
            SourceLocation.of(element.eResource().getURI().lastSegment())
                .withElement(element.eResource().getURIFragment(element)));
  }

  @Test
  void theGoodModelBreaksNoRule() throws IOException {
    OclResult result = validate(standardRules(), models.load("good.xmi"));
    assertEquals("", DiagnosticFormat.TEXT.render(result.diagnostics()));
    assertEquals(26, result.constraints());
  }

  @Test
  void thePapersConstraintsStandWordForWordAndRunWithoutPackageClause() throws IOException {
    String first = PAPER.substring(0, PAPER.indexOf("  inv NextstepFrequency"));
    assertTrue(Files.readString(METAMODEL.resolve("eventchain.ocl")).contains(first));
    OclResult result = validate(rules(PAPER), models.load("good.xmi"));
    assertEquals(2, result.constraints());
    assertEquals(4, result.evaluations());
    assertEquals(List.of(), result.diagnostics());
  }

  /** Falling frequencies break a design rule of the paper's project, but are usual elsewhere. */
  @Test
  void aFastSensorBeforeASlowComponentBreaksNoRule() throws IOException {
    EObject chain = models.load("good.xmi");
    EObject sensor = chain.eContents().get(0);
    sensor.eSet(sensor.eClass().getEStructuralFeature("frequency"), 100.0);
    sensor.eSet(sensor.eClass().getEStructuralFeature("worstCaseExecutionTime"), 5.0);
    assertEquals(List.of(), validate(standardRules(), chain).diagnostics());
    assertEquals(1, validate(rules(PAPER), chain).diagnostics().size());
  }

  @Test
  void theDataFlowIsDerivedFromTopicsAndFields() throws IOException {
    OclRules rules =
        rules(
            Files.readString(METAMODEL.resolve("eventchain.ocl"))
                + """
                context EventChain
                  inv Flow: software->first().successors = OrderedSet{software->last()}
                    and software->last().predecessors = OrderedSet{software->first()}
                    and software->last().successors->isEmpty()
                """);
    assertEquals(List.of(), validate(rules, models.load("good.xmi")).diagnostics());
  }

  /** Such names used to pass, and failed only when the generated package was imported. */
  @ParameterizedTest
  @CsvSource({
    "aeb_2, rclpy, ChainNameIsNoModule",
    "aeb_2, OS, ChainNameIsNoModule",
    "aeb_2, statistics, ChainNameIsNoModule",
    "aeb_2, std_msgs, ChainNameIsNoModule",
    "aeb_2, rcl_interfaces, ChainNameIsNoModule",
    "aeb_2, builtin_interfaces, ChainNameIsNoModule",
    "aeb_2, Geometry_Msgs, ChainNameIsNoModule",
    "aeb_2, conftest, ChainNameIsNoModule",
    "aeb_2, peers, ChainNameIsNoModule",
    "aeb_2, ament_python, ChainNameIsNoModule",
    "aeb_2, ros2launch, ChainNameIsNoModule",
    "aeb_2, a__b, ChainNameIsPackageName",
    "aeb_2, aeb_, ChainNameIsPackageName",
    "aeb_2, Class, ChainNameIsPackageName",
    "aeb_2, main, ChainNameIsPackageName",
    "TTC_Calculation, rclpy, NodeNameIsIdentifier",
    "TTC_Calculation, __ttc, NodeNameIsIdentifier",
    "ego_speed, main, DataNameIsIdentifier",
  })
  void namesThatPythonHasAlreadyAreRefused(
      String good, String bad, String rule, @TempDir Path folder) throws IOException {
    assertEquals(List.of(rule), rulesBrokenBy(good, bad, folder));
  }

  /** Returns the rules that the good model breaks with another name. */
  private static List<String> rulesBrokenBy(String good, String bad, Path folder)
      throws IOException {
    String text = Files.readString(MODELS.resolve("good.xmi"));
    Files.writeString(
        folder.resolve("bad.xmi"), text.replace("name=\"" + good + "\"", "name=\"" + bad + "\""));
    TestModels renamed = new TestModels(folder.toAbsolutePath(), METAMODEL);
    EPackage itsMetamodel = renamed.metamodel(METAMODEL.resolve("eventchain.ecore"));
    OclRules rules =
        OclRules.parse(
            List.of(
                SourceText.of(
                    "eventchain.ocl", Files.readString(METAMODEL.resolve("eventchain.ocl")))),
            List.of(itsMetamodel));
    return validate(rules, renamed.load("bad.xmi")).diagnostics().stream()
        .map(d -> d.rule().replaceFirst(".*::", ""))
        .toList();
  }

  /** Names that only resemble reserved ones, or are local to the generated nodes. */
  @ParameterizedTest
  @CsvSource({
    "aeb_2, msgs",
    "aeb_2, interfaces_of_aeb",
    "aeb_2, amenities",
    "aeb_2, peers_of_aeb",
    "TTC_Calculation, len",
    "TTC_Calculation, frequency",
    "TTC_Calculation, options"
  })
  void namesThatNothingElseHasAreTaken(String good, String other, @TempDir Path folder)
      throws IOException {
    assertEquals(List.of(), rulesBrokenBy(good, other, folder));
  }

  @TestFactory
  Stream<DynamicTest> everyRuleIsBrokenByItsBadModel() throws IOException {
    List<DynamicTest> tests = new ArrayList<>();
    OclRules rules = standardRules();
    for (OclConstraint constraint : rules.constraints()) {
      tests.add(DynamicTest.dynamicTest(constraint.name(), () -> check(rules, constraint)));
    }
    return tests.stream();
  }

  private void check(OclRules rules, OclConstraint constraint) throws IOException {
    EObject model = models.load(constraint.name() + "/bad.xmi");
    OclResult result = validate(rules, model);
    String found = DiagnosticFormat.TEXT.render(result.diagnostics());
    ExpectedFile.check(MODELS.resolve(constraint.name()).resolve("expected.txt"), found);
    assertTrue(
        result.diagnostics().stream()
            .map(Diagnostic::rule)
            .anyMatch(constraint.qualifiedName()::equals),
        "the bad model does not break " + constraint);
  }
}
