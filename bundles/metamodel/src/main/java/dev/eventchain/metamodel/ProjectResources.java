package dev.eventchain.metamodel;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;

/** The files of one project that are loaded together; it holds no file outside the project. */
final class ProjectResources extends ResourceSetImpl {

  private final ProjectFiles files;
  private final Origins origins = new Origins();

  ProjectResources(ProjectFiles files, EPackage.Registry registry) {
    this.files = files;
    setPackageRegistry(registry);
  }

  Origins origins() {
    return origins;
  }

  List<XmiResource> loaded() {
    return getResources().stream()
        .filter(XmiResource.class::isInstance)
        .map(XmiResource.class::cast)
        .toList();
  }

  /** What is wrong with all files that were loaded, in the order of files and lines. */
  List<Diagnostic> problems() {
    return loaded().stream()
        .flatMap(file -> file.problems().found().stream())
        .distinct()
        .sorted()
        .toList();
  }

  /** The resource of a file or a metamodel; null if there is none that may be read. */
  @Override
  public Resource getResource(URI uri, boolean loadOnDemand) {
    if (files.isKnownMetamodel(uri)) {
      EPackage known = getPackageRegistry().getEPackage(uri.toString());
      return known == null ? EcorePackage.eINSTANCE.eResource() : known.eResource();
    }
    for (Resource resource : getResources()) {
      if (resource.getURI().equals(uri)) {
        return resource;
      }
    }
    boolean readable = files.isInside(uri) && Files.exists(Path.of(uri.toFileString()));
    if (!loadOnDemand || !readable) {
      return null;
    }
    return loadFile(uri);
  }

  /** The resource of a file that is to be read, wherever it lies. */
  XmiResource fileOf(URI uri) {
    for (XmiResource file : loaded()) {
      if (file.getURI().equals(uri)) {
        return file;
      }
    }
    return loadFile(uri);
  }

  /** Forgets the files that were loaded from a position on. */
  void forgetFrom(int position) {
    getResources().subList(position, getResources().size()).clear();
  }

  private XmiResource loadFile(URI uri) {
    XmiResource resource = new XmiResource(uri, files, getPackageRegistry(), origins);
    getResources().add(resource);
    resource.load(Map.of());
    return resource;
  }

  /** A registry of our own, with the two metamodels that are always there. */
  static void registerStandard(EPackage.Registry registry) {
    registry.put(EcorePackage.eNS_URI, EcorePackage.eINSTANCE);
    registry.put(EventchainPackage.eNS_URI, EventchainPackage.eINSTANCE);
  }
}
