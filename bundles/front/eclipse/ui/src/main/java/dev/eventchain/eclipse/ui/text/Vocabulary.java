package dev.eventchain.eclipse.ui.text;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Names for the constraints and templates of a project: those of event chains and its own. */
final class Vocabulary {

  private final Map<String, EClassifier> types = new TreeMap<>();

  private Vocabulary(List<EPackage> packages) {
    packages.forEach(this::add);
  }

  /** Returns the vocabulary of a file; outside of projects, that of event chains. */
  static Vocabulary of(IFile file) {
    List<EPackage> packages = new ArrayList<>(List.of(EventchainPackage.eINSTANCE));
    if (file != null) {
      List<Path> found = metamodels(file.getProject());
      XmiStore store =
          EventChainMetamodel.store(found.stream().map(Path::getParent).distinct().toList());
      for (Path path : found) {
        try {
          packages.addAll(store.loadMetamodel(path));
        } catch (DiagnosticException e) {
          continue; // the builder reports the errors
        }
      }
    }
    return new Vocabulary(packages);
  }

  private static List<Path> metamodels(IProject project) {
    List<Path> found = new ArrayList<>();
    try {
      project.accept(
          proxy -> {
            if (proxy.getName().endsWith(".ecore")
                && proxy.requestResource() instanceof IFile file
                && file.getLocation() != null) {
              found.add(file.getLocation().toPath());
            }
            return !proxy.isDerived();
          },
          0);
    } catch (CoreException e) {
      return List.of(); // closed meanwhile
    }
    return found.stream().sorted().toList();
  }

  private void add(EPackage metamodel) {
    metamodel.getEClassifiers().forEach(type -> types.putIfAbsent(type.getName(), type));
    metamodel.getESubpackages().forEach(this::add);
  }

  /** Returns the names of classes, enumerations and data types. */
  Set<String> types() {
    return types.keySet();
  }

  private Optional<EClass> find(String name) {
    return Optional.ofNullable(types.get(name))
        .filter(EClass.class::isInstance)
        .map(EClass.class::cast);
  }

  /**
   * Returns the type of a navigation path.
   *
   * @param type the name of a class
   * @param path feature names in order
   * @return empty if there is no such class or feature
   */
  Optional<String> follow(String type, List<String> path) {
    Optional<String> reached = find(type).map(EClass::getName);
    for (String name : path) {
      reached =
          reached
              .flatMap(this::find)
              .map(each -> each.getEStructuralFeature(name))
              .map(feature -> feature.getEType().getName());
    }
    return reached;
  }

  /**
   * Returns the names of the features of a class, in alphabetical order; empty if it is unknown.
   */
  Set<String> features(String type) {
    Set<String> names = new TreeSet<>();
    find(type).ifPresent(each -> addFeatures(each, names));
    return names;
  }

  private static void addFeatures(EClass type, Set<String> names) {
    for (EStructuralFeature feature : type.getEAllStructuralFeatures()) {
      names.add(feature.getName());
    }
  }

  /** Returns the names of all features. */
  Set<String> features() {
    Set<String> names = new TreeSet<>();
    types.values().stream()
        .filter(EClass.class::isInstance)
        .forEach(type -> addFeatures((EClass) type, names));
    return names;
  }
}
