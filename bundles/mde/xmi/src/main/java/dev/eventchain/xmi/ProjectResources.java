package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.uml.Uml;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;

/** The files of one project that are loaded together; none lies outside the project. */
final class ProjectResources extends ResourceSetImpl {

  private static final int DEEPEST = 16;

  /** The number of files that are being read because of one another. */
  private int nesting;

  private final ProjectFiles files;
  private final Origins origins = new Origins();

  /** The real paths of files, cached since the file system is slow. */
  private final Map<URI, Path> realPaths = new HashMap<>();

  ProjectResources(ProjectFiles files, EPackage.Registry registry) {
    this.files = files;
    setPackageRegistry(registry);
  }

  /**
   * Returns what a file names that is read while another one is being read; empty if too many of
   * them name each other.
   */
  <T> Optional<T> nested(Supplier<T> reading) {
    if (nesting == DEEPEST) {
      return Optional.empty();
    }
    nesting++;
    try {
      return Optional.ofNullable(reading.get());
    } finally {
      nesting--;
    }
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

  /** Returns the findings about all loaded files, in the order of files and lines. */
  List<Diagnostic> problems() {
    return loaded().stream()
        .flatMap(file -> file.problems().found().stream())
        .distinct()
        .sorted()
        .toList();
  }

  /** Returns the resource of a file or a metamodel; null if there is none that may be read. */
  @Override
  public Resource getResource(URI uri, boolean loadOnDemand) {
    if (files.isKnownMetamodel(uri)) {
      return getPackageRegistry().getEPackage(uri.toString()).eResource();
    }
    if (Uml.isLibrary(uri)) {
      return Uml.library(uri).orElse(null);
    }
    Optional<XmiResource> loaded = find(uri);
    if (loaded.isPresent()) {
      return loaded.get();
    }
    boolean readable = files.isInside(uri) && Files.exists(Path.of(uri.toFileString()));
    if (!loadOnDemand || !readable) {
      return null;
    }
    return loadFile(uri);
  }

  /** Returns the resource of a file to read, wherever it lies. */
  XmiResource fileOf(URI uri) {
    return find(uri).orElseGet(() -> loadFile(uri));
  }

  /** Finds the resource of a file by any of its names, such as links and other spellings. */
  private Optional<XmiResource> find(URI uri) {
    for (XmiResource file : loaded()) {
      if (file.getURI().equals(uri)) {
        return Optional.of(file);
      }
    }
    Path real = realPaths.computeIfAbsent(uri, ProjectResources::realPath);
    return loaded().stream().filter(file -> realPaths.get(file.getURI()).equals(real)).findFirst();
  }

  /** Returns the real path of a URI; the empty path, which no file has, for none. */
  private static Path realPath(URI uri) {
    try {
      return uri.isFile() ? ProjectFiles.realPath(Path.of(uri.toFileString())) : Path.of("");
    } catch (InvalidPathException e) {
      return Path.of("");
    }
  }

  /** Forgets the files that were loaded from a position on. */
  void forgetFrom(int position) {
    getResources().subList(position, getResources().size()).clear();
  }

  private XmiResource loadFile(URI uri) {
    realPaths.computeIfAbsent(uri, ProjectResources::realPath);
    XmiResource resource = new XmiResource(uri, files, getPackageRegistry(), origins);
    getResources().add(resource);
    resource.load(Map.of());
    return resource;
  }
}
