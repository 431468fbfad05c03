package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.uml.Uml;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;

/**
 * Reads and writes the XMI files of one project, for models of any Ecore metamodel.
 *
 * <p>Files are read as data: document types, entities, schema locations and Java classes that a
 * file names are not followed. References between files are followed only inside the project's
 * folder, or into an Eclipse project that they name ({@code platform:/resource/NAME/}) and that
 * lies above or next to a folder of the file. Not thread-safe.
 */
public final class XmiStore {

  /** An nsURI that was taken for a path, and so has lost one of its slashes. */
  private static final Pattern URI_AS_PATH = Pattern.compile("(https?):/([^/].*)");

  private final EPackage.Registry registry = new KnownPackages();
  private final ProjectFiles files;

  /** The resource set of all metamodels: a class is one object, whichever file refers to it. */
  private final ProjectResources metamodels;

  /**
   * Creates a store for the files below a folder. Ecore and UML are known.
   *
   * @param projectRoot the folder that references must not leave
   */
  public XmiStore(Path projectRoot) {
    this(List.of(projectRoot));
  }

  /**
   * As {@link #XmiStore(Path)} for files below several folders, which may refer to each other.
   *
   * @param folders the folders, named as in findings; the first that contains a file names it
   */
  public XmiStore(Collection<Path> folders) {
    this(folders, Map.of());
  }

  /**
   * As {@link #XmiStore(Collection)}, with mapped prefixes of references, such as {@code
   * platform:/resource/}.
   *
   * @param map the folders by prefix; references may lead into them as into the others
   */
  public XmiStore(Collection<Path> folders, Map<String, Path> map) {
    this(folders, map, List.of());
  }

  /**
   * As {@link #XmiStore(Collection, Map)}, with known metamodels that models need not name a file
   * of. A loaded metamodel replaces a known one with the same nsURI.
   */
  public XmiStore(Collection<Path> folders, Map<String, Path> map, Collection<EPackage> known) {
    known.forEach(each -> registry.put(each.getNsURI(), each));
    List<Path> all = new ArrayList<>(folders);
    all.addAll(map.values());
    files = new ProjectFiles(all, new MappedUris(map), registry);
    metamodels = new ProjectResources(files, registry);
  }

  /**
   * Reads a metamodel and registers it, its subpackages and those of the {@code .ecore} files it
   * refers to. It may replace a known metamodel, but two files must not have the same nsURI. A
   * package without nsURI gets the name of its file, and a subpackage a path below its package;
   * models of such a metamodel have that namespace or none.
   *
   * @param ecore a file; or the nsURI of a metamodel that is known, such as UML
   * @return the packages at the top of the file, at least one
   * @throws DiagnosticException (INPUT) with all findings about it
   */
  public List<EPackage> loadMetamodel(Path ecore) {
    Matcher uri = URI_AS_PATH.matcher(ecore.toString());
    if (uri.matches() && Files.notExists(ecore)) {
      return List.of(known(uri.group(1) + "://" + uri.group(2)));
    }
    int before = metamodels.getResources().size();
    try {
      return register(read(ecore, metamodels), before);
    } catch (DiagnosticException e) {
      metamodels.forgetFrom(before);
      throw e;
    }
  }

  private EPackage known(String nsUri) {
    EPackage known = registry.getEPackage(nsUri);
    if (known == null) {
      refuse(
          List.of(
              Diagnostic.of(
                      XmiRules.PACKAGE_UNKNOWN,
                      "There is no metamodel `%s` that needs no file.".formatted(nsUri),
                      SourceLocation.NONE)
                  .withHint(
                      "Known by their nsURI are `%s` and `%s`; name the .ecore file of others."
                          .formatted(EcorePackage.eNS_URI, Uml.NAMESPACE))));
    }
    return known;
  }

  /** Returns the place of an element of a metamodel that was loaded here. */
  public SourceLocation locateInMetamodel(EObject element) {
    return metamodels.origins().locate(element);
  }

  /** Checks and registers the files that were loaded from a position on. */
  private List<EPackage> register(XmiResource file, int before) {
    List<EPackage> packages = new ArrayList<>();
    List<Diagnostic> problems = new ArrayList<>();
    for (XmiResource each : metamodels.loaded()) {
      List<EPackage> own = packagesIn(each);
      if (metamodels.getResources().indexOf(each) >= before) {
        DiagnosticException.runAt(each.place(), () -> complete(own, each, problems));
        each.statements().faults().stream()
            .filter(fault -> fault.is(XmiRules.ID_DUPLICATE))
            .forEach(problems::add);
      }
      packages.addAll(own);
    }
    problems.addAll(new NamespaceOwners(metamodels.origins()).check(packages));
    List<EPackage> top = packages.stream().filter(p -> p.eResource() == file).toList();
    if (top.isEmpty()) {
      problems.add(noMetamodel(file.getContents().get(0)));
    }
    refuse(problems.stream().sorted().toList());
    packages.forEach(this::register);
    return top;
  }

  private Diagnostic noMetamodel(EObject root) {
    Diagnostic found =
        Diagnostic.of(
            XmiRules.METAMODEL_UNSOUND,
            "The file contains no EPackage.",
            metamodels.origins().locate(root));
    if (Uml.isProfile(root)) {
      return found.withHint(
          "It is a profile of UML, which is found where a model applies it: leave it out here.");
    }
    return Uml.isMetamodel(root.eClass().getEPackage())
        ? found.withHint(
            "It is a model of UML: name it as a model. The metamodel of UML is built in, as "
                + Uml.NAMESPACE
                + "; of another one that is drawn in UML, name its .ecore file.")
        : found;
  }

  /**
   * Reads a file of UML profiles, for what needs no model that applies them.
   *
   * @return the packages that define their stereotypes, the current one of each profile first; none
   *     if none is defined
   * @throws DiagnosticException (INPUT) with all findings about the file
   */
  public List<EPackage> loadProfiles(Path file) {
    ProjectResources resources = new ProjectResources(files, registry);
    List<EPackage> definitions = new ArrayList<>();
    read(file, resources)
        .getAllContents()
        .forEachRemaining(
            each -> {
              if (each instanceof EPackage definition
                  && definition.getESuperPackage() == null
                  && Uml.isDefinition(definition)) {
                definitions.add(definition);
              }
            });
    List<Diagnostic> problems = new ArrayList<>();
    for (EPackage definition : definitions) {
      JavaNames.forget(definition);
      problems.addAll(new MetamodelChecks(resources.origins()).check(definition));
    }
    refuse(problems);
    return definitions;
  }

  private static List<EPackage> packagesIn(XmiResource file) {
    return file.getContents().stream()
        .filter(EPackage.class::isInstance)
        .map(EPackage.class::cast)
        .toList();
  }

  private void complete(List<EPackage> packages, XmiResource file, List<Diagnostic> problems) {
    for (EPackage ePackage : packages) {
      Namespaces.complete(ePackage, file.getURI().lastSegment(), registry);
      JavaNames.forget(ePackage);
      problems.addAll(new MetamodelChecks(metamodels.origins()).check(ePackage));
    }
  }

  private void register(EPackage ePackage) {
    registry.put(ePackage.getNsURI(), ePackage);
    ePackage.getESubpackages().forEach(this::register);
  }

  /**
   * Reads a model and the files of the project that it refers to.
   *
   * @throws DiagnosticException (INPUT) with all findings about these files, including statements
   *     that the model does not hold
   */
  public LoadedModel load(Path model) {
    ProjectResources resources = new ProjectResources(files, registry);
    XmiResource read = read(model, resources);
    refuse(new Faults(resources).find());
    return new LoadedModel(read, resources.origins());
  }

  /**
   * Reads models that may refer to each other, and the files of the project that they refer to. An
   * element is one object, whichever file refers to it. Statements that the models do not hold,
   * such as a reference without its opposite end, are found by {@link EcoreChecks}.
   *
   * @param models the files in order; repeated files are left out
   * @return a model for each file, which share their origins and one resource set
   * @throws DiagnosticException (INPUT) with all findings about these files
   */
  public List<LoadedModel> loadAll(List<Path> models) {
    ProjectResources resources = new ProjectResources(files, registry);
    List<XmiResource> read =
        models.stream().map(model -> resources.fileOf(uriOf(model))).distinct().toList();
    resolve(resources);
    return read.stream().map(file -> new LoadedModel(file, resources.origins())).toList();
  }

  /**
   * Returns models that were loaded together, and those in other files that they refer to, except
   * for metamodels and profiles.
   *
   * @param models at least one, all of one {@link #loadAll}
   */
  public static List<LoadedModel> withReferred(List<LoadedModel> models) {
    List<LoadedModel> all = new ArrayList<>(models);
    ProjectResources resources = (ProjectResources) models.get(0).resource().getResourceSet();
    for (XmiResource file : resources.loaded()) {
      boolean named = models.stream().anyMatch(model -> model.resource() == file);
      List<EObject> roots = file.getContents(); // none if all are contained elsewhere
      if (!named && !roots.isEmpty() && !isMetamodel(roots.get(0))) {
        all.add(new LoadedModel(file, resources.origins()));
      }
    }
    return all;
  }

  private static boolean isMetamodel(EObject root) {
    return root instanceof EPackage || Uml.isProfile(root);
  }

  private static XmiResource read(Path path, ProjectResources resources) {
    XmiResource file = resources.fileOf(uriOf(path));
    resolve(resources);
    return file;
  }

  private static void resolve(ProjectResources resources) {
    new References(resources).resolve();
    new OneSidedEnds(resources).complete();
    refuse(resources.problems());
  }

  private static URI uriOf(Path path) {
    return URI.createFileURI(path.toAbsolutePath().normalize().toString());
  }

  private static void refuse(List<Diagnostic> problems) {
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
  }

  /**
   * Returns a model as XMI: UTF-8, LF, the same bytes for the same model. Reading and writing these
   * bytes again gives the same bytes. The model is not changed.
   *
   * @param root the root of a containment tree, in a resource or not
   * @throws DiagnosticException (FINDINGS, {@code xmi.unwritable}) for a text with characters that
   *     XML cannot hold, or a reference to an element that belongs to no model
   */
  public static byte[] toBytes(EObject root) {
    return toBytes(List.of(root));
  }

  /** As {@link #toBytes(EObject)} for a model with several roots. */
  public static byte[] toBytes(List<? extends EObject> roots) {
    return XmiWriter.write(roots);
  }
}
