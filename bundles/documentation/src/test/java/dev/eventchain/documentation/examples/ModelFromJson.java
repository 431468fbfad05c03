package dev.eventchain.documentation.examples;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.InstanceModeler;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/** Makes a model of any Ecore metamodel from JSON, such as a language model writes. */
public final class ModelFromJson {

  private ModelFromJson() {}

  /** Writes the model as XMI if the JSON is right, and returns all findings. */
  public static List<Diagnostic> convert(Path metamodel, Path json, Path model) throws IOException {
    XmiStore store = new XmiStore(metamodel.getParent());
    InstanceModeler modeler = new InstanceModeler(store.loadMetamodel(metamodel));

    Modeled<List<EObject>> modeled = modeler.model(SourceText.read(json));
    if (modeled.diagnostics().isEmpty()) {
      Files.write(model, XmiStore.toBytes(modeled.root()));
    }
    return modeled.diagnostics();
  }
}
