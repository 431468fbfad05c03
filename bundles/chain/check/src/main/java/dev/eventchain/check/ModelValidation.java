package dev.eventchain.check;

import dev.eventchain.constraints.OclResult;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.contracts.AnalysisResult;
import dev.eventchain.contracts.ChainAnalysis;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.uml.Uml;
import dev.eventchain.xmi.EcoreChecks;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.Origins;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/** Validation of models of any Ecore metamodel. */
public final class ModelValidation {

  /** End of the names of UML profiles. */
  public static final String PROFILE = ".profile.uml";

  private final XmiStore store;
  private final List<EPackage> packages;
  private final List<LoadedModel> models;

  /** The named models, and those that they refer to. */
  private final List<LoadedModel> all;

  /** True if one of them is a model of UML, which is known without being named. */
  private final boolean usesUml;

  private final Origins origins;
  private final EcoreChecks ecore;

  private ModelValidation(ModelFiles files, Duration timeLimit) {
    store = storeOf(files.metamodels(), files.files(), files.references());
    packages = load(store, files.metamodels());
    models = store.loadAll(files.files());
    all = XmiStore.withReferred(models);
    usesUml = roots(all).stream().anyMatch(root -> Uml.isMetamodel(root.eClass().getEPackage()));
    if (usesUml) {
      addPackagesOf(roots(all));
    }
    origins = all.get(0).origins();
    ecore = EcoreChecks.of(all, timeLimit);
  }

  /** Adds UML, and the profiles whose stereotypes the models apply. */
  private void addPackagesOf(List<EObject> roots) {
    roots.stream()
        .map(root -> root.eClass().getEPackage())
        .distinct()
        .filter(used -> !packages.contains(used))
        .forEach(packages::add);
  }

  /** Loads metamodels in any order: one may refer to a later one by its namespace. */
  private static List<EPackage> load(XmiStore store, List<Path> metamodels) {
    List<EPackage> packages = new ArrayList<>();
    List<Path> open = metamodels;
    while (!open.isEmpty()) {
      List<Path> failed = new ArrayList<>();
      Optional<DiagnosticException> first = Optional.empty();
      for (Path metamodel : open) {
        try {
          SourceLocation place = SourceLocation.of(metamodel);
          packages.addAll(DiagnosticException.at(place, () -> store.loadMetamodel(metamodel)));
        } catch (DiagnosticException e) {
          failed.add(metamodel);
          first = first.or(() -> Optional.of(e));
        }
      }
      if (failed.size() == open.size()) {
        throw first.orElseThrow();
      }
      open = failed;
    }
    // The given metamodel applies, even if it is the file of the shipped one.
    EPackage shipped = EventchainPackage.eINSTANCE;
    if (packages.stream().noneMatch(given -> shipped.getNsURI().equals(given.getNsURI()))) {
      packages.add(shipped);
    }
    return packages;
  }

  /**
   * Reads metamodels, for something that needs no model.
   *
   * @param metamodels the files; of {@code *.profile.uml}, the stereotypes are meant
   * @param references as of {@link ModelFiles}
   * @return their packages, and the one of event chains
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static List<EPackage> metamodels(List<Path> metamodels, ReferenceFolders references) {
    List<Path> profiles = metamodels.stream().filter(ModelValidation::isProfile).toList();
    List<Path> others = metamodels.stream().filter(file -> !isProfile(file)).toList();
    List<EPackage> packages = load(storeOf(metamodels, List.of(), references), others);
    profiles.forEach(profile -> packages.addAll(profiles(profile, references)));
    return packages;
  }

  private static boolean isProfile(Path file) {
    return file.toString().endsWith(PROFILE);
  }

  /**
   * Reads a file of UML profiles, for something that needs no model.
   *
   * @param references as of {@link ModelFiles}
   * @return the packages that define their stereotypes
   * @throws DiagnosticException INPUT if the file cannot be read
   */
  public static List<EPackage> profiles(Path file, ReferenceFolders references) {
    return storeOf(List.of(file), List.of(), references).loadProfiles(file);
  }

  /**
   * Reads models and checks them against their metamodel.
   *
   * @param timeLimit the processor time that the patterns of a data type may take
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static ModelValidation read(ModelFiles files, Duration timeLimit) {
    return new ModelValidation(files, timeLimit);
  }

  /** Returns the metamodels, including the shipped one. */
  public List<EPackage> packages() {
    return List.copyOf(packages);
  }

  /** Returns the roots of the named models. */
  public List<EObject> roots() {
    return roots(models);
  }

  /** Returns the location of an element. */
  public SourceLocation locate(EObject element) {
    return origins.locate(element);
  }

  /**
   * Returns the results of checking the models, and those that they refer to, against their
   * metamodels.
   */
  public EcoreChecks ecore() {
    return ecore;
  }

  /**
   * Checks models, and those that they refer to, against their metamodel and evaluates constraints
   * on them. The constraints are those of documents and of the metamodels; without any, only the
   * metamodels are checked. Event chains are checked against the standard constraints and the
   * contracts inside each chain, too.
   *
   * @param constraints documents, and folders of them
   * @param messages folders of {@code PACKAGE/msg/NAME.msg} that event chains use, next to the
   *     standard types of ROS 2 and to those of the projects in which the models are, which also
   *     say whose standard types these are
   * @param timeLimit the processor time that a constraint, or the patterns of a data type, may take
   *     on all of the models
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static Validation validate(
      ModelFiles files, List<Path> constraints, List<Path> messages, Duration timeLimit) {
    ModelValidation any = read(files, timeLimit);
    List<SourceText> documents = new ArrayList<>();
    boolean chains = roots(any.all).stream().anyMatch(EventChain.class::isInstance);
    boolean aboutChains = files.metamodels().isEmpty() && (chains || !any.usesUml);
    if (aboutChains) {
      documents.add(EventChainMetamodel.constraints());
    }
    List<Path> rulesIn = OclRules.files(constraints);
    rulesIn.forEach(file -> documents.add(SourceText.read(file)));
    OclRules rules = OclRules.parse(documents, any.packages, any.store::locateInMetamodel);
    OclResult result =
        OclValidator.of(rules)
            .withTimeLimit(timeLimit)
            .validate(roots(any.all), any.origins::locate);
    Coverage coverage =
        Constraints.coverage(any.read(files, rulesIn), result).and(any.ecore.coverage());
    boolean onlyMetamodel = documents.isEmpty() && rules.constraints().isEmpty();
    boolean isMetamodelChecked = coverage.evaluations(Coverage.Kind.METAMODEL) > 0;
    List<Diagnostic> found =
        any.aboutConstraints(rules, result, onlyMetamodel && isMetamodelChecked);
    found.addAll(any.ecore.diagnostics());
    if (aboutChains) {
      Validation contracts = any.contracts(messages);
      coverage = coverage.and(contracts.coverage());
      found.addAll(contracts.diagnostics());
    }
    return new Validation(coverage, found);
  }

  /**
   * Returns the findings of the evaluation of constraints.
   *
   * @param mayBeNone true if constraints are optional
   */
  private List<Diagnostic> aboutConstraints(OclRules rules, OclResult result, boolean mayBeNone) {
    List<Diagnostic> found = new ArrayList<>(result.diagnostics());
    if (mayBeNone) {
      found.removeIf(finding -> finding.is(ConstraintRules.NOTHING_EVALUATED));
    }
    found.addAll(Constraints.constant(rules, List.of()));
    if (result.evaluations() > 0) {
      found.addAll(unconstrained(rules));
    }
    return found;
  }

  /**
   * Returns warnings for models without applicable constraints, even if there are findings about
   * others.
   */
  private List<Diagnostic> unconstrained(OclRules rules) {
    return models.stream()
        .filter(model -> !model.roots().isEmpty())
        .filter(model -> model.roots().stream().noneMatch(rules::areAbout))
        .map(model -> SourceLocation.of(origins.locate(model.roots().get(0)).file()))
        .map(
            file ->
                Diagnostic.of(
                        CheckRules.OCL_MODEL_UNCONSTRAINED,
                        "No constraint applies to any element of this model: only its metamodel was checked.",
                        file)
                    .withHint("Name a document with constraints on its classes (--ocl)."))
        .toList();
  }

  private static List<EObject> roots(List<LoadedModel> models) {
    return models.stream().flatMap(model -> model.roots().stream()).toList();
  }

  /** Returns the files that were read. */
  private List<String> read(ModelFiles files, List<Path> constraints) {
    Stream<String> referred =
        all.stream().skip(models.size()).map(m -> origins.locate(m.roots().get(0)).file());
    Stream<String> given =
        Stream.of(files.files(), files.metamodels(), constraints)
            .flatMap(List::stream)
            .map(file -> SourceLocation.of(file).file());
    return Stream.concat(given, referred).distinct().toList();
  }

  /**
   * Checks the contracts inside each chain; the vehicle is unknown. A chain in a project uses the
   * messages of its project, whoever checks it.
   */
  private Validation contracts(List<Path> messages) {
    Map<Messages, ChainAnalysis> analyses = new HashMap<>();
    Coverage coverage = Coverage.NONE;
    List<Diagnostic> found = new ArrayList<>();
    for (EObject root : roots(all)) {
      if (root instanceof EventChain chain) {
        ChainAnalysis analysis =
            analyses.computeIfAbsent(
                messagesOf(chain, messages),
                used -> ChainAnalysis.of(used.catalog(), Optional.empty()));
        AnalysisResult result = analysis.check(chain, origins::locate);
        coverage = coverage.and(new Coverage(List.of(), 0, result.checks()));
        found.addAll(result.diagnostics());
      }
    }
    return new Validation(coverage, found);
  }

  /**
   * The messages that a chain uses: the standard ones of a release of ROS 2, and those of folders.
   */
  private record Messages(RosDistribution distribution, List<Path> folders) {

    MessageCatalog catalog() {
      return MessageCatalog.of(distribution, folders);
    }
  }

  private Messages messagesOf(EventChain chain, List<Path> given) {
    Optional<ProjectFolder> project = ProjectFolder.around(Path.of(origins.locate(chain).file()));
    List<Path> folders = new ArrayList<>();
    project.map(ProjectFolder::messageFolders).ifPresent(folders::addAll);
    folders.addAll(given);
    return new Messages(
        project.map(ProjectFolder::distribution).orElse(RosDistribution.DEFAULT), folders);
  }

  /** Returns a store in which references may lead to files below the folders of the named ones. */
  private static XmiStore storeOf(
      List<Path> metamodels, List<Path> models, ReferenceFolders references) {
    List<Path> files = Stream.concat(models.stream(), metamodels.stream()).toList();
    return EventChainMetamodel.store(references.after(files), references.map());
  }
}
