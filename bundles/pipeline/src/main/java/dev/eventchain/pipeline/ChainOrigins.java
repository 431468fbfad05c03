package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.metamodel.Origins;
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
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Where the elements of a chain's model come from: the model's file if people edit that; the
 * chain's description if the model was made from it and still says the same.
 */
final class ChainOrigins {

  private final RunContext.LoadedChain model;

  /** The elements that the description gives, by their paths in the model. */
  private final Map<String, EObject> described;

  private final Origins descriptions;

  private ChainOrigins(
      RunContext.LoadedChain model, Map<String, EObject> described, Origins descriptions) {
    this.model = model;
    this.described = described;
    this.descriptions = descriptions;
  }

  /** Those of a model that people edit. */
  static ChainOrigins edited(RunContext.LoadedChain model) {
    return new ChainOrigins(model, Map.of(), new Origins());
  }

  static ChainOrigins of(RunContext run, RunContext.LoadedChain model) {
    Path description = run.file(DesignStage.FILE);
    boolean derived = run.project().editedModel().isEmpty() && Files.isRegularFile(description);
    return derived ? described(run, model, description) : edited(model);
  }

  SourceLocation locate(EObject element) {
    EObject origin = described.get(path(element));
    return origin == null ? model.origins().locate(element) : descriptions.locate(origin);
  }

  /** Where a feature of an element is stated. */
  SourceLocation locate(EObject element, EStructuralFeature feature) {
    EObject origin = described.get(path(element));
    return origin == null
        ? model.origins().locate(element, feature)
        : descriptions.locate(origin, feature);
  }

  /** The model itself unless the description gives this very model. */
  private static ChainOrigins described(
      RunContext run, RunContext.LoadedChain model, Path description) {
    try {
      Modeled<EventChain> direct = direct(run, description);
      if (Diagnostic.anyError(direct.diagnostics())
          || !ModelComparison.compare(direct.root(), model.chain(), e -> SourceLocation.NONE)
              .isEmpty()) {
        return edited(model);
      }
      Map<String, EObject> described = new HashMap<>();
      described.put(path(direct.root()), direct.root());
      direct.root().eAllContents().forEachRemaining(e -> described.put(path(e), e));
      return new ChainOrigins(model, described, direct.origins());
    } catch (DiagnosticException e) {
      return edited(model);
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
    EventChainReader.addBudgets(direct.root(), direct.root(), run.softwareBase());
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
