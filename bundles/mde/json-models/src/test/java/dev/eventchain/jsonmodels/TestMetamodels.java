package dev.eventchain.jsonmodels;

import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EPackage;

/** Metamodels as files; the bundle knows none, not even that of event chains. */
final class TestMetamodels {

  private TestMetamodels() {}

  static List<EPackage> library() {
    Path folder = Path.of("src/test/resources/cases");
    return new XmiStore(folder).loadMetamodel(folder.resolve("library.ecore"));
  }

  static EClass libraryClass(String name) {
    return (EClass) library().get(0).getEClassifier(name);
  }

  static EPackage eventChain() {
    Path folder = Path.of("../../../metamodel");
    return new XmiStore(folder).loadMetamodel(folder.resolve("eventchain.ecore")).get(0);
  }
}
