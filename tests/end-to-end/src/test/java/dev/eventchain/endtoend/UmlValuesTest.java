package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.model.EventChainMetamodel;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.uml2.uml.resources.util.UMLResourcesUtil;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the values of UML models against those that Eclipse UML2 reads from the same files. */
class UmlValuesTest {

  /** Compares every value, also of derived features, with what Eclipse UML2 itself reads. */
  @ParameterizedTest
  @CsvSource({"shop.uml, 41", "behaviour.uml, 18"})
  void valuesAreThoseThatEclipseUml2Reads(String name, int elements) {
    Path file = UmlCase.FILES.resolve(name);
    ResourceSet set = UMLResourcesUtil.init(new ResourceSetImpl());
    Resource theirs = set.getResource(URI.createFileURI(file.toString()), true);
    Resource ours = EventChainMetamodel.store(UmlCase.FILES).load(file).resource();
    EcoreUtil.resolveAll(set);
    SortedMap<String, String> expected = values(theirs);
    assertEquals(elements, expected.keySet().stream().map(UmlValuesTest::owner).distinct().count());
    assertEquals(text(expected), text(values(ours)));
  }

  private static String owner(String feature) {
    return feature.replaceFirst(" .*", "");
  }

  private static String text(SortedMap<String, String> values) {
    StringBuilder text = new StringBuilder();
    values.forEach((feature, value) -> text.append(feature).append('=').append(value).append('\n'));
    return text.toString();
  }

  private static SortedMap<String, String> values(Resource resource) {
    SortedMap<String, String> values = new TreeMap<>();
    resource
        .getAllContents()
        .forEachRemaining(
            element -> {
              for (EStructuralFeature feature : element.eClass().getEAllStructuralFeatures()) {
                value(element, feature)
                    .ifPresent(value -> values.put(name(element) + " " + feature.getName(), value));
              }
            });
    return values;
  }

  /** Returns the value of a feature; empty for one that UML2 does not compute. */
  private static Optional<String> value(EObject element, EStructuralFeature feature) {
    try {
      return Optional.of(shown(element.eGet(feature)));
    } catch (UnsupportedOperationException e) {
      return Optional.empty();
    }
  }

  private static String shown(Object value) {
    if (value instanceof Collection<?> values) {
      return values.stream().map(UmlValuesTest::shown).toList().toString();
    }
    return value instanceof EObject element ? name(element) : String.valueOf(value);
  }

  private static String name(EObject element) {
    URI uri = EcoreUtil.getURI(element);
    return uri.trimFragment().lastSegment() + "#" + uri.fragment();
  }
}
