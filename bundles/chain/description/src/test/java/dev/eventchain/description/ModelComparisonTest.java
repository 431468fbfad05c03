package dev.eventchain.description;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.InstanceModeler;
import dev.eventchain.jsonmodels.ModelComparison;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.Origins;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;

class ModelComparisonTest {

  private static final List<EPackage> LIBRARY = library();

  private final EventChain chain = read();

  @Test
  void aCopySaysTheSame() {
    assertEquals(List.of(), after(copy -> {}));
  }

  @Test
  void aChangedValueIsNamedWithBothValues() {
    Diagnostic found = one(after(copy -> copy.getSoftware().get(0).setFrequency(50)));
    assertEquals("modeler.comparison.value", found.id());
    assertEquals("'frequency' is 50.0, not 20.0.", found.message());
    assertEquals("EventChain[aeb]/software[TTC_Calculation]", found.location().element());
  }

  @Test
  void rootsOfDifferentClassesAreNotCompared() {
    EObject other = chain.getSoftware().get(0);
    Diagnostic found = one(ModelComparison.compare(chain, other, new Origins()::locate));
    assertEquals("modeler.comparison.class", found.id());
  }

  @Test
  void anUnsetValueDiffersFromZero() {
    Diagnostic found = one(after(copy -> copy.getSoftware().get(0).unsetFrequency()));
    assertEquals("'frequency' is not set, not 20.0.", found.message());
  }

  @Test
  void aMissingElementIsReportedWithoutAllThatRefersToIt() {
    List<Diagnostic> found = after(copy -> EcoreUtil.remove(copy.getRequirements().get(1)));
    assertEquals(
        List.of("modeler.comparison.missing", "modeler.comparison.reference"),
        found.stream().map(Diagnostic::id).sorted().toList());
    assertTrue(found.get(0).message().contains("Requirement 'R-2'"), found.toString());
  }

  @Test
  void anAdditionalElementIsReportedWhereItStands() {
    Diagnostic found =
        one(after(copy -> copy.getRequirements().add(copyOf(copy.getRequirements().get(0)))));
    assertEquals("modeler.comparison.additional", found.id());
    assertEquals("EventChain[aeb]/requirements[R-1]", found.location().element());
  }

  @Test
  void aReferenceToAnotherElementIsReported() {
    Diagnostic found =
        one(
            after(
                copy -> {
                  SoftwareNode first = copy.getSoftware().get(0);
                  first.setNextstep(first);
                }));
    assertEquals("modeler.comparison.reference", found.id());
    assertEquals(
        "'nextstep' refers to SoftwareNode 'TTC_Calculation', not to SoftwareNode"
            + " 'Braking_Decision'.",
        found.message());
  }

  @Test
  void anotherOrderIsAWarningWhereOrderCounts() {
    Diagnostic found = one(after(copy -> copy.getSoftware().get(0).getInput().move(0, 1)));
    assertEquals("modeler.comparison.order", found.id());
    assertEquals(Severity.WARNING, found.severity());
  }

  @Test
  void anotherOrderOfTheElementsDoesNotConfuseTheirReferences() {
    List<Diagnostic> found = after(copy -> copy.getData().move(0, 4));
    assertEquals("modeler.comparison.order", one(found).id());
  }

  @Test
  void orderDoesNotCountWhereTheMetamodelSaysSo() {
    EObject first = library("[\"f\", \"b\"]");
    EObject second = library("[\"b\", \"f\"]");
    assertEquals(1, ModelComparison.compare(first, second, new Origins()::locate).size());
    first.eClass().getEStructuralFeature("featured").setOrdered(false);
    EObject third = EcoreUtil.copy(first);
    ((EList<?>) third.eGet(third.eClass().getEStructuralFeature("featured"))).move(0, 1);
    assertEquals(List.of(), ModelComparison.compare(first, third, new Origins()::locate));
  }

  private static EObject library(String featured) {
    String json =
        """
        {"eClass": "Library", "id": "L", "name": "Town",
         "items": [{"eClass": "Book", "id": "b", "title": "x"},
                   {"eClass": "Film", "id": "f", "title": "y"}],
         "sections": [{"id": "s"}], "shelves": ["s"], "featured": %s}
        """
            .formatted(featured);
    Modeled<List<EObject>> made =
        new InstanceModeler(LIBRARY).model(SourceText.of("library.json", json));
    assertEquals(List.of(), made.diagnostics());
    return made.root().get(0);
  }

  private List<Diagnostic> after(Consumer<EventChain> change) {
    EventChain copy = copyOf(chain);
    change.accept(copy);
    return ModelComparison.compare(chain, copy, new Origins()::locate);
  }

  private static <T extends EObject> T copyOf(T object) {
    return EcoreUtil.copy(object);
  }

  private static Diagnostic one(List<Diagnostic> found) {
    assertEquals(1, found.size(), found.toString());
    return found.get(0);
  }

  private static EventChain read() {
    return ChainCasesTest.read(Path.of("src/test/resources/cases/chain/good-our-form")).root();
  }

  private static List<EPackage> library() {
    Path folder = Path.of("../../mde/json-models/src/test/resources/cases");
    return new XmiStore(folder).loadMetamodel(folder.resolve("library.ecore"));
  }
}
