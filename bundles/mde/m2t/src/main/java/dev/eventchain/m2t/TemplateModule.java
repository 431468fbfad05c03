package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.compile.Linker;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.services.Services;
import dev.eventchain.m2t.syntax.ModuleLoader;
import dev.eventchain.m2t.syntax.ModuleSources;
import dev.eventchain.m2t.syntax.SourceFolders;
import dev.eventchain.m2t.syntax.SyntaxTrait;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.evaluation.DeepStack;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/**
 * A compiled template module (OMG MOFM2T 1.0 in the syntax of Acceleo 3) with its imports.
 * Immutable; several threads can generate with it at the same time.
 */
public final class TemplateModule {
  private final SourceText source;
  private final List<Template> mains;
  private final List<Diagnostic> warnings;
  private final boolean hasServices;

  private TemplateModule(
      SourceText source, List<Template> mains, List<Diagnostic> warnings, boolean hasServices) {
    this.source = source;
    this.mains = mains;
    this.warnings = warnings;
    this.hasServices = hasServices;
  }

  /**
   * Compiles a file; modules that it imports or extends are looked for next to it.
   *
   * @param packages the metamodels that modules may name by their namespaces
   * @throws DiagnosticException reason INPUT, with every problem of every module
   */
  public static TemplateModule compile(Path file, Collection<EPackage> packages) {
    return compile(file, List.of(), packages, Optional.empty());
  }

  /**
   * As {@link #compile(Path, Collection)}, with source roots and Java services.
   *
   * @param roots source roots, in which {@code a::b} is {@code a/b.mtl}; an enclosing folder of a
   *     file need not be listed if the import begins with the name of a folder in it
   * @param services the class loader of Java services. The public methods of its own classes, not
   *     of its parents', can be called by {@code invoke('class', 'method(types)', Sequence{...})};
   *     empty to disable services
   */
  public static TemplateModule compile(
      Path file, List<Path> roots, Collection<EPackage> packages, Optional<ClassLoader> services) {
    SourceFolders sources = new SourceFolders(file, roots);
    return compile(sources.main(), sources.or(sources::findAbove), packages, services);
  }

  /**
   * Compiles a file. Modules that it imports or extends, directly or indirectly, are looked up next
   * to it, then by the resolver, and finally in other folders of its project.
   *
   * @param elsewhere a resolver of modules by qualified names, called in the order of the imports
   * @param packages the metamodels that modules may name by their namespaces
   * @throws DiagnosticException reason INPUT, with every problem of every module
   */
  public static TemplateModule compile(
      Path file, Function<String, Optional<SourceText>> elsewhere, Collection<EPackage> packages) {
    SourceFolders sources = new SourceFolders(file, List.of());
    return compile(sources.main(), all(sources, elsewhere), packages, Optional.empty());
  }

  private static ModuleSources all(
      SourceFolders sources, Function<String, Optional<SourceText>> elsewhere) {
    return sources.or(ModuleSources.everywhere(elsewhere)).or(sources::findAbove);
  }

  /**
   * Returns the files of a module: its own, and those of all modules that it imports or extends.
   * Missing or invalid ones are left to the compiler to report.
   *
   * @param elsewhere as for {@link #compile(Path, Function, Collection)}; the modules that it finds
   *     are not among the files, but their imports may be
   * @throws DiagnosticException INPUT if one of them cannot be read
   */
  public static List<Path> files(Path file, Function<String, Optional<SourceText>> elsewhere) {
    if (!Files.exists(file)) {
      return List.of(file);
    }
    SourceFolders sources = new SourceFolders(file, List.of());
    ModuleLoader.load(sources.main(), all(sources, elsewhere), new ArrayList<>());
    return sources.files().stream().sorted().toList();
  }

  /**
   * Compiles a text.
   *
   * @param sources a resolver of imported or extended modules by qualified names
   * @param packages the metamodels that modules may name by their namespaces
   * @throws DiagnosticException reason INPUT, with every problem of every module
   */
  public static TemplateModule compile(
      SourceText main,
      Function<String, Optional<SourceText>> sources,
      Collection<EPackage> packages) {
    return compile(main, sources, packages, Optional.empty());
  }

  /**
   * As {@link #compile(SourceText, Function, Collection)}, with Java services.
   *
   * @param services as for {@link #compile(Path, List, Collection, Optional)}
   */
  static TemplateModule compile(
      SourceText main,
      Function<String, Optional<SourceText>> sources,
      Collection<EPackage> packages,
      Optional<ClassLoader> services) {
    return compile(main, ModuleSources.everywhere(sources), packages, services);
  }

  private static TemplateModule compile(
      SourceText main,
      ModuleSources sources,
      Collection<EPackage> packages,
      Optional<ClassLoader> services) {
    List<Diagnostic> found = new ArrayList<>();
    Map<String, ModuleLoader.Loaded> modules = ModuleLoader.load(main, sources, found);
    List<Template> templates = Linker.link(modules, packages, new Services(services));
    if (Diagnostic.anyError(found)) {
      // Lint warnings are meaningless while there are errors.
      found.removeIf(each -> each.kind().has(SyntaxTrait.LINT));
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT, found.stream().sorted().distinct().toList());
    }
    List<Template> mains = templates.stream().filter(Template::isMain).toList();
    List<Diagnostic> warnings = found.stream().sorted().distinct().toList();
    return new TemplateModule(main, mains, warnings, services.isPresent());
  }

  /** Returns the warnings of the compiler. */
  public List<Diagnostic> warnings() {
    return warnings;
  }

  /**
   * Runs the templates marked {@code @main} on each accepted element of the models: roots and their
   * contents, in the order of the model. Text outside file blocks is discarded.
   *
   * @return the files, and findings for all problems. An undefined value is an error that names its
   *     substitute. Nothing to run, or no file and nothing printed, is an error, too
   * @throws IllegalStateException if the thread is interrupted
   */
  public GenerationResult generate(Collection<? extends EObject> roots, GenerationContext context) {
    return DeepStack.call(() -> generateHere(roots, context));
  }

  /** As {@link #generate(Collection, GenerationContext)}, on the stack of this thread. */
  GenerationResult generateHere(Collection<? extends EObject> roots, GenerationContext context) {
    GenerationRun run = new GenerationRun(roots, context, hasServices);
    try {
      for (Template main : mains) {
        DiagnosticException.runAt(main.place().location(), () -> generate(main, roots, run));
      }
    } catch (GenerationRun.StoppedException e) {
      // The findings contain the reason; complete files are kept.
      return run.result();
    } catch (VirtualMachineError e) {
      if (!run.isTooDeep()) {
        throw e;
      }
      run.stopTooDeep();
      return run.result();
    }
    GenerationResult result = run.result();
    if (result.files().isEmpty()
        && result.printed().isEmpty()
        && !Diagnostic.anyError(result.diagnostics())) {
      nothingGenerated(run);
      return run.result();
    }
    return result;
  }

  /** As {@link #generate(Collection, GenerationContext)} without earlier files or properties. */
  public GenerationResult generate(
      Collection<? extends EObject> roots, Function<EObject, SourceLocation> locator) {
    return generate(roots, GenerationContext.of(locator));
  }

  private static void generate(
      Template main, Collection<? extends EObject> roots, GenerationRun run) {
    if (main.parameters().size() != 1) {
      run.report()
          .find(
              TemplateRules.MAIN_PARAMETERS,
              main.place().location(),
              "The main template '" + main.name() + "' needs exactly one parameter.",
              "Call it from a main template that has one.");
      return;
    }
    Callable.Parameter parameter = main.parameters().get(0);
    ModelWalk walk =
        new ModelWalk(
            object -> {
              if (parameter.accepts().test(object) && main.accepts(List.of(object), run)) {
                main.call(List.of(object), run);
              }
            });
    List.copyOf(roots).forEach(walk::visit);
  }

  private void nothingGenerated(GenerationRun run) {
    boolean noMain = mains.isEmpty();
    run.report()
        .find(
            noMain ? TemplateRules.MAIN_MISSING : TemplateRules.NOTHING_GENERATED,
            source.at(0),
            noMain
                ? "The module has no main template, so nothing was generated."
                : "The main template wrote no file for this model.",
            noMain
                ? "Write [comment @main /] into the template to start with."
                : "Check that the model has elements of the main template's type, and that the"
                    + " template has [file (...)] blocks.");
  }
}
