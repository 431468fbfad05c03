package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.EcorePlaces;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.Workspace;
import dev.eventchain.m2t.syntax.ModuleLoader;
import dev.eventchain.m2t.syntax.SourceFolders;
import dev.eventchain.ocl.assist.Calls;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;

/** Language service for templates: MOFM2T in files named {@code *.mtl}. */
public final class TemplateLanguageService implements LanguageService {

  private static final String EXTENSION = ".mtl";

  private final Workspace workspace;
  private final EcorePlaces places;
  private final Map<Path, TemplateText> texts = new HashMap<>();
  private final Map<Path, TemplateWorld> worlds = new HashMap<>();
  private final Map<Path, TemplateAnalysis> analyses = new HashMap<>();

  /** The service for the templates of a workspace. */
  public TemplateLanguageService(Workspace workspace) {
    this.workspace = workspace;
    this.places = new EcorePlaces(workspace);
  }

  @Override
  public boolean handles(Path file) {
    return file.toString().endsWith(EXTENSION);
  }

  @Override
  public Optional<Analysis> analysis(Path file) {
    return find(file).map(Analysis.class::cast);
  }

  /** Returns the analysis of the present text; the same one until something changes. */
  synchronized Optional<TemplateAnalysis> find(Path file) {
    Optional<TemplateText> text = text(file);
    if (text.isEmpty()) {
      texts.remove(file);
      worlds.remove(file);
      analyses.remove(file);
      return Optional.empty();
    }
    List<EPackage> metamodels = workspace.metamodels(file);
    Map<String, Path> files = new HashMap<>();
    Map<String, ModuleLoader.Loaded> modules = load(text.get(), files);
    TemplateWorld world = worlds.get(file);
    if (world == null || !world.isOf(modules, metamodels)) {
      world = new TemplateWorld(modules, files, metamodels);
      worlds.put(file, world);
    }
    TemplateAnalysis known = analyses.get(file);
    if (known == null || !known.isOf(world, text.get())) {
      Map<String, Path> imports = new LinkedHashMap<>();
      modules
          .get(text.get().source().name())
          .names()
          .forEach((name, module) -> imports.put(name, files.get(module)));
      known = new TemplateAnalysis(text.get(), world, imports, places, this);
      analyses.put(file, known);
    }
    return Optional.of(known);
  }

  private Map<String, ModuleLoader.Loaded> load(TemplateText main, Map<String, Path> files) {
    Map<SourceText, TemplateText> read = new HashMap<>();
    read.put(main.source(), main);
    SourceFolders folders =
        new SourceFolders(
            main.file(),
            workspace.templateRoots(main.file()),
            file -> {
              Optional<TemplateText> found = text(file);
              found.ifPresent(each -> read.put(each.source(), each));
              return found.map(TemplateText::source);
            });
    Map<String, ModuleLoader.Loaded> modules =
        ModuleLoader.load(
            main.source(), folders.or(folders::findAbove), source -> read.get(source).module());
    modules.keySet().forEach(name -> folders.file(name).ifPresent(file -> files.put(name, file)));
    files.put(main.source().name(), main.file());
    return modules;
  }

  /** Returns the present text of a file. */
  synchronized Optional<TemplateText> text(Path file) {
    Optional<SourceText> source = workspace.text(file);
    source
        .filter(each -> !texts.containsKey(file) || texts.get(file).written() != each)
        .ifPresent(each -> texts.put(file, TemplateText.of(file, each)));
    return source.map(each -> texts.get(file));
  }

  /** Returns the analyses of all templates of the workspace. */
  List<TemplateAnalysis> all() {
    List<TemplateAnalysis> all = new ArrayList<>();
    for (Path file : workspace.files()) {
      if (handles(file)) {
        find(file).ifPresent(all::add);
      }
    }
    return all;
  }

  /** Returns the files of templates. */
  List<Path> files() {
    return workspace.files().stream().filter(this::handles).toList();
  }

  @Override
  public List<Call> incomingCalls(Call.Item item) {
    return find(item.place().file()).map(each -> Calls.incoming(each, item)).orElse(List.of());
  }

  @Override
  public List<Call> outgoingCalls(Call.Item item) {
    return find(item.place().file()).map(each -> Calls.outgoing(each, item)).orElse(List.of());
  }
}
