package dev.eventchain.lsp.check;

import dev.eventchain.check.FileChecks;
import dev.eventchain.diagnostics.Diagnostic;
import java.nio.file.Path;
import java.util.List;

/**
 * An Ecore metamodel with the constraints in its annotations.
 *
 * @param all the metamodels in its folder, which must not contradict it
 */
record MetamodelUnit(Path subject, List<Path> all) implements CheckUnit {

  @Override
  public List<Diagnostic> check() {
    return FileChecks.metamodel(subject, all).diagnostics();
  }
}
