package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.uml.Uml;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.util.FeatureMap;
import org.eclipse.emf.ecore.util.FeatureMapUtil;
import org.eclipse.emf.ecore.util.InternalEList;

/**
 * Finds differences between models and their files: a reference whose opposite end is missing, and
 * duplicates in unique features. The references of the files must be resolved.
 */
final class Faults {

  private record Link(EObject from, EReference feature, EObject to) {}

  private final ProjectResources resources;
  private final Set<Link> links = new HashSet<>();
  private final List<Diagnostic> found = new ArrayList<>();

  Faults(ProjectResources resources) {
    this.resources = resources;
  }

  /** Returns the findings in the order of files and lines; removes duplicates. */
  List<Diagnostic> find() {
    List<XmiResource> files = resources.loaded();
    for (XmiResource file : files) {
      found.addAll(file.statements().faults());
      for (Statements.End end : file.statements().ends()) {
        Link link = linkOf(file, end);
        if (!links.add(link) && end.feature().isUnique() && link.to != null) {
          found.add(duplicate(file, link.from, end.tag(), end.feature(), ModelPath.of(link.to)));
        }
      }
    }
    for (XmiResource file : files) {
      DiagnosticException.runAt(file.place(), () -> findSingleEnds(file));
    }
    for (XmiResource file : files) {
      DiagnosticException.runAt(file.place(), () -> findDuplicates(file));
    }
    return found.stream().distinct().sorted().toList();
  }

  private Link linkOf(XmiResource file, Statements.End end) {
    Object target = end.target();
    if (target instanceof String id) {
      target = file.getEObject(id);
    } else if (target instanceof InternalEObject proxy && proxy.eIsProxy()) {
      target = resources.getEObject(proxy.eProxyURI(), false);
    }
    return new Link(end.element(), end.feature(), (EObject) target);
  }

  private void findSingleEnds(XmiResource file) {
    for (Statements.End end : file.statements().ends()) {
      Link link = linkOf(file, end);
      EReference opposite = end.feature().getEOpposite();
      boolean derivable = Uml.isMetamodel(opposite.getEContainingClass().getEPackage());
      if (link.to != null
          && !derivable // UML's files may leave out one end
          && !links.contains(new Link(link.to, opposite, link.from))) {
        String message =
            "`%s` of %s names %s, but `%s` there does not name it back."
                .formatted(
                    end.feature().getName(),
                    ModelPath.of(link.from),
                    ModelPath.of(link.to),
                    opposite.getName());
        found.add(
            Diagnostic.of(EcoreRules.OPPOSITE, message, place(file, end.tag(), end.feature()))
                .withRelated(resources.origins().locate(link.to))
                .withHint(
                    "Write both ends, or neither: which of them a reader keeps depends on the order"
                        + " of the elements."));
      }
    }
  }

  private static SourceLocation place(XmiResource file, int tag, EStructuralFeature feature) {
    return file.problems().text().at(file.problems().attributeIn(tag, feature.getName()));
  }

  private void findDuplicates(XmiResource file) {
    List<EObject> all = new ArrayList<>(); // the lists do not change meanwhile
    Iterator<EObject> contents = EcoreUtil.getAllProperContents((Resource) file, false);
    contents.forEachRemaining(all::add);
    for (EObject element : all) {
      for (EStructuralFeature feature : element.eClass().getEAllStructuralFeatures()) {
        if (holdsEachOnce(feature) && !isPaired(feature) && element.eIsSet(feature)) {
          findDuplicates(file, element, feature);
        }
      }
    }
  }

  /** Returns whether the feature is checked together with its opposite. */
  private static boolean isPaired(EStructuralFeature feature) {
    return feature instanceof EReference reference && Statements.hasWrittenOpposite(reference);
  }

  /**
   * Returns whether a feature is a stored list in which no value may occur twice. Of a feature map,
   * only its members decide: XML Schema's maps are never unique themselves, and for others the flag
   * has no meaning.
   */
  static boolean holdsEachOnce(EStructuralFeature feature) {
    boolean stored = feature.isMany() && !feature.isDerived() && !feature.isVolatile();
    return stored && (FeatureMapUtil.isFeatureMap(feature) || hasUniqueValues(feature));
  }

  private static boolean hasUniqueValues(EStructuralFeature feature) {
    return feature.isMany()
        && feature.isUnique()
        && !(feature instanceof EReference reference && reference.isContainment());
  }

  private static boolean mayStandAgain(Object value) {
    return value instanceof FeatureMap.Entry entry
        && (!hasUniqueValues(entry.getEStructuralFeature())
            || isPaired(entry.getEStructuralFeature()));
  }

  private void findDuplicates(XmiResource file, EObject element, EStructuralFeature feature) {
    List<?> values = (List<?>) element.eGet(feature, false);
    List<?> basic = values instanceof InternalEList<?> list ? list.basicList() : values;
    if (basic.size() < 2) {
      return;
    }
    Set<Object> seen = new HashSet<>();
    List<Integer> again = new ArrayList<>();
    for (int i = 0; i < basic.size(); i++) {
      if (!mayStandAgain(basic.get(i)) && !seen.add(basic.get(i))) {
        again.add(i);
      }
    }
    for (int i = again.size() - 1; i >= 0; i--) {
      int index = again.get(i);
      report(file, element, feature, basic.get(index));
      boolean inverse = feature instanceof EReference r && r.getEOpposite() != null;
      if (!inverse) { // the opposite may name this element once
        values.remove(index);
      }
    }
  }

  private void report(XmiResource file, EObject element, EStructuralFeature feature, Object value) {
    if (value instanceof FeatureMap.Entry entry) {
      report(file, element, entry.getEStructuralFeature(), entry.getValue());
      return;
    }
    String shown = value instanceof EObject object ? ModelPath.of(object) : "`" + value + "`";
    found.add(duplicate(file, element, file.offsetOf(element, 0), feature, shown));
  }

  /** Returns the finding for a duplicate in a unique feature. */
  static Diagnostic duplicate(
      XmiResource file, EObject element, int tag, EStructuralFeature feature, String value) {
    return Diagnostic.of(
            EcoreRules.UNIQUE,
            "`%s` of %s holds %s twice, but its values must be unique."
                .formatted(feature.getName(), ModelPath.of(element), value),
            place(file, tag, feature))
        .withHint("Name it once, or declare the feature with unique=\"false\".");
  }
}
