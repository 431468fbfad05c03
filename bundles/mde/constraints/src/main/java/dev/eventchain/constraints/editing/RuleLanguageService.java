package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.EcorePlaces;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.Workspace;
import dev.eventchain.ocl.assist.AssistedText;
import dev.eventchain.ocl.assist.Calls;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;

/**
 * Language service for rules: Complete OCL in files named {@code *.ocl}, and the OCL in annotations
 * of {@code *.ecore}. Documents see the same definitions if they have the same metamodels and are
 * checked together, because one imports the other or the workspace says so.
 */
public final class RuleLanguageService implements LanguageService {

  private static final String METAMODEL = ".ecore";

  private final Workspace workspace;
  private final EcorePlaces places;
  private final RuleDocuments documents;
  private final Map<Path, RuleWorld> worlds = new HashMap<>();
  private final Map<Path, MetamodelText> metamodels = new HashMap<>();
  private final Map<Path, AssistedText> analyses = new HashMap<>();
  private List<Path> files = List.of();

  /** The service for the documents of a workspace. */
  public RuleLanguageService(Workspace workspace) {
    this.workspace = workspace;
    this.places = new EcorePlaces(workspace);
    this.documents = new RuleDocuments(workspace);
  }

  @Override
  public boolean handles(Path file) {
    return RuleDocuments.isDocument(file) || file.toString().endsWith(METAMODEL);
  }

  @Override
  public Optional<Analysis> analysis(Path file) {
    return find(file).map(Analysis.class::cast);
  }

  /** Returns the analysis of the present text; the same one until something changes. */
  synchronized Optional<AssistedText> find(Path file) {
    Optional<AssistedText> found =
        RuleDocuments.isDocument(file)
            ? documents.text(file).map(text -> document(text, declarations(file)))
            : workspace.text(file).map(text -> metamodel(file, text, declarations(file)));
    if (found.isEmpty()) {
      analyses.remove(file);
    }
    return found;
  }

  private AssistedText document(RuleText text, RuleDeclarations declarations) {
    if (analyses.get(text.file()) instanceof RuleAnalysis known && known.isOf(declarations)) {
      return known;
    }
    RuleAnalysis analysis = new RuleAnalysis(text, declarations, this);
    analyses.put(text.file(), analysis);
    return analysis;
  }

  private AssistedText metamodel(Path file, SourceText source, RuleDeclarations declarations) {
    MetamodelText text = metamodels.get(file);
    if (text == null || text.written() != source) {
      text = MetamodelText.of(file, source);
      metamodels.put(file, text);
    }
    if (analyses.get(file) instanceof MetamodelAnalysis known && known.isOf(text, declarations)) {
      return known;
    }
    MetamodelAnalysis analysis = new MetamodelAnalysis(text, declarations, this);
    analyses.put(file, analysis);
    return analysis;
  }

  /** Returns what the expressions of a file can name. */
  private RuleDeclarations declarations(Path file) {
    List<EPackage> present = workspace.metamodels(file);
    List<RuleText> together = together(file, present);
    return new RuleDeclarations(world(file, present, together), together, places);
  }

  /** Returns the world of a file, the same one for all that see the same definitions. */
  private RuleWorld world(Path file, List<EPackage> present, List<RuleText> together) {
    List<String> signatures = RuleWorld.signatures(together);
    RuleWorld world =
        Stream.concat(Stream.ofNullable(worlds.get(file)), worlds.values().stream())
            .filter(each -> each.isOf(present, signatures))
            .findFirst()
            .orElseGet(() -> new RuleWorld(present, together));
    forgetOthers(workspace.files());
    worlds.put(file, world);
    together.forEach(each -> worlds.put(each.file(), world));
    return world;
  }

  /** Forgets what is known of files that are gone. */
  private void forgetOthers(List<Path> present) {
    if (present != files) {
      files = present;
      Set<Path> all = new HashSet<>(present);
      worlds.keySet().retainAll(all);
      metamodels.keySet().retainAll(all);
      analyses.keySet().retainAll(all);
    }
  }

  /** Returns how many languages are kept. */
  synchronized int worlds() {
    return new HashSet<>(worlds.values()).size();
  }

  /** Returns the analyses of all files that can name features of the same metamodels. */
  synchronized List<AssistedText> family(AssistedText one) {
    List<EPackage> present = workspace.metamodels(one.file());
    List<AssistedText> family = new ArrayList<>();
    for (Path each : workspace.files()) {
      if (each.equals(one.file())) {
        family.add(one);
      } else if (handles(each) && workspace.metamodels(each).equals(present)) {
        find(each).ifPresent(family::add);
      }
    }
    if (!family.contains(one)) {
      family.add(one);
    }
    return family;
  }

  /** Returns the texts of the documents that are checked together with a file, in their order. */
  private List<RuleText> together(Path file, List<EPackage> present) {
    Set<Path> reached = new LinkedHashSet<>(Set.of(file));
    Deque<Path> next = new ArrayDeque<>(reached);
    while (!next.isEmpty()) {
      Path one = next.remove();
      Set<Path> near = new LinkedHashSet<>(workspace.checkedTogether(one));
      near.removeIf(each -> !documents.isListed(each));
      near.addAll(documents.near(one));
      near.stream()
          .filter(each -> !reached.contains(each) && workspace.metamodels(each).equals(present))
          .forEach(
              each -> {
                reached.add(each);
                next.add(each);
              });
    }
    return documents.inOrder(reached.stream().filter(RuleDocuments::isDocument).toList());
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
