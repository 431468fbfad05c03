package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import dev.eventchain.modeler.EventChainReader;
import dev.eventchain.modeler.ModelComparison;
import dev.eventchain.modeler.Modeled;
import dev.eventchain.modeler.Requirements;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Where the elements of a chain's model come from: the model's file if people edit that; the
 * chain's description if the model was made from it and still says the same.
 */
final class ChainOrigins {

  private final RunContext.LoadedChain model;
  private final Map<String, SourceLocation> descriptions;

  private ChainOrigins(RunContext.LoadedChain model, Map<String, SourceLocation> descriptions) {
    this.model = model;
    this.descriptions = descriptions;
  }

  static ChainOrigins of(RunContext run, RunContext.LoadedChain model) {
    Path description = run.file(DesignStage.FILE);
    boolean derived = run.project().editedModel().isEmpty() && Files.isRegularFile(description);
    return new ChainOrigins(model, derived ? descriptions(run, model, description) : Map.of());
  }

  SourceLocation locate(EObject element) {
    SourceLocation description = descriptions.get(path(element));
    return description == null ? model.origins().locate(element) : description;
  }

  /** Nothing unless the description gives this very model. */
  private static Map<String, SourceLocation> descriptions(
      RunContext run, RunContext.LoadedChain model, Path description) {
    try {
      Modeled<EventChain> direct = direct(run, description);
      if (Diagnostic.anyError(direct.diagnostics())
          || !ModelComparison.compare(direct.root(), model.chain(), e -> SourceLocation.NONE)
              .isEmpty()) {
        return Map.of();
      }
      Map<String, SourceLocation> places = new HashMap<>();
      places.put(path(direct.root()), direct.origins().locate(direct.root()));
      direct
          .root()
          .eAllContents()
          .forEachRemaining(e -> places.put(path(e), direct.origins().locate(e)));
      return places;
    } catch (DiagnosticException e) {
      return Map.of();
    }
  }

  /** The files that decide where elements come from, besides the model. */
  static List<Path> files(RunContext run) {
    List<Path> files = new ArrayList<>(run.project().softwareBaseFiles());
    files.add(run.project().requirements());
    files.add(run.file(DesignStage.FILE));
    return files;
  }

  /** The model that a description gives without a language model. Nobody changes it. */
  static Modeled<EventChain> direct(RunContext run, Path description) {
    return run.snapshots().of("description", files(run), () -> read(run, description));
  }

  private static Modeled<EventChain> read(RunContext run, Path description) {
    run.progress().read(description);
    Configuration configuration = run.project().configuration();
    Requirements requirements = run.requirements();
    Modeled<EventChain> direct =
        EventChainReader.read(
            SourceText.read(description),
            configuration.name(),
            requirements,
            OptionalDouble.empty());
    complete(run, direct.root());
    return direct;
  }

  /** Adds what the project knows and a description does not say. */
  static void complete(RunContext run, EventChain chain) {
    double frequency = run.project().configuration().frequency();
    for (SoftwareNode node : chain.getSoftware()) {
      if (!node.isSetFrequency()) {
        node.setFrequency(frequency);
      }
    }
    EventChainReader.markExisting(chain, run.softwareBase());
  }

  private static String path(EObject element) {
    return EcoreUtil.getRelativeURIFragmentPath(EcoreUtil.getRootContainer(element), element);
  }
}
