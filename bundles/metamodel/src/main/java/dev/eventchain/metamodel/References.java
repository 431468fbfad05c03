package dev.eventchain.metamodel;

import dev.eventchain.diagnostics.Diagnostic;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.util.InternalEList;

/** Resolves the references between the files of a project, and finds those that lead nowhere. */
final class References {

  private final ProjectResources resources;

  References(ProjectResources resources) {
    this.resources = resources;
  }

  /** Resolves all references; files that they lead to are loaded and treated likewise. */
  void resolve() {
    for (int i = 0; i < resources.getResources().size(); i++) {
      if (resources.getResources().get(i) instanceof XmiResource file) {
        resolve(file);
      }
    }
  }

  private void resolve(XmiResource file) {
    List<EObject> elements = new ArrayList<>();
    Iterator<EObject> all = EcoreUtil.getAllProperContents((Resource) file, false);
    all.forEachRemaining(elements::add);
    for (EObject element : elements) {
      for (EReference reference : element.eClass().getEAllReferences()) {
        if (!reference.isDerived() && !reference.isContainer() && element.eIsSet(reference)) {
          resolve(file, element, reference);
        }
      }
    }
  }

  private void resolve(XmiResource file, EObject element, EReference reference) {
    Object value = element.eGet(reference, false);
    List<?> values = reference.isMany() ? basic((List<?>) value) : List.of(value);
    for (Object target : values) {
      if (target instanceof InternalEObject proxy && proxy.eIsProxy()) {
        resolveProxy(file, element, reference, proxy);
      } else if (target instanceof EObject object && !reference.getEType().isInstance(object)) {
        reportWrongType(file, element, reference, object);
      }
    }
  }

  private static List<?> basic(List<?> values) {
    return values instanceof InternalEList<?> internal
        ? new ArrayList<>(internal.basicList())
        : new ArrayList<>(values);
  }

  private void resolveProxy(
      XmiResource file, EObject element, EReference reference, InternalEObject proxy) {
    int offset = file.offsetOfProxy(proxy);
    EObject target = null;
    String problem = "names no element";
    if (isMissing(proxy.eProxyURI())) {
      problem = "names a file that does not exist";
    }
    try {
      target = resources.getEObject(proxy.eProxyURI(), true);
      if (target != null && !reference.getEType().isInstance(target)) {
        problem =
            "names a " + target.eClass().getName() + ", not a " + reference.getEType().getName();
        target = null;
      } else if (target != null) {
        EcoreUtil.replace(element, reference, proxy, target);
      }
    } catch (RuntimeException e) {
      // A fragment that is no path, or a containment that would close a circle.
      target = null;
      problem = "cannot be followed (" + e.getMessage() + ")";
    }
    if (target == null) {
      String shown = proxy.eProxyURI().deresolve(file.getURI()).toString();
      file.problems()
          .add("xmi.reference.unresolved", "`" + shown + "` " + problem + ".", offset, "");
    }
  }

  private static boolean isMissing(URI target) {
    return target.isFile() && Files.notExists(Path.of(target.toFileString()));
  }

  private void reportWrongType(
      XmiResource file, EObject element, EReference reference, EObject target) {
    String message =
        "A %s is no value for feature `%s` of type `%s`."
            .formatted(
                target.eClass().getName(), reference.getName(), reference.getEType().getName());
    file.problems()
        .found()
        .add(Diagnostic.error("xmi.value.illegal", message, resources.origins().locate(element)));
  }
}
