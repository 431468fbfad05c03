package dev.eventchain.emfgenerator;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.eclipse.emf.codegen.ecore.generator.Generator;
import org.eclipse.emf.codegen.ecore.generator.GeneratorAdapterFactory;
import org.eclipse.emf.codegen.ecore.genmodel.GenModel;
import org.eclipse.emf.codegen.ecore.genmodel.GenModelPackage;
import org.eclipse.emf.codegen.ecore.genmodel.generator.GenBaseGeneratorAdapter;
import org.eclipse.emf.codegen.ecore.genmodel.generator.GenModelGeneratorAdapterFactory;
import org.eclipse.emf.common.util.BasicMonitor;
import org.eclipse.emf.common.util.Diagnostic;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.plugin.EcorePlugin;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.xmi.impl.EcoreResourceFactoryImpl;

/** Generates the Java code of an EMF generator model outside Eclipse. */
public final class GenerateModelCode {

  /** The workspace project that the generator model's {@code modelDirectory} begins with. */
  private static final String PROJECT = "eventchain-model";

  private GenerateModelCode() {}

  /**
   * Generates the model code.
   *
   * @param arguments the .genmodel file, and the folder of the workspace project {@code
   *     eventchain-model}
   * @throws IOException if a file cannot be read or written
   */
  public static void main(String[] arguments) throws IOException {
    Path genmodelFile = Path.of(arguments[0]).toRealPath();
    Path project = Path.of(arguments[1]).toRealPath();
    EcorePackage.eINSTANCE.eClass();
    EcorePlugin.getPlatformResourceMap()
        .put(PROJECT, URI.createFileURI(project + java.io.File.separator));
    GenModel genmodel = load(genmodelFile);
    genmodel.reconcile();
    genmodel.setCanGenerate(true);
    genmodel.setValidateModel(true);
    requireSuccess(genmodel.diagnose());
    GeneratorAdapterFactory.Descriptor.Registry.INSTANCE.addDescriptor(
        GenModelPackage.eNS_URI, GenModelGeneratorAdapterFactory.DESCRIPTOR);
    Generator generator = new Generator();
    generator.setInput(genmodel);
    requireSuccess(
        generator.generate(
            genmodel, GenBaseGeneratorAdapter.MODEL_PROJECT_TYPE, new BasicMonitor()));
    quietLints(project.resolve("target/generated-sources/emf"));
  }

  private static GenModel load(Path file) {
    GenModelPackage.eINSTANCE.eClass();
    ResourceSet resources = new ResourceSetImpl();
    var factories = resources.getResourceFactoryRegistry().getExtensionToFactoryMap();
    factories.put("ecore", new EcoreResourceFactoryImpl());
    factories.put("genmodel", new EcoreResourceFactoryImpl());
    resources.getURIConverter().getURIMap().putAll(EcorePlugin.computePlatformURIMap(false));
    return (GenModel)
        resources.getResource(URI.createFileURI(file.toString()), true).getContents().get(0);
  }

  private static void requireSuccess(Diagnostic diagnostic) {
    if (diagnostic.getSeverity() >= Diagnostic.ERROR) {
      throw new IllegalStateException(diagnostic.toString(), diagnostic.getException());
    }
  }

  /** Suppresses lint warnings, which are errors in this module, in EMF's code. */
  private static void quietLints(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      files.filter(file -> file.toString().endsWith(".java")).forEach(GenerateModelCode::quietLint);
    }
  }

  private static void quietLint(Path file) {
    String annotation = "@SuppressWarnings({\"rawtypes\", \"unchecked\", \"serial\"})\n";
    try {
      String text = Files.readString(file);
      if (!text.contains(annotation)) { // unchanged by a second run
        Files.writeString(file, text.replaceFirst("(?m)^public ", annotation + "public "));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
