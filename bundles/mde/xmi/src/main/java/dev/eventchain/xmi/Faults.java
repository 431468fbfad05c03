package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.uml.Uml;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.FeatureMap;
import org.eclipse.emf.ecore.util.FeatureMapUtil;
import org.eclipse.emf.ecore.util.InternalEList;

/**
 * Finds differences between models and their files: a reference whose opposite end is missing, and
 * duplicates in unique features. The references of the files must be resolved.
 */
final class Faults {

  private final ProjectResources resources;
  private final Map<EClass, List<EStructuralFeature>> unpaired = new HashMap<>();
  private final Map<XmiResource, List<EObject>> contents = new HashMap<>();
  private final List<Diagnostic> found = new ArrayList<>();

  Faults(ProjectResources resources) {
    this.resources = resources;
  }

  /** Returns the elements of a file, which are collected once. */
  List<EObject> contentsOf(XmiResource file) {
    return contents.computeIfAbsent(file, Contents::of);
  }

  /** Returns the findings in the order of files and lines; removes duplicates. */
  List<Diagnostic> find() {
    List<XmiResource> files = resources.loaded();
    for (XmiResource file : files) {
      found.addAll(file.statements().faults());
      file.statements().ends().resolve(file::targetOf);
    }
    Ends ends = Ends.of(files.stream().map(file -> file.statements().ends()).toList());
    int from = 0;
    for (XmiResource file : files) {
      int first = from;
      int next = first + file.statements().ends().size();
      DiagnosticException.runAt(file.place(), () -> check(file, ends, first, next));
      from = next;
    }
    ends.forgetLinks();
    for (XmiResource file : files) {
      DiagnosticException.runAt(file.place(), () -> findDuplicates(file));
    }
    return found.stream().distinct().sorted().toList();
  }

  /** Checks some of all ends, which are those of one file. */
  private void check(XmiResource file, Ends ends, int from, int to) {
    for (int end = from; end < to; end++) {
      if (ends.target(end) == null) {
        continue;
      }
      EReference feature = ends.feature(end);
      // That a feature of one value has a second one is found where it is read.
      if (feature.isMany() && feature.isUnique() && ends.firstOf(end) != end) {
        String target = ModelPath.of((EObject) ends.target(end));
        found.add(duplicate(file, ends.element(end), ends.tag(end), feature, target));
      }
      // UML's files may leave out one end.
      boolean derivable =
          Uml.isMetamodel(feature.getEOpposite().getEContainingClass().getEPackage());
      if (!derivable && !ends.isNamedBack(end)) {
        found.add(singleEnd(file, ends, end));
      }
    }
  }

  private Diagnostic singleEnd(XmiResource file, Ends ends, int end) {
    EReference feature = ends.feature(end);
    EObject target = (EObject) ends.target(end);
    String message =
        "`%s` of %s names %s, but `%s` there does not name it back."
            .formatted(
                feature.getName(),
                ModelPath.of(ends.element(end)),
                ModelPath.of(target),
                feature.getEOpposite().getName());
    return Diagnostic.of(EcoreRules.OPPOSITE, message, place(file, ends.tag(end), feature))
        .withRelated(resources.origins().locate(target))
        .withHint(
            "Write both ends, or neither: which of them a reader keeps depends on the order of the"
                + " elements.");
  }

  private static SourceLocation place(XmiResource file, int tag, EStructuralFeature feature) {
    return file.problems().text().at(file.problems().attributeIn(tag, feature.getName()));
  }

  private void findDuplicates(XmiResource file) {
    for (EObject element : contentsOf(file)) {
      for (EStructuralFeature feature :
          unpaired.computeIfAbsent(element.eClass(), Faults::unpairedOf)) {
        if (element.eIsSet(feature)) {
          findDuplicates(file, element, feature);
        }
      }
    }
  }

  /** Returns the features in which duplicates are searched here. */
  private static List<EStructuralFeature> unpairedOf(EClass type) {
    return type.getEAllStructuralFeatures().stream()
        .filter(feature -> holdsEachOnce(feature) && !isPaired(feature))
        .toList();
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
