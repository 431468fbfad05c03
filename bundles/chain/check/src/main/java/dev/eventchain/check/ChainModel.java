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
import dev.eventchain.model.eventchain.EventchainPackage;
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
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Chain model of a file with the sources of its elements. The source is the model file if that is
 * edited, or the description if it still yields the same model. The chain is not modified.
 */
public final class ChainModel {

  private final EventChain chain;

  /** Locations of the elements in the model file. */
  private final Origins origins;

  private final EcoreChecks ecore;

  /** Elements of the description, by their paths in the model. */
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
   * Loads the metamodels, which a program with several threads does before they start. EMF's
   * packages refer to each other while they are initialised: two threads that begin at different
   * ones wait for each other for ever.
   */
  public static void loadMetamodels() {
    Objects.requireNonNull(EcorePackage.eINSTANCE);
    Objects.requireNonNull(EventchainPackage.eINSTANCE);
  }

  /**
   * Reads a model, whose elements are located in its own file.
   *
   * @param file a file of the project or its results
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

  /** Returns the event chain at the root of a model; throws INPUT for any other root. */
  public static EventChain chainOf(LoadedModel loaded, Path model) {
    if (loaded.resource().getContents().get(0) instanceof EventChain chain) {
      return chain;
    }
    throw new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
            CheckRules.PROJECT_MODEL,
            "The model's root is not an EventChain.",
            SourceLocation.of(model)));
  }

  /** Returns the chain. */
  public EventChain chain() {
    return chain;
  }

  /** Returns the results of checking the model against its metamodel. */
  public EcoreChecks ecore() {
    return ecore;
  }

  /** Returns the location of an element in its source. */
  public SourceLocation locate(EObject element) {
    EObject origin = described.get(path(element));
    return origin == null ? origins.locate(element) : descriptions.locate(origin);
  }

  /** Returns the location of a feature of an element in its source. */
  public SourceLocation locate(EObject element, EStructuralFeature feature) {
    EObject origin = described.get(path(element));
    return origin == null ? origins.locate(element, feature) : descriptions.locate(origin, feature);
  }

  /**
   * Returns this model with elements located in the description, if there is one and it yields the
   * same model; otherwise this model.
   *
   * @param description the file of the description, which may be absent
   * @param direct returns the result of {@link #ofDescription}
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
   * Returns the model of a description, made without a language model.
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
    base.addUnasked(direct.root(), direct.root());
    complete(direct.root(), settings, base);
    return direct;
  }

  /** Adds data of the project that a description does not contain. */
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
