package dev.eventchain.modeler;

import dev.eventchain.metamodel.XmiStore;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EPackage;

/** A metamodel that has nothing to do with event chains. */
final class Library {

  private Library() {}

  static List<EPackage> load() {
    Path folder = Path.of("src/test/resources/cases");
    return new XmiStore(folder).loadMetamodel(folder.resolve("library.ecore"));
  }

  static EClass eClass(String name) {
    return (EClass) load().get(0).getEClassifier(name);
  }
}
