package dev.eventchain.eclipse;

import dev.eventchain.check.Metamodels;
import dev.eventchain.check.ProjectValidation;
import dev.eventchain.project.ProjectLayout;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IResourceVisitor;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;

/** Checked files of an Eclipse project, by kind. */
final class CheckedFiles {

  private final List<IContainer> folders = new ArrayList<>();
  private final List<IFile> models = new ArrayList<>();
  private final List<IFile> metamodels = new ArrayList<>();
  private final List<IFile> rules = new ArrayList<>();
  private final List<IFile> templates = new ArrayList<>();

  /** Other files, which may include models of the project's metamodels. */
  private final List<IFile> others = new ArrayList<>();

  private CheckedFiles() {}

  /** Collects the files of a project, without derived files and results. */
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
      boolean results =
          folder.getName().equals(ProjectLayout.OUTPUT) && isProjectFolder(folder.getParent());
      if (!results && isProjectFolder(folder)) {
        folders.add(folder);
      }
      return !results && !folder.getName().startsWith(".");
    }
    IFile file = (IFile) resource;
    switch (kind(file)) {
      case "xmi", "eventchain" -> models.add(file);
      case "ecore" -> metamodels.add(file);
      case "ocl" -> rules.add(file);
      case "mtl" -> templates.add(file);
      default -> others.add(file);
    }
    return false;
  }

  /** Returns the ending of a file's name, which is its kind in upper and in lower case. */
  static String kind(IFile file) {
    return String.valueOf(file.getFileExtension()).toLowerCase(Locale.ROOT);
  }

  static boolean isProjectFolder(IContainer folder) {
    return folder.getType() != IResource.ROOT
        && folder.getFile(IPath.fromOSString(ProjectLayout.CONFIGURATION)).exists();
  }

  /**
   * Returns the units of these files, in the order of their names.
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

  /** Returns the metamodels, in the order in which the checks load them. */
  List<Path> ecores() {
    return paths(metamodels);
  }

  /** Returns the documents of rules, the templates and the metamodels. */
  List<Path> texts() {
    return Stream.of(rules, templates, metamodels)
        .flatMap(each -> paths(each).stream())
        .sorted()
        .toList();
  }

  /** Returns the documents outside of Eventchain projects. */
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

  /** Returns the local path of a resource; empty if it is on another machine. */
  static Optional<Path> pathOf(IResource resource) {
    return Optional.ofNullable(resource.getLocation()).map(IPath::toPath);
  }
}
