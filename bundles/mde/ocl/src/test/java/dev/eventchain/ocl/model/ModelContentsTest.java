package dev.eventchain.ocl.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.Evaluations;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests the elements of a model and their classes. */
class ModelContentsTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  /** Returns the root and the elements of EMF's own iterator. */
  private List<EObject> elements() {
    List<EObject> elements = new ArrayList<>(List.of(library));
    for (Iterator<EObject> below = library.eAllContents(); below.hasNext(); ) {
      elements.add(below.next());
    }
    return elements;
  }

  private EClass type(String name) {
    return (EClass) metamodel.getEClassifier(name);
  }

  @Test
  void areInTheOrderOfContainment() {
    assertEquals(elements(), ModelContents.below(List.of(library)).all());
  }

  @Test
  void areThereOnceWhateverRootsOverlap() {
    List<EObject> roots = List.of(library, library.eContents().get(0), library);
    assertEquals(elements(), ModelContents.below(roots).all());
  }

  @Test
  void instancesAreThoseOfSubclassesTooInTheOrderOfTheModel() {
    ModelContents contents = ModelContents.below(List.of(library));
    Evaluation evaluation = Evaluations.over(List.of(library));
    for (String name : List.of("Library", "Book", "AudioBook")) {
      List<EObject> expected = elements().stream().filter(type(name)::isInstance).toList();
      assertEquals(expected, contents.instancesOf(type(name)), name);
      assertEquals(expected, evaluation.elements(type(name)), name);
      assertEquals(expected, List.copyOf(evaluation.allInstances(type(name))), name);
    }
  }
}
