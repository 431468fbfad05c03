package dev.eventchain.ocl;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.xmi.impl.EcoreResourceFactoryImpl;
import org.eclipse.emf.ecore.xmi.impl.XMIResourceFactoryImpl;

/** Reads the metamodels and models of the tests, in a resource set of their own. */
final class TestModels {

  private final Path folder;
  private final Path metamodelFolder;
  private final ResourceSet metamodels = newResourceSet();
  private final ResourceSet models = newResourceSet();

  /** The files of {@code src/test/resources/metamodels/NAME}. */
  TestModels(String name) {
    this(
        Path.of("src", "test", "resources", "metamodels", name),
        Path.of("src", "test", "resources", "metamodels", name));
  }

  /** Models in one folder, their metamodel in another. */
  TestModels(Path folder, Path metamodelFolder) {
    this.folder = folder;
    this.metamodelFolder = metamodelFolder;
  }

  private static ResourceSet newResourceSet() {
    ResourceSet resourceSet = new ResourceSetImpl();
    Map<String, Object> factories =
        resourceSet.getResourceFactoryRegistry().getExtensionToFactoryMap();
    factories.put("ecore", new EcoreResourceFactoryImpl());
    factories.put("xmi", new XMIResourceFactoryImpl());
    resourceSet.getPackageRegistry().put(EcorePackage.eNS_URI, EcorePackage.eINSTANCE);
    return resourceSet;
  }

  /** The metamodel in {@code metamodel.ecore}. */
  EPackage metamodel() {
    return metamodel(metamodelFolder.resolve("metamodel.ecore"));
  }

  EPackage metamodel(Path file) {
    EPackage metamodel = (EPackage) read(metamodels, file);
    register(metamodel);
    return metamodel;
  }

  private void register(EPackage metamodel) {
    models.getPackageRegistry().put(metamodel.getNsURI(), metamodel);
    metamodel.getESubpackages().forEach(this::register);
  }

  /** The root of a model file in the folder. */
  EObject load(String file) {
    return read(models, folder.resolve(file));
  }

  private static EObject read(ResourceSet resourceSet, Path file) {
    Resource resource =
        resourceSet.createResource(URI.createFileURI(file.toAbsolutePath().toString()));
    try {
      resource.load(Map.of());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return resource.getContents().get(0);
  }

  /** A machine with some states s0, s1 ... of which each but the last has the next and fallback. */
  static EObject machine(EPackage metamodel, int states) {
    EObject machine = EcoreUtil.create((EClass) metamodel.getEClassifier("Machine"));
    List<EObject> all = listOf(machine, "states");
    EClass type = (EClass) metamodel.getEClassifier("State");
    EObject last = null;
    for (int i = 0; i < states; i++) {
      EObject state = EcoreUtil.create(type);
      state.eSet(type.getEStructuralFeature("name"), "s" + i);
      if (last != null) {
        last.eSet(type.getEStructuralFeature("fallback"), state);
        listOf(last, "next").add(state);
      }
      all.add(state);
      last = state;
    }
    return machine;
  }

  @SuppressWarnings("unchecked") // EMF's lists know their element type at run time only
  static List<EObject> listOf(EObject object, String feature) {
    return (List<EObject>) object.eGet(object.eClass().getEStructuralFeature(feature));
  }
}
