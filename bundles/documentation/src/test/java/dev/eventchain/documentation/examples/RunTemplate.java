package dev.eventchain.documentation.examples;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;

/** Generates files from a model by a template. */
public final class RunTemplate {

  private RunTemplate() {}

  /** Writes the files unless there are errors, and returns all findings. */
  public static List<Diagnostic> generate(Path metamodel, Path template, Path model, Path folder) {
    XmiStore store = new XmiStore(metamodel.getParent());
    List<EPackage> packages = store.loadMetamodel(metamodel);
    LoadedModel loaded = store.load(model);

    TemplateModule module =
        TemplateModule.compile(SourceText.read(template), name -> Optional.empty(), packages);
    try (OutputFolder output = OutputFolder.open(folder)) {
      GenerationContext context =
          GenerationContext.of(loaded.origins()::locate).withEarlier(output::read);
      GenerationResult result = module.generate(loaded.roots(), context);
      if (result.isWhole()) {
        result.files().forEach(output::write);
      }
      return result.diagnostics();
    }
  }
}
