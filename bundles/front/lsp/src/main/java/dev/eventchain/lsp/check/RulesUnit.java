package dev.eventchain.lsp.check;

import dev.eventchain.check.FileChecks;
import dev.eventchain.diagnostics.Diagnostic;
import java.nio.file.Path;
import java.util.List;

/** A Complete OCL document outside of projects, with those that it imports. */
record RulesUnit(Path subject, List<Path> metamodels) implements CheckUnit {

  @Override
  public List<Diagnostic> check() {
    return FileChecks.rules(subject, metamodels).diagnostics();
  }
}
