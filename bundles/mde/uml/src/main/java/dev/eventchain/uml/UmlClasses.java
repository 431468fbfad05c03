package dev.eventchain.uml;

import java.util.Optional;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.common.util.WrappedException;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.uml2.types.TypesPackage;
import org.eclipse.uml2.uml.Profile;
import org.eclipse.uml2.uml.UMLPackage;
import org.eclipse.uml2.uml.UMLPlugin;
import org.eclipse.uml2.uml.profile.standard.StandardPackage;
import org.eclipse.uml2.uml.resources.util.UMLResourcesUtil;

/** Code that needs the classes of Eclipse UML2, apart so that {@link Uml} can do without. */
final class UmlClasses {

  /** The files that come with UML2, and the URIs of the profiles among them by their namespaces. */
  private static final ResourceSet LIBRARIES = UMLResourcesUtil.init(new ResourceSetImpl());

  private UmlClasses() {}

  static Optional<EPackage> metamodel(String nsUri, boolean isUml) {
    if (isUml) {
      return Optional.of(UMLPackage.eINSTANCE);
    } else if (nsUri.endsWith("/Types")) {
      return Optional.of(TypesPackage.eINSTANCE);
    }
    URI profile = UMLPlugin.getEPackageNsURIToProfileLocationMap().get(nsUri);
    return profile == null ? Optional.empty() : definition(profile, nsUri);
  }

  static Optional<EPackage> standardProfile() {
    return Optional.of(StandardPackage.eINSTANCE);
  }

  /** Returns the package that defines a profile: a registered one, or that in its file. */
  private static Optional<EPackage> definition(URI profile, String nsUri) {
    EPackage registered = EPackage.Registry.INSTANCE.getEPackage(nsUri);
    if (registered != null) {
      return Optional.of(registered);
    }
    return library(profile.trimFragment())
        .map(file -> file.getEObject(profile.fragment()))
        .filter(Profile.class::isInstance)
        .map(found -> ((Profile) found).getDefinition());
  }

  static synchronized Optional<Resource> library(URI file) {
    try {
      Resource known = LIBRARIES.getResource(file, false);
      if (known != null && known.isLoaded()) {
        return Optional.of(known); // resolved when it was loaded
      }
      Resource resource = LIBRARIES.getResource(file, true);
      EcoreUtil.resolveAll(resource);
      return Optional.of(resource);
    } catch (WrappedException e) {
      LIBRARIES.getResources().removeIf(each -> each.getURI().equals(file));
      return Optional.empty();
    }
  }
}
