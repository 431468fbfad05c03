package dev.eventchain.pipeline;

import dev.eventchain.analysis.AnalysisResult;
import dev.eventchain.analysis.ChainAnalysis;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.GenerationContext;
import dev.eventchain.m2t.GenerationResult;
import dev.eventchain.m2t.OutputFolder;
import dev.eventchain.m2t.OutputFolder.OnEdit;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.messages.MessageCatalog;
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
  private final List<EObject> roots = new ArrayList<>();
  private final Origins origins;

  private AnyModel(List<Path> metamodels, List<Path> models) {
    store = new XmiStore(folders(metamodels, models));
    metamodels.forEach(metamodel -> packages.addAll(store.loadMetamodel(metamodel)));
    // Models are of the metamodel that was given, also where that is the file of the shipped one.
    EPackage shipped = EventchainPackage.eINSTANCE;
    if (packages.stream().noneMatch(given -> shipped.getNsURI().equals(given.getNsURI()))) {
      packages.add(shipped);
    }
    List<LoadedModel> loaded = store.loadAll(models);
    loaded.forEach(model -> roots.addAll(model.roots()));
    origins = loaded.get(0).origins();
  }

  /**
   * A validation.
   *
   * @param coverage what was checked
   * @param diagnostics what was found, about the constraints and then about the models
   */
  public record Validation(Coverage coverage, List<Diagnostic> diagnostics) {}

  /**
   * Evaluates constraints on models, those of documents and those that the metamodels hold.
   *
   * @param metamodels the models' metamodels; none for event chains, for which the standard
   *     constraints are evaluated and the contracts inside of each chain checked, too
   * @param messages folders of {@code PACKAGE/msg/NAME.msg} that event chains use, beside the
   *     standard types of ROS 2
   * @param timeLimit the processor time that a constraint may take on all of the models
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static Validation validate(
      List<Path> metamodels,
      List<Path> constraints,
      List<Path> models,
      List<Path> messages,
      Duration timeLimit) {
    AnyModel any = new AnyModel(metamodels, models);
    List<SourceText> documents = new ArrayList<>();
    if (metamodels.isEmpty()) {
      documents.add(XmiStore.standardConstraints());
    }
    constraints.forEach(file -> documents.add(SourceText.read(file)));
    OclRules rules = OclRules.parse(documents, any.packages, any.store::locateInMetamodel);
    OclResult result =
        OclValidator.of(rules).withTimeLimit(timeLimit).validate(any.roots, any.origins::locate);
    List<String> files =
        Stream.of(models, metamodels, constraints)
            .flatMap(List::stream)
            .map(file -> SourceLocation.of(file).file())
            .distinct()
            .toList();
    Coverage coverage = Constraints.coverage(files, result);
    List<Diagnostic> found = new ArrayList<>(result.diagnostics());
    if (metamodels.isEmpty()) {
      Validation contracts = any.contracts(MessageCatalog.of(messages));
      coverage = coverage.and(contracts.coverage());
      found.addAll(contracts.diagnostics());
    }
    return new Validation(coverage, found);
  }

  /** The contracts inside of each chain: nothing is known of the vehicle around it. */
  private Validation contracts(MessageCatalog messages) {
    ChainAnalysis analysis = ChainAnalysis.of(messages, Optional.empty());
    Coverage coverage = Coverage.NONE;
    List<Diagnostic> found = new ArrayList<>();
    for (EObject root : roots) {
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
   * @param template the main module
   * @param services JARs and folders of classes whose methods the templates may call
   * @param models the template runs on the elements of each of them, and sees those that they refer
   *     to in other files
   * @param overwrite whether files that a person has edited are replaced
   * @param trace whether {@code trace.json} is written, too, which says where each line comes from
   * @return what was found, and nothing written if one of it is an error
   * @throws DiagnosticException INPUT if a file cannot be read, or the output not written
   */
  public static WrittenFiles generate(
      List<Path> metamodels,
      Path template,
      List<Path> services,
      List<Path> models,
      Path folder,
      boolean overwrite,
      boolean trace) {
    AnyModel any = new AnyModel(metamodels, models);
    try (JavaServices classes = JavaServices.of(services)) {
      TemplateModule module = TemplateModule.compile(template, any.packages, classes.loader());
      return any.generate(module, folder, overwrite, trace);
    }
  }

  private WrittenFiles generate(
      TemplateModule module, Path folder, boolean overwrite, boolean trace) {
    WrittenFiles files = new WrittenFiles(folder);
    try (OutputFolder output = OutputFolder.open(folder)) {
      GenerationContext context = GenerationContext.of(origins::locate).withEarlier(output::read);
      GenerationResult result = module.generate(roots, trace ? context.withTrace() : context);
      files.found(module.warnings());
      files.found(result.diagnostics());
      if (trace && result.files().containsKey(TraceFile.NAME)) {
        files.found(List.of(traceTaken()));
      }
      if (Diagnostic.anyError(files.diagnostics())) {
        return files;
      }
      files.write(output, result.files(), overwrite ? OnEdit.OVERWRITE : OnEdit.KEEP);
      if (trace) {
        byte[] content = TraceFile.content(result.trace(), "", List.of());
        files.write(output, Map.of(TraceFile.NAME, content), OnEdit.OVERWRITE);
      }
      return files;
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
