package dev.eventchain.xmi;

import dev.eventchain.uml.Uml;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/**
 * The UML profiles that a file names as the schemas of its stereotypes. They are files of the
 * project that the model refers to anyway; no other metamodel is taken from a place that a model
 * names.
 */
final class AppliedProfiles {

  private final XmiResource file;
  private final Map<String, String> places = new HashMap<>();
  private final Map<String, Optional<EPackage>> known = new HashMap<>();

  AppliedProfiles(XmiResource file) {
    this.file = file;
  }

  /** Notes the value of {@code xsi:schemaLocation}: pairs of a namespace and a place. */
  void note(String schemaLocations) {
    String[] parts = schemaLocations.strip().split("\\s+", -1);
    for (int i = 0; i + 1 < parts.length; i += 2) {
      places.putIfAbsent(parts[i], parts[i + 1]);
    }
  }

  /** Returns the package that defines the stereotypes of a namespace. */
  Optional<EPackage> definition(String nsUri) {
    return known.computeIfAbsent(nsUri, this::find);
  }

  /** Returns a hint for a namespace without definition; empty if the file names no place. */
  Optional<String> hint(String nsUri) {
    return Optional.ofNullable(places.get(nsUri))
        .map(
            place ->
                MappedUris.isPlatform(place)
                    ? MappedUris.hint(place)
                    : "If it is a UML profile, `%s` must be its file, with its definition, below the folders of the given files."
                        .formatted(place.replaceFirst("#.*", "")));
  }

  private Optional<EPackage> find(String nsUri) {
    String place = places.get(nsUri);
    if (place == null || !place.contains("#")) {
      return Optional.empty();
    }
    String mapped = file.files().mapped(file.getURI(), place);
    if (file.files().refusal(file.getURI(), mapped).isPresent()) {
      return Optional.empty();
    }
    ProjectResources resources = (ProjectResources) file.getResourceSet();
    URI uri = URI.createURI(mapped).resolve(file.getURI());
    EObject found = resources.nested(() -> resources.getEObject(uri, true)).orElse(null);
    if (found instanceof EPackage definition
        && nsUri.equals(definition.getNsURI())
        && Uml.isDefinition(definition)) {
      complete(definition);
      return Optional.of(definition);
    }
    return Optional.empty();
  }

  /** Makes sure that instances run no code that the profile names, as for other metamodels. */
  private void complete(EPackage definition) {
    JavaNames.forget(definition);
    ProjectResources resources = (ProjectResources) file.getResourceSet();
    file.problems().found().addAll(new MetamodelChecks(resources.origins()).check(definition));
  }
}
