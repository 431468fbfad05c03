package dev.eventchain.pipeline;

import dev.eventchain.analysis.AnalysisResult;
import dev.eventchain.analysis.ChainAnalysis;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.m2t.GenerationContext;
import dev.eventchain.m2t.GenerationResult;
import dev.eventchain.m2t.OutputFolder;
import dev.eventchain.m2t.OutputFolder.OnEdit;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.metamodel.EcoreChecks;
import dev.eventchain.metamodel.LoadedModel;
import dev.eventchain.metamodel.Origins;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.ocl.OclResult;
import dev.eventchain.ocl.OclRules;
import dev.eventchain.ocl.OclValidator;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/** Validation and generation for models of any Ecore metamodel, without a project. */
public final class AnyModel {

  private final XmiStore store;
  private final List<EPackage> packages = new ArrayList<>();
  private final List<LoadedModel> models;

  /** The models, and those that nobody named and they refer to. */
  private final List<LoadedModel> all;

  private final Origins origins;
  private final EcoreChecks ecore;

  private AnyModel(
      List<Path> metamodels, Map<String, Path> map, List<Path> models, Duration timeLimit) {
    store = new XmiStore(folders(metamodels, models), map);
    for (Path metamodel : metamodels) {
      SourceLocation place = SourceLocation.of(metamodel);
      packages.addAll(DiagnosticException.at(place, () -> store.loadMetamodel(metamodel)));
    }
    // Models are of the metamodel that was given, also where that is the file of the shipped one.
    EPackage shipped = EventchainPackage.eINSTANCE;
    if (packages.stream().noneMatch(given -> shipped.getNsURI().equals(given.getNsURI()))) {
      packages.add(shipped);
    }
    this.models = store.loadAll(models);
    all = XmiStore.withReferred(this.models);
    origins = all.get(0).origins();
    ecore = EcoreChecks.of(all, timeLimit);
  }

  /**
   * A validation.
   *
   * @param coverage what was checked
   * @param diagnostics what was found, about the constraints and then about the models
   */
  public record Validation(Coverage coverage, List<Diagnostic> diagnostics) {}

  /**
   * Checks models against their metamodel and evaluates constraints on them, and on those in files
   * that they refer to. The constraints are those of documents and those that the metamodels hold;
   * without any, what the metamodels demand has to do.
   *
   * @param metamodels the models' metamodels; none for event chains, for which the standard
   *     constraints are evaluated and the contracts inside of each chain checked, too
   * @param map the folders that beginnings of references stand for: {@code platform:/resource/}
   * @param messages folders of {@code PACKAGE/msg/NAME.msg} that event chains use, beside the
   *     standard types of ROS 2
   * @param timeLimit the processor time that a constraint, or the patterns of a data type, may take
   *     on all of the models
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static Validation validate(
      List<Path> metamodels,
      Map<String, Path> map,
      List<Path> constraints,
      List<Path> models,
      List<Path> messages,
      Duration timeLimit) {
    AnyModel any = new AnyModel(metamodels, map, models, timeLimit);
    List<SourceText> documents = new ArrayList<>();
    if (metamodels.isEmpty()) {
      documents.add(XmiStore.standardConstraints());
    }
    List<Path> rulesIn = OclRules.files(constraints);
    rulesIn.forEach(file -> documents.add(SourceText.read(file)));
    OclRules rules = OclRules.parse(documents, any.packages, any.store::locateInMetamodel);
    OclResult result =
        OclValidator.of(rules)
            .withTimeLimit(timeLimit)
            .validate(roots(any.all), any.origins::locate);
    Coverage coverage =
        Constraints.coverage(any.files(metamodels, rulesIn, models), result)
            .and(any.ecore.coverage());
    List<Diagnostic> found = new ArrayList<>(result.diagnostics());
    boolean onlyMetamodel = documents.isEmpty() && rules.constraints().isEmpty();
    if (onlyMetamodel && coverage.evaluations(Coverage.Kind.METAMODEL) > 0) {
      found.removeIf(finding -> finding.id().equals("ocl.nothing-evaluated"));
    }
    found.addAll(any.ecore.diagnostics());
    if (metamodels.isEmpty()) {
      Validation contracts = any.contracts(MessageCatalog.of(messages));
      coverage = coverage.and(contracts.coverage());
      found.addAll(contracts.diagnostics());
    }
    return new Validation(coverage, found);
  }

  private static List<EObject> roots(List<LoadedModel> models) {
    return models.stream().flatMap(model -> model.roots().stream()).toList();
  }

  /** The files that were read. */
  private List<String> files(List<Path> metamodels, List<Path> constraints, List<Path> named) {
    Stream<String> referred =
        all.stream().skip(models.size()).map(m -> origins.locate(m.roots().get(0)).file());
    Stream<String> given =
        Stream.of(named, metamodels, constraints)
            .flatMap(List::stream)
            .map(file -> SourceLocation.of(file).file());
    return Stream.concat(given, referred).distinct().toList();
  }

  /** The contracts inside of each chain: nothing is known of the vehicle around it. */
  private Validation contracts(MessageCatalog messages) {
    ChainAnalysis analysis = ChainAnalysis.of(messages, Optional.empty());
    Coverage coverage = Coverage.NONE;
    List<Diagnostic> found = new ArrayList<>();
    for (EObject root : roots(all)) {
      if (root instanceof EventChain chain) {
        AnalysisResult result = analysis.check(chain, origins::locate);
        coverage = coverage.and(new Coverage(List.of(), 0, result.checks()));
        found.addAll(result.diagnostics());
      }
    }
    return new Validation(coverage, found);
  }

  /**
   * Generates text from models.
   *
   * @param map the folders that beginnings of references stand for: {@code platform:/resource/}
   * @param template the main module
   * @param services JARs and folders of classes whose methods the templates may call
   * @param models the template runs on the elements of each of them, and sees those that they refer
   *     to in other files
   * @param overwrite whether files that a person has edited are replaced
   * @param trace whether {@code trace.json} is written, too, which says where each line comes from
   * @param suppressions what is wrong with the models and is not to count
   * @param timeLimit the processor time that the patterns of a data type may take
   * @return what was found, and nothing written if one of it is an error: also where a model is no
   *     instance of its metamodel
   * @throws DiagnosticException INPUT if a file cannot be read, or the output not written
   */
  public static WrittenFiles generate(
      List<Path> metamodels,
      Map<String, Path> map,
      Path template,
      List<Path> services,
      List<Path> models,
      Path folder,
      boolean overwrite,
      boolean trace,
      Suppressions suppressions,
      Duration timeLimit) {
    AnyModel any = new AnyModel(metamodels, map, models, timeLimit);
    try (JavaServices classes = JavaServices.of(services)) {
      TemplateModule module =
          TemplateModule.compile(template, any.templatePackages(), classes.loader());
      WrittenFiles files = new WrittenFiles(folder);
      files.found(any.ecore.diagnostics());
      if (!Diagnostic.anyError(suppressions.part(files.diagnostics()).remaining())) {
        any.generate(module, files, folder, overwrite, trace);
      }
      return files;
    }
  }

  /**
   * Templates may be written for definitions of messages, too: without a project there are none.
   */
  private List<EPackage> templatePackages() {
    List<EPackage> all = new ArrayList<>(packages);
    EPackage messages = MessageModel.metamodel();
    if (packages.stream().noneMatch(given -> messages.getNsURI().equals(given.getNsURI()))) {
      all.add(messages);
    }
    return all;
  }

  private void generate(
      TemplateModule module, WrittenFiles files, Path folder, boolean overwrite, boolean trace) {
    try (OutputFolder output = OutputFolder.open(folder)) {
      GenerationContext context = GenerationContext.of(origins::locate).withEarlier(output::read);
      GenerationResult result =
          module.generate(roots(models), trace ? context.withTrace() : context);
      int known = files.diagnostics().size(); // what is wrong with the model, and was suppressed
      files.found(module.warnings());
      files.found(result.diagnostics());
      if (trace && result.files().containsKey(TraceFile.NAME)) {
        files.found(List.of(traceTaken()));
      }
      if (Diagnostic.anyError(files.diagnostics().subList(known, files.diagnostics().size()))) {
        return;
      }
      files.write(output, result.files(), overwrite ? OnEdit.OVERWRITE : OnEdit.KEEP);
      if (trace) {
        byte[] content = TraceFile.content(result.trace(), "", List.of());
        files.write(output, Map.of(TraceFile.NAME, content), OnEdit.OVERWRITE);
      }
    }
  }

  private static Diagnostic traceTaken() {
    return Diagnostic.error(
            "m2t.file.duplicate",
            "A template writes the file '" + TraceFile.NAME + "', which the trace goes into.",
            SourceLocation.of(TraceFile.NAME))
        .withHint("Give the file another name, or leave out --trace.");
  }

  /** References may go between the files that the command names, and what lies below them. */
  private static List<Path> folders(List<Path> metamodels, List<Path> models) {
    return Stream.concat(models.stream(), metamodels.stream())
        .map(file -> file.resolveSibling(""))
        .distinct()
        .toList();
  }
}
