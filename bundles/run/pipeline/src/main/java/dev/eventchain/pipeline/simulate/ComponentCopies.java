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
import dev.eventchain.pipeline.generate.HostedNodes;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.ComponentSources;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.node.NodeManifest;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/** Copies of components, and of the modules that they import, in a generated package. */
final class ComponentCopies {

  private ComponentCopies() {}

  /** Returns the files of the project by the paths of their copies, which the simulation runs. */
  static SortedMap<Path, Path> of(RunContext run, EventChain chain, GeneratedPackage generated) {
    SortedMap<Path, Path> sources = new TreeMap<>();
    SortedMap<String, Path> helpers = ComponentSources.helpers(run, chain).files();
    for (SoftwareNode node : chain.getSoftware()) {
      if (generated
          .manifest()
          .find(node.getName())
          .flatMap(NodeManifest.Node::component)
          .isPresent()) {
        String copy = generated.componentFile(node);
        helpers.forEach(
            (name, file) -> sources.put(run.file(GeneratedPackage.besides(copy, name)), file));
        sources.put(run.file(copy), ComponentFiles.of(run, node));
      }
    }
    HostedNodes.copies(run)
        .forEach((name, file) -> sources.put(run.file(generated.folder() + "/" + name), file));
    return sources;
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
    of(run, chain, generated)
        .forEach(
            (copy, source) -> {
              if (!SourceText.read(copy).text().equals(SourceText.read(source).text())) {
                found.add(edited(copy, source));
              }
            });
    if (Diagnostic.anyError(run.options().suppressions().part(found).remaining())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
    }
    return found;
  }

  private static Diagnostic edited(Path copy, Path source) {
    return Diagnostic.of(
            OutputRules.EVENTCHAIN_FILE_EDITED,
            "This copy differs from %s, so a verdict would be about different code."
                .formatted(SourceLocation.of(source).file()),
            SourceLocation.of(copy))
        .withSeverity(Severity.ERROR)
        .withHint("Move the change to the file itself, and delete the copy or use --overwrite.");
  }
}
