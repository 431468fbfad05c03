package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.util.FeatureMap;
import org.eclipse.emf.ecore.util.FeatureMapUtil;
import org.eclipse.emf.ecore.util.InternalEList;

/** Resolves the references between the files of a project, and reports those without a target. */
final class References {

  /**
   * The features of a class that store references.
   *
   * @param references those except for containers, which are resolved separately
   * @param maps the feature maps
   */
  private record Plan(List<EReference> references, List<EAttribute> maps) {
    static Plan of(EClass type) {
      return new Plan(
          type.getEAllReferences().stream().filter(Plan::holdsValues).toList(),
          type.getEAllAttributes().stream()
              .filter(each -> FeatureMapUtil.isFeatureMap(each) && !each.isDerived())
              .toList());
    }

    private static boolean holdsValues(EReference reference) {
      boolean computed = reference.isVolatile() || !reference.isChangeable();
      return !reference.isContainer() && !(reference.isDerived() && computed);
    }
  }

  private final Map<EClass, Plan> plans = new HashMap<>();
  private final ProjectResources resources;

  References(ProjectResources resources) {
    this.resources = resources;
  }

  /** Resolves all references, also those of the files that are loaded for them. */
  void resolve() {
    for (int i = 0; i < resources.getResources().size(); i++) {
      if (resources.getResources().get(i) instanceof XmiResource file) {
        DiagnosticException.runAt(file.place(), () -> resolve(file));
      }
    }
  }

  private void resolve(XmiResource file) {
    for (EObject element : Contents.of(file)) {
      Plan plan = plans.computeIfAbsent(element.eClass(), Plan::of);
      for (EReference reference : plan.references()) {
        if (element.eIsSet(reference)) {
          resolve(file, element, reference);
        }
      }
      for (EAttribute map : plan.maps()) {
        resolve(file, (FeatureMap.Internal) element.eGet(map, false), element);
      }
      InternalEObject container = ((InternalEObject) element).eInternalContainer();
      if (container != null && container.eIsProxy()) {
        resolveContainer(file, element, container);
      }
    }
  }

  private void resolve(XmiResource file, FeatureMap.Internal map, EObject element) {
    for (int i = 0; i < map.size(); i++) {
      FeatureMap.Entry entry = map.basicList().get(i);
      if (entry.getEStructuralFeature() instanceof EReference reference
          && entry.getValue() instanceof InternalEObject proxy
          && proxy.eIsProxy()) {
        EObject target = targetOf(file, reference, proxy);
        if (target != null && mayHold(file, element, reference, proxy, target)) {
          map.setUnique(i, FeatureMapUtil.createEntry(reference, target));
        }
      }
    }
  }

  /** Resolves a container that the child names in another file. */
  private void resolveContainer(XmiResource file, EObject element, InternalEObject proxy) {
    EReference reference = element.eContainmentFeature().getEOpposite();
    EObject target = targetOf(file, reference, proxy);
    if (target != null && new Containers(element).closeCircleBelow(target)) {
      file.problems().addCircle(file.offsetOfProxy(proxy));
    }
  }

  private static String shown(XmiResource file, InternalEObject proxy) {
    return proxy.eProxyURI().deresolve(file.getURI()).toString();
  }

  private void refuseSecondContainer(XmiResource file, InternalEObject proxy, EObject target) {
    file.problems()
        .add(
            XmiRules.CONTAINMENT_TWICE,
            "`%s` is already part of %s."
                .formatted(shown(file, proxy), ModelPath.of(target.eContainer())),
            file.offsetOfProxy(proxy),
            "Keep it in one place, and refer to it from the other.");
  }

  private void resolve(XmiResource file, EObject element, EReference reference) {
    Object value = element.eGet(reference, false);
    if (!reference.isMany()) {
      resolve(file, element, reference, value);
    } else {
      List<?> values = value instanceof InternalEList<?> list ? list.basicList() : (List<?>) value;
      // Resolving changes the list.
      for (Object target : values.toArray()) {
        resolve(file, element, reference, target);
      }
    }
  }

  private void resolve(XmiResource file, EObject element, EReference reference, Object target) {
    if (target instanceof InternalEObject proxy && proxy.eIsProxy()) {
      resolveProxy(file, element, reference, proxy);
    } else if (target instanceof EObject object && !reference.getEType().isInstance(object)) {
      reportWrongType(file, element, reference, object);
    }
  }

  private void resolveProxy(
      XmiResource file, EObject element, EReference reference, InternalEObject proxy) {
    EObject target = targetOf(file, reference, proxy);
    if (target == null) {
      return;
    }
    if (!mayHold(file, element, reference, proxy, target)) {
      return;
    }
    if (reference.isMany() && reference.isUnique() && holds(element, reference, target)) {
      if (!Statements.hasWrittenOpposite(reference)) { // else Faults compares the ends
        int tag = file.offsetOf(element, 0);
        String name = ModelPath.of(target);
        file.statements().addFault(Faults.duplicate(file, element, tag, reference, name));
      }
      EcoreUtil.remove(element, reference, proxy);
    } else {
      EcoreUtil.replace(element, reference, proxy, target);
    }
  }

  /** Returns whether an element may contain the target, if the reference is a containment. */
  private boolean mayHold(
      XmiResource file,
      EObject element,
      EReference reference,
      InternalEObject proxy,
      EObject target) {
    if (!reference.isContainment()) {
      return true;
    }
    if (new Containers(element).closeCircleBelow(target)) {
      file.problems().addCircle(file.offsetOfProxy(proxy));
      return false;
    }
    if (target.eContainer() != null && target.eContainer() != element) {
      refuseSecondContainer(file, proxy, target);
      return false;
    }
    return true;
  }

  private static boolean holds(EObject element, EReference reference, EObject target) {
    return ((InternalEList<?>) element.eGet(reference, false)).basicContains(target);
  }

  /** Returns the target of a reference; null, with a finding, if there is no valid one. */
  private EObject targetOf(XmiResource file, EReference reference, InternalEObject proxy) {
    String problem = "names no element";
    EObject target = null;
    try {
      target = resources.getEObject(proxy.eProxyURI(), true);
    } catch (RuntimeException e) {
      // A fragment that is not a path.
      problem = "cannot be followed (" + e.getMessage() + ")";
    }
    if (target != null && reference.getEType().isInstance(target)) {
      return target;
    }
    if (target != null) {
      problem =
          "names a " + target.eClass().getName() + ", not a " + reference.getEType().getName();
    } else if (isMissing(proxy.eProxyURI())) {
      problem = "names a file that does not exist";
    }
    file.problems()
        .add(
            XmiRules.REFERENCE_UNRESOLVED,
            "`%s` %s.".formatted(shown(file, proxy), problem),
            file.offsetOfProxy(proxy),
            "");
    return null;
  }

  private static boolean isMissing(URI target) {
    return target.isFile() && Files.notExists(Path.of(target.toFileString()));
  }

  private void reportWrongType(
      XmiResource file, EObject element, EReference reference, EObject target) {
    String message =
        "A %s is not a valid value for feature `%s` of type `%s`."
            .formatted(
                target.eClass().getName(), reference.getName(), reference.getEType().getName());
    file.problems()
        .found()
        .add(Diagnostic.of(XmiRules.VALUE_ILLEGAL, message, resources.origins().locate(element)));
  }
}
