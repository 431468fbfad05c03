package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EPackage;

/** The packages by namespace; of two with the same namespace, models could mean either. */
final class NamespaceOwners {

  private final Origins origins;
  private final Map<String, EPackage> owners = new HashMap<>();
  private final List<Diagnostic> found = new ArrayList<>();

  NamespaceOwners(Origins origins) {
    this.origins = origins;
  }

  /** Returns the findings about packages and subpackages; the first with a namespace owns it. */
  List<Diagnostic> check(List<EPackage> packages) {
    for (EPackage ePackage : packages) {
      EPackage owner = owners.putIfAbsent(ePackage.getNsURI(), ePackage);
      if (owner != null && ePackage.getNsURI() != null) {
        found.add(
            Diagnostic.of(
                    XmiRules.NAMESPACE_DUPLICATE,
                    "The packages `%s` and `%s` have the same nsURI `%s`."
                        .formatted(owner.getName(), ePackage.getName(), ePackage.getNsURI()),
                    origins.locate(ePackage))
                .withRelated(origins.locate(owner))
                .withHint("Give each package its own nsURI, and load each metamodel once."));
      }
      check(ePackage.getESubpackages());
    }
    return found;
  }
}
