package dev.eventchain.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Checks chains in memory against the rules of a project, which are read once. */
class ChainChecksTest {

  private static final Duration LIMIT = Duration.ofMinutes(1);

  @TempDir Path folder;

  private ProjectCopy project;
  private ChainChecks checks;
  private EventChain chain;

  @BeforeEach
  void read() throws IOException {
    project = ProjectCopy.in(folder);
    checks = ChainChecks.of(project.opened(), project.output(), LIMIT);
    Path file = project.file("model/chain.xmi");
    chain =
        EcoreUtil.copy(ChainModel.read(project.opened(), project.output(), file, LIMIT).chain());
  }

  private ChainChecks.Outcome check() {
    return checks.check(chain, ChainChecksTest::place, ChainChecksTest::place);
  }

  private static SourceLocation place(EObject element) {
    return SourceLocation.NONE.withElement(element.eClass().getName());
  }

  private static SourceLocation place(EObject element, EStructuralFeature feature) {
    return SourceLocation.NONE.withElement(element.eClass().getName() + "." + feature.getName());
  }

  private List<String> ids() {
    return check().diagnostics().stream().map(Diagnostic::id).distinct().toList();
  }

  @Test
  void aChainWithoutAFileIsCheckedAsOneInAFile() {
    ChainChecks.Outcome memory = check();
    assertEquals(List.of(), memory.diagnostics());
    Path file = project.file("model/chain.xmi");
    ChainModel model = ChainModel.read(project.opened(), project.output(), file, LIMIT);
    ChainChecks.Outcome read = checks.check(model);
    assertEquals(read.words(), memory.words());
    for (Coverage.Kind kind : Coverage.Kind.values()) {
      assertEquals(
          read.coverage(List.of()).evaluations(kind), memory.coverage(List.of()).evaluations(kind));
    }
  }

  @Test
  void aChainInNoProjectIsCheckedAgainstTheStandardConstraints() {
    checks = ChainChecks.alone(LIMIT);
    chain.getSoftware().get(0).setName("class");
    assertTrue(ids().contains("ocl.violated"), ids().toString());
    assertTrue(check().coverage(List.of()).evaluations(Coverage.Kind.CONTRACT) > 0);
  }

  @Test
  void eachEditIsChecked() {
    SoftwareNode tracking = chain.getSoftware().get(0);
    tracking.setName("class");
    assertEquals(List.of("ocl.violated"), ids());
    assertEquals("SoftwareNode", check().diagnostics().get(0).location().element());
    tracking.setName("Radar_Tracking");
    assertEquals(List.of(), ids());
  }

  @Test
  void contractsAreFoundAtTheFeature() {
    chain.getData().get(1).setFieldName("distance");
    assertEquals(List.of("contract.field.unknown", "modeler.component.value.changed"), ids());
    assertEquals("Data.fieldName", check().diagnostics().get(0).location().element());
  }

  @Test
  void whatTheMetamodelDemandsIsChecked() {
    EventchainFactory factory = EventchainFactory.eINSTANCE;
    ChainMeasurement measured = factory.createChainMeasurement();
    measured.getLatencies().add(factory.createLatencyMeasurement());
    chain.getMeasured().add(measured);
    assertTrue(ids().contains("ecore.required"), ids().toString());
  }

  @Test
  void requirementsAreComparedWithTheWrittenOnes() {
    chain.getRequirements().get(0).setId("RAD-9");
    assertEquals(List.of("project.requirement.unknown"), ids());
    assertEquals("Requirement.id", check().diagnostics().get(0).location().element());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "true|-- RAD-1: It is fast.|ocl.vacuous error",
        "1 = 1|-- RAD-1: It is fast.|ocl.vacuous error",
        "self.frequency = self.frequency|-- RAD-1|ocl.vacuous error",
        "frequency > 1 or not (frequency > 1)|-- RAD-1|ocl.vacuous error",
        "let most : Integer = 3 in most > 2|-- RAD-1|ocl.vacuous error",
        "true||ocl.vacuous warning",
        "true|-- RAD-99: It is fast.|ocl.vacuous warning",
        "self.frequency = self.frequency||",
        "frequency > 1|-- RAD-1: It is fast.|",
        "SoftwareNode.allInstances()->size() < 9|-- RAD-1: There are few.|",
        "input->notEmpty() implies output->notEmpty()|-- RAD-1|",
        "name = 'Radar_Tracking' and nextstep.name = 'Brake_Request' and frequency > 49.5"
            + " and frequency < 50.5 implies nextstep.frequency >= frequency|-- RAD-1|",
      })
  void aConstraintThatNothingViolatesProvesNoRequirement(
      String condition, String comment, String expected) throws IOException {
    String above = comment == null ? "" : comment + "\n";
    project.write("constraints.ocl", above + "context SoftwareNode inv A: " + condition + "\n");
    checks = ChainChecks.of(project.opened(), project.output(), LIMIT);
    List<String> found =
        check().diagnostics().stream().map(each -> each.id() + " " + each.severity()).toList();
    assertEquals(expected == null ? List.of() : List.of(expected), found);
  }

  @Test
  void whatIsWrongWithAnyFileIsSaidAtOnce() throws IOException {
    project.write("software-base/components.json", "{");
    project.write("requirements.md", "nothing\n");
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> ChainChecks.of(project.opened(), project.output(), LIMIT));
    assertEquals(DiagnosticException.Reason.INPUT, refused.reason());
    assertEquals(
        List.of("modeler.json.syntax", "modeler.requirements.none"),
        refused.diagnostics().stream().map(Diagnostic::id).toList());
  }
}
