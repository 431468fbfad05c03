package dev.eventchain.check;

import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.ModelComparison;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.xmi.EcoreChecks;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.Origins;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * The model of a chain that a file holds, and where its elements come from: the model's file if
 * people edit that; the chain's description if the model was made from it and still says the same.
 * The chain is not changed.
 */
public final class ChainModel {

  private final EventChain chain;

  /** Where in the model's file each element stands. */
  private final Origins origins;

  private final EcoreChecks ecore;

  /** The elements that the description gives, by their paths in the model. */
  private final Map<String, EObject> described;

  private final Origins descriptions;

  private ChainModel(
      EventChain chain,
      Origins origins,
      EcoreChecks ecore,
      Map<String, EObject> described,
      Origins descriptions) {
    this.chain = chain;
    this.origins = origins;
    this.ecore = ecore;
    this.described = described;
    this.descriptions = descriptions;
  }

  /**
   * Reads a model; its elements come from its own file.
   *
   * @param file in the project, or among its results
   * @param output the folder of the project's results
   * @param timeLimit the processor time that the patterns of a data type may take
   * @throws DiagnosticException INPUT if it cannot be read, or is not an event chain
   */
  public static ChainModel read(ProjectFolder folder, Path output, Path file, Duration timeLimit) {
    Path root = file.startsWith(output) ? output : folder.folder();
    List<LoadedModel> all =
        XmiStore.withReferred(EventChainMetamodel.store(root).loadAll(List.of(file)));
    LoadedModel loaded = all.get(0);
    return new ChainModel(
        chainOf(loaded, file),
        loaded.origins(),
        EcoreChecks.of(all, timeLimit),
        Map.of(),
        new Origins());
  }

  /** The event chain that a model is; INPUT if it is something else. */
  public static EventChain chainOf(LoadedModel loaded, Path model) {
    if (loaded.resource().getContents().get(0) instanceof EventChain chain) {
      return chain;
    }
    throw new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error(
            "project.model", "The model's root is not an EventChain.", SourceLocation.of(model)));
  }

  /** The chain. */
  public EventChain chain() {
    return chain;
  }

  /** Whether the model is what its metamodel demands. */
  public EcoreChecks ecore() {
    return ecore;
  }

  /** Where an element is stated. */
  public SourceLocation locate(EObject element) {
    EObject origin = described.get(path(element));
    return origin == null ? origins.locate(element) : descriptions.locate(origin);
  }

  /** Where a feature of an element is stated. */
  public SourceLocation locate(EObject element, EStructuralFeature feature) {
    EObject origin = described.get(path(element));
    return origin == null ? origins.locate(element, feature) : descriptions.locate(origin, feature);
  }

  /**
   * The same model with elements that come from the description, if there is one and it gives this
   * very model; else this one.
   *
   * @param description its file, which may be absent
   * @param direct what {@link #ofDescription} makes of it
   */
  public ChainModel describedBy(Path description, Supplier<Modeled<EventChain>> direct) {
    if (!Files.isRegularFile(description)) {
      return this;
    }
    try {
      return describedBy(direct.get());
    } catch (DiagnosticException e) {
      return this;
    }
  }

  private ChainModel describedBy(Modeled<EventChain> direct) {
    if (Diagnostic.anyError(direct.diagnostics())
        || !ModelComparison.compare(direct.root(), chain, e -> SourceLocation.NONE).isEmpty()) {
      return this;
    }
    Map<String, EObject> elements = new HashMap<>();
    elements.put(path(direct.root()), direct.root());
    direct.root().eAllContents().forEachRemaining(e -> elements.put(path(e), e));
    return new ChainModel(chain, origins, ecore, elements, direct.origins());
  }

  /**
   * The model that a description gives without a language model.
   *
   * @throws DiagnosticException INPUT if it cannot be read
   */
  public static Modeled<EventChain> ofDescription(
      Path description, ProjectSettings settings, Requirements requirements, SoftwareBase base) {
    Modeled<EventChain> direct =
        EventChainReader.read(
            SourceText.read(description),
            settings.name(),
            requirements.items(),
            OptionalDouble.empty());
    base.addBudgets(direct.root(), direct.root());
    complete(direct.root(), settings, base);
    return direct;
  }

  /** Adds what the project knows and a description does not say. */
  public static void complete(EventChain chain, ProjectSettings settings, SoftwareBase base) {
    for (SoftwareNode node : chain.getSoftware()) {
      if (!node.isSetFrequency()) {
        node.setFrequency(settings.frequency());
      }
    }
    base.markExisting(chain);
  }

  private static String path(EObject element) {
    return EcoreUtil.getRelativeURIFragmentPath(EcoreUtil.getRootContainer(element), element);
  }
}
