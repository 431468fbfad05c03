package dev.eventchain.maven;

import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.pipeline.Outcome;
import java.io.File;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.apache.maven.plugins.annotations.Parameter;

/** A goal that also works on models of any Ecore metamodel. */
abstract class ModelMojo extends ChainMojo {

  /**
   * The models: sets of files, each with {@code directory}, {@code includes} and {@code excludes}.
   * Without any, all {@code *.xmi} files in {@code src/main/models}, if there is such a folder.
   */
  @Parameter private List<ModelFiles> models;

  /** Ecore files of the models' metamodels; by default that of event chains. */
  @Parameter private List<File> metamodels = List.of();

  /**
   * Locations of files that are referenced by URI: each with {@code uri}, a full URI or a prefix
   * such as {@code platform:/resource/}, and {@code path}.
   */
  @Parameter private List<UriMapping> mappings = List.of();

  /** Folders, such as that of a repository, below which references may lead anywhere. */
  @Parameter private List<File> roots = List.of();

  /** True to continue the build if there is no model. */
  @Parameter(property = "eventchain.allowEmpty", defaultValue = "false")
  private boolean allowEmpty;

  private List<ModelFiles> sets() {
    if (models != null) {
      return models;
    }
    ModelFiles usual = new ModelFiles(new File(basedir(), "src/main/models"), "**/*.xmi");
    return usual.isThere() ? List.of(usual) : List.of();
  }

  /** Returns the models that the pom names, or those in the default folder. */
  final List<Path> models() {
    return sets().stream().flatMap(set -> set.files().stream()).distinct().toList();
  }

  /** Returns whether the pom names models or the default folder exists. */
  final boolean hasModels() {
    return !sets().isEmpty();
  }

  /**
   * Adds a finding for each set that matches nothing, which fails the goal whatever the others
   * match.
   */
  final Optional<Outcome> nothingIn() {
    List<Diagnostic> nothing = sets().stream().flatMap(set -> set.nothing().stream()).toList();
    return nothing.isEmpty() ? Optional.empty() : Optional.of(nothing(nothing));
  }

  /** Returns the outcome of a goal without any work. */
  final Outcome nothing(List<Diagnostic> found) {
    List<Diagnostic> counted =
        allowEmpty
            ? found.stream()
                .map(each -> Diagnostic.of(each.kind(), each.message(), each.location()))
                .map(each -> each.withSeverity(Severity.INFO))
                .toList()
            : found;
    return Outcome.of(Coverage.NONE, counted, List.of());
  }

  final List<Path> metamodels() {
    return Places.shown(metamodels);
  }

  final ReferenceFolders references() {
    Map<String, Path> map = new LinkedHashMap<>();
    mappings.forEach(mapping -> map.put(mapping.uri(), Places.shown(mapping.path())));
    return new ReferenceFolders(Places.shown(roots), map);
  }
}
