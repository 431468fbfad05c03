package dev.eventchain.eclipse;

import dev.eventchain.check.ProjectValidation;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IResourceVisitor;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;

/** The files of an Eclipse project that are checked, by what they are. */
final class CheckedFiles {

  /** The file that makes a folder a project of Eventchain. */
  static final String CONFIGURATION = "eventchain.yaml";

  /** Where such a project has its results. */
  static final String OUTPUT = "out";

  private final List<IContainer> folders = new ArrayList<>();
  private final List<IFile> models = new ArrayList<>();
  private final List<IFile> metamodels = new ArrayList<>();
  private final List<IFile> rules = new ArrayList<>();
  private final List<IFile> templates = new ArrayList<>();

  /** Models of the project's metamodels may be among them. */
  private final List<IFile> others = new ArrayList<>();

  private CheckedFiles() {}

  /** Looks through a project, but not through what is derived, and not through results. */
  static CheckedFiles of(IProject project) throws CoreException {
    CheckedFiles files = new CheckedFiles();
    project.accept((IResourceVisitor) files::take);
    return files;
  }

  private boolean take(IResource resource) {
    if (resource.isDerived() || resource.isTeamPrivateMember() || resource.isPhantom()) {
      return false;
    }
    if (resource instanceof IContainer folder) {
      boolean results = folder.getName().equals(OUTPUT) && isProjectFolder(folder.getParent());
      if (!results && isProjectFolder(folder)) {
        folders.add(folder);
      }
      return !results && !folder.getName().startsWith(".");
    }
    IFile file = (IFile) resource;
    switch (String.valueOf(file.getFileExtension()).toLowerCase(Locale.ROOT)) {
      case "xmi", "eventchain" -> models.add(file);
      case "ecore" -> metamodels.add(file);
      case "ocl" -> rules.add(file);
      case "mtl" -> templates.add(file);
      default -> others.add(file);
    }
    return false;
  }

  static boolean isProjectFolder(IContainer folder) {
    return folder.getType() != IResource.ROOT
        && folder.getFile(IPath.fromOSString(CONFIGURATION)).exists();
  }

  /**
   * The units that these files make, in the order of their names.
   *
   * @param validations gives the validation of a project's folder
   */
  List<CheckUnit> units(Function<Path, ProjectValidation> validations) {
    List<CheckUnit> units = new ArrayList<>();
    List<Path> ecores = paths(metamodels);
    List<Path> documents = paths(freeRules());
    for (IContainer folder : folders) {
      units.add(unit(folder, path -> new ProjectUnit(folder, path, validations.apply(path))));
    }
    Set<String> extensions = Metamodels.extensions(ecores);
    others.removeIf(each -> !extensions.contains(String.valueOf(each.getFileExtension())));
    models.addAll(others);
    for (IFile model : models) {
      if (units.stream().noneMatch(unit -> unit instanceof ProjectUnit p && p.hasChain(model))) {
        units.add(unit(model, path -> new ModelUnit(model, path, ecores, documents)));
      }
    }
    for (IFile metamodel : metamodels) {
      units.add(unit(metamodel, path -> new MetamodelUnit(metamodel, path, ecores)));
    }
    for (IFile document : rules) {
      if (units.stream().noneMatch(unit -> unit instanceof ProjectUnit p && p.hasRules(document))) {
        units.add(unit(document, path -> new RulesUnit(document, path, ecores)));
      }
    }
    for (IFile template : templates) {
      units.add(unit(template, path -> new TemplateUnit(template, path, ecores)));
    }
    return units;
  }

  /** The documents that belong to no project of Eventchain. */
  private List<IFile> freeRules() {
    return rules.stream()
        .filter(
            each -> folders.stream().noneMatch(f -> f.getFullPath().isPrefixOf(each.getFullPath())))
        .toList();
  }

  private static CheckUnit unit(IResource subject, Function<Path, CheckUnit> onDisk) {
    return pathOf(subject).map(onDisk).orElseGet(() -> new UnreachableUnit(subject));
  }

  private static List<Path> paths(List<IFile> files) {
    return files.stream().flatMap(file -> pathOf(file).stream()).toList();
  }

  /** Where a resource is on this machine's disk; nowhere if it is on another one's. */
  static Optional<Path> pathOf(IResource resource) {
    return Optional.ofNullable(resource.getLocation()).map(IPath::toPath);
  }
}
