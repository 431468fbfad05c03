package dev.eventchain.xmi;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.uml.Uml;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.eclipse.emf.common.notify.impl.AdapterImpl;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.xml.namespace.XMLNamespacePackage;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/** Completes missing namespaces, and gives hints for unknown ones. */
final class Namespaces {

  /** A version as people write it into a namespace: {@code 1.0}, {@code v2}, {@code 2024}. */
  private static final Pattern VERSION = Pattern.compile("[vV]?[0-9]+([._-][0-9]+)*");

  private static final String LOAD = "Name its metamodel with --metamodel FILE.ecore.";

  private static final String UML2_HINT =
      "It is a UML2 model, which needs the classes of Eclipse UML2: install that.";

  /** The namespaces of CMOF, in which the OMG publishes metamodels. */
  private static final Pattern CMOF =
      Pattern.compile("http://(www|schema)\\.omg\\.org/spec/MOF/.*");

  private static final String CMOF_HINT =
      "It is a metamodel in CMOF, which is not read: name its .ecore file. That of UML is built in, as "
          + Uml.NAMESPACE
          + ", and need not be named.";

  /** The key of the metamodel of models without namespace. */
  static final String NONE = "";

  /** The packages that are registered for their data types only and have no models. */
  private static final Set<String> OF_TYPES =
      Set.of(NONE, XMLTypePackage.eNS_URI, XMLNamespacePackage.eNS_URI);

  /** Marks a package that had no nsURI of its own. */
  private static final class Nameless extends AdapterImpl {}

  private Namespaces() {}

  /**
   * Sets missing nsURIs: the name of the file, and for a subpackage the nsURI above and its name.
   * The first package of a file also serves models without namespace, as EMF writes them.
   */
  static void complete(EPackage ePackage, String file, EPackage.Registry registry) {
    if (isMissing(ePackage)) {
      ePackage.setNsURI(file);
      ePackage.eAdapters().add(new Nameless());
      registry.putIfAbsent(NONE, ePackage);
    }
    for (EPackage inner : ePackage.getESubpackages()) {
      complete(inner, ePackage.getNsURI() + "/" + inner.getName(), registry);
    }
  }

  /**
   * Returns the classes that a name without namespace may mean: EMF writes none for classes of any
   * package without nsURI.
   */
  static List<EClass> withoutNamespace(String name, EPackage.Registry registry) {
    return registry.values().stream()
        .filter(EPackage.class::isInstance)
        .map(EPackage.class::cast)
        .distinct()
        .filter(each -> each.eAdapters().stream().anyMatch(Nameless.class::isInstance))
        .sorted(Comparator.comparing(EPackage::getNsURI))
        .map(each -> each.getEClassifier(name))
        .filter(EClass.class::isInstance)
        .map(EClass.class::cast)
        .toList();
  }

  private static boolean isMissing(EPackage ePackage) {
    return ePackage.getNsURI() == null || ePackage.getNsURI().isBlank();
  }

  /** Names the loaded version of the same metamodel, else the nearest namespace. */
  static String hint(String unknown, Collection<String> registered) {
    if (Uml.isNamespace(unknown)) {
      return UML2_HINT;
    }
    if (CMOF.matcher(unknown).matches()) {
      return CMOF_HINT;
    }
    Optional<String> older = Uml.conversion(unknown);
    if (older.isPresent()) {
      return older.get();
    }
    Stream<String> uml = unknown.contains("/uml2/") ? Stream.of(Uml.NAMESPACE) : Stream.empty();
    List<String> known =
        Stream.concat(registered.stream().filter(uri -> !OF_TYPES.contains(uri)), uml).toList();
    String name = withoutVersion(unknown);
    List<String> versions =
        known.stream().filter(uri -> withoutVersion(uri).equals(name)).sorted().toList();
    if (!versions.isEmpty()) {
      return "The file was written for another version: `%s` is loaded. %s"
          .formatted(
              String.join("`, `", versions),
              "Migrate the file, or name its own metamodel with --metamodel FILE.ecore.");
    }
    String nearest = NearestName.hint(unknown, known);
    return nearest.isEmpty() ? LOAD : nearest + " " + LOAD;
  }

  private static String withoutVersion(String uri) {
    return VERSION.matcher(uri).replaceAll("#");
  }
}
