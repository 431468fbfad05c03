package dev.eventchain.documentation.examples;

import dev.eventchain.constraints.OclResult;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EPackage;

/** Evaluates Complete OCL constraints on a model of any Ecore metamodel. */
public final class ValidateModel {

  private ValidateModel() {}

  /** Returns all findings; "nothing was evaluated" is one of them. */
  public static List<Diagnostic> validate(Path metamodel, Path constraints, Path model) {
    XmiStore store = new XmiStore(metamodel.getParent());
    List<EPackage> packages = store.loadMetamodel(metamodel);
    LoadedModel loaded = store.load(model);

    OclRules rules = OclRules.parse(List.of(SourceText.read(constraints)), packages);
    OclResult result = OclValidator.validate(rules, loaded.roots(), loaded.origins()::locate);
    return result.diagnostics();
  }
}
