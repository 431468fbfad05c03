package dev.eventchain.lsp.check;

import dev.eventchain.check.Metamodels;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.AnyModel;
import java.nio.file.Path;
import java.util.List;

/** A template and the modules that it imports: what {@code eventchain compile FILE} checks. */
record TemplateUnit(Path subject, List<Path> metamodels) implements CheckUnit {

  @Override
  public List<Diagnostic> check() {
    AnyModel.Template template = new AnyModel.Template(subject, List.of(), List.of(), List.of());
    return AnyModel.compile(Metamodels.sound(metamodels), ReferenceFolders.NONE, List.of(template));
  }
}
