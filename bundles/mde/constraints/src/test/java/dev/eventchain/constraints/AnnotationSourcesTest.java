package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EAnnotation;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;

/** Tests the annotations of a metamodel that are read, and the names that they may use. */
class AnnotationSourcesTest {

  private static final String OCL = "http://www.eclipse.org/emf/2002/Ecore/OCL";

  private final TestModels models = new TestModels("annotated");
  private final EPackage metamodel = models.metamodel();

  private OclRules rules(String... documents) {
    List<SourceText> texts =
        Stream.of(documents).map(text -> SourceText.of("r.ocl", text)).toList();
    return OclRules.parse(
        texts, List.of(metamodel), element -> SourceLocation.of("metamodel.ecore"));
  }

  private EClass type(String name) {
    return (EClass) metamodel.getEClassifier(name);
  }

  private static List<Diagnostic> errors(OclRules rules) {
    return rules.diagnostics().stream().filter(each -> each.severity() == Severity.ERROR).toList();
  }

  private List<Diagnostic> violated(OclRules rules, String... names) {
    return OclValidator.validate(
            rules, List.of(models.load("model.xmi")), element -> SourceLocation.of("model.xmi"))
        .diagnostics()
        .stream()
        .filter(each -> Stream.of(names).anyMatch(name -> each.rule().endsWith("::" + name)))
        .toList();
  }

  @Test
  void constraintsOfAllAnnotationsOfASourceAreReadAndNoneHidesAnother() {
    for (String text : List.of("name = 'first'", "name = 'second'")) {
      EAnnotation annotation = EcoreFactory.eINSTANCE.createEAnnotation();
      annotation.setSource(OCL);
      annotation.getDetails().put("Own" + text.length(), "false");
      annotation.getDetails().put("Same", text);
      type("Shop").getEAnnotations().add(annotation);
    }
    OclRules rules = rules();
    assertEquals(
        List.of("'Same' of Shop is declared twice."),
        errors(rules).stream().map(Diagnostic::message).toList());
    assertTrue(rules.constraintNames().containsAll(List.of("Shop::Own14", "Shop::Own15")));
  }

  @Test
  void annotationThatOnlySeemsToHoldConstraintsIsSaidNotToBeRead() {
    for (String source : List.of("http://www.eclipse.org/ocl/examples/OCL", "urn:my:ocl")) {
      EcoreUtil.setAnnotation(type("Shop"), source, "Own", "name <> 'corner'");
    }
    OclRules rules = rules();
    assertTrue(rules.constraintNames().contains("Shop::Own"));
    assertEquals(
        List.of("The annotation 'urn:my:ocl' of Shop is not understood and is ignored."),
        rules.diagnostics().stream()
            .filter(each -> each.id().equals("ocl.unsupported"))
            .map(Diagnostic::message)
            .toList());
  }

  @Test
  void whatDocumentsComputeMayUseWhatTheyDefineAndMetamodelsMayReadBoth() {
    EcoreUtil.setAnnotation(type("Item"), OCL, "Rated", "rating = rank() + 1");
    OclRules rules =
        rules(
            """
            context Item::rating : Integer derive: rank() + 1
            context Item def: rank() : Integer = 4
            context Item inv Five: rating = 5
            """);
    assertEquals(List.of(), errors(rules));
    assertEquals(List.of(), violated(rules, "Rated", "Five"));
    assertTrue(rules.constraintNames().containsAll(List.of("Item::Rated", "Item::Five")));
  }
}
