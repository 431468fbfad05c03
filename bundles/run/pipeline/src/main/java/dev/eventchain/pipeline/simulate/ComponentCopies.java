package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.output.OutputRules;
import dev.eventchain.pipeline.generate.GeneratedPackage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Copies of components in a generated package, which the simulation runs. */
final class ComponentCopies {

  private ComponentCopies() {}

  /** Returns the path of a component's copy. */
  static Path of(RunContext run, GeneratedPackage generated, SoftwareNode node) {
    return run.file(generated.componentFile(node));
  }

  /**
   * Checks that the copies equal the components: an edited copy is kept, but a verdict about it
   * would not apply to the project's component.
   *
   * @throws DiagnosticException FINDINGS with an error for each, unless suppressed
   */
  static List<Diagnostic> requireSame(
      RunContext run, EventChain chain, GeneratedPackage generated) {
    List<Diagnostic> found = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      if (generated.manifest().find(node.getName()).isPresent()) {
        Path copy = of(run, generated, node);
        Path source = ComponentFiles.of(run, node);
        if (!SourceText.read(copy).text().equals(SourceText.read(source).text())) {
          found.add(edited(node, copy, source));
        }
      }
    }
    if (Diagnostic.anyError(run.options().suppressions().part(found).remaining())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
    }
    return found;
  }

  private static Diagnostic edited(SoftwareNode node, Path copy, Path source) {
    return Diagnostic.of(
            OutputRules.EVENTCHAIN_FILE_EDITED,
            "This copy of the component '%s' differs from %s, so a verdict would be about different code."
                .formatted(node.getName(), SourceLocation.of(source).file()),
            SourceLocation.of(copy))
        .withSeverity(Severity.ERROR)
        .withHint(
            "Move the change to the component itself, and delete the copy or use --overwrite.");
  }
}
