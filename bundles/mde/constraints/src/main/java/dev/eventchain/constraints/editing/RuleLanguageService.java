package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.EcorePlaces;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.Workspace;
import dev.eventchain.ocl.assist.Calls;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;

/**
 * What editors can know about rule documents: Complete OCL in files named {@code *.ocl}. All
 * documents of a workspace that have the same metamodels see each other's definitions.
 */
public final class RuleLanguageService implements LanguageService {

  private static final String EXTENSION = ".ocl";

  private final Workspace workspace;
  private final EcorePlaces places;
  private final Map<Path, RuleText> texts = new HashMap<>();
  private final Map<List<EPackage>, RuleWorld> worlds = new HashMap<>();
  private final Map<Path, RuleAnalysis> analyses = new HashMap<>();

  /** The service for the documents of a workspace. */
  public RuleLanguageService(Workspace workspace) {
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
  synchronized Optional<RuleAnalysis> find(Path file) {
    Optional<RuleText> text = text(file);
    if (text.isEmpty()) {
      texts.remove(file);
      analyses.remove(file);
      return Optional.empty();
    }
    List<EPackage> metamodels = workspace.metamodels(file);
    List<RuleText> together = together(file, text.get(), metamodels);
    RuleWorld world = worlds.get(metamodels);
    if (world == null || !world.isOf(together)) {
      world = new RuleWorld(metamodels, together);
      worlds.put(metamodels, world);
    }
    RuleAnalysis known = analyses.get(file);
    if (known == null || !known.isOf(world, together)) {
      known = new RuleAnalysis(text.get(), together, world, places, this);
      analyses.put(file, known);
    }
    return Optional.of(known);
  }

  /** Returns the texts of all documents that have the same metamodels. */
  private List<RuleText> together(Path file, RuleText own, List<EPackage> metamodels) {
    List<RuleText> together = new ArrayList<>();
    for (Path each : workspace.files()) {
      if (each.equals(file)) {
        together.add(own);
      } else if (handles(each) && workspace.metamodels(each).equals(metamodels)) {
        text(each).ifPresent(together::add);
      }
    }
    if (!together.contains(own)) {
      together.add(own);
    }
    return together;
  }

  private Optional<RuleText> text(Path file) {
    Optional<SourceText> source = workspace.text(file);
    source
        .filter(each -> !texts.containsKey(file) || texts.get(file).source() != each)
        .ifPresent(each -> texts.put(file, RuleText.of(file, each)));
    return source.map(each -> texts.get(file));
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
