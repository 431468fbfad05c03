package dev.eventchain.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.catalogue.SignalCatalogue;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The catalogue of signals that {@code eventchain.yaml} names under {@code catalogue}: a file, or a
 * mapping with {@code file}, {@code overlays}, {@code node}, {@code shortlist}, {@code pinned} and
 * {@code excluded}.
 *
 * @param source its files
 * @param shortlist how many signals a design is offered
 * @param pinned paths of signals, or of groups of them, that are always offered
 * @param excluded paths of signals, or of groups of them, that are never offered
 * @param place the location of the setting
 */
public record CatalogueSettings(
    CatalogueSource source,
    int shortlist,
    List<String> pinned,
    List<String> excluded,
    SourceLocation place) {

  /** Default number of signals that a design is offered. */
  public static final int DEFAULT_SHORTLIST = 16;

  private static final NumberRange SHORTLIST = NumberRange.of(1, 200);
  private static final String SETTING = "catalogue";
  private static final String FILE = "file";
  private static final String OVERLAYS = "overlays";
  private static final String NODE = "node";

  /** Copies the lists. */
  public CatalogueSettings {
    pinned = List.copyOf(pinned);
    excluded = List.copyOf(excluded);
  }

  /**
   * Reads the setting; the reader reports invalid values.
   *
   * @param folder the folder of the project, from which names are relative
   */
  public static Optional<CatalogueSettings> read(ObjectReader settings, Path folder) {
    if (settings.value(SETTING).filter(JsonNode::isObject).isPresent()) {
      return settings.object(SETTING).flatMap(catalogue -> mapping(catalogue, folder));
    }
    return settings.has(SETTING)
        ? path(settings.requiredText(SETTING), settings, SETTING, folder)
            .map(
                file ->
                    new CatalogueSettings(
                        new CatalogueSource(file, List.of(), Optional.empty()),
                        DEFAULT_SHORTLIST,
                        List.of(),
                        List.of(),
                        settings.at(SETTING)))
        : Optional.empty();
  }

  private static Optional<CatalogueSettings> mapping(ObjectReader catalogue, Path folder) {
    Optional<Path> file = path(catalogue.requiredText(FILE), catalogue, FILE, folder);
    List<Path> overlays = new ArrayList<>();
    catalogue
        .texts(OVERLAYS)
        .forEach(name -> path(name, catalogue, OVERLAYS, folder).ifPresent(overlays::add));
    int shortlist = (int) catalogue.wholeNumber("shortlist", SHORTLIST).orElse(DEFAULT_SHORTLIST);
    List<String> pinned = catalogue.texts("pinned");
    List<String> excluded = catalogue.texts("excluded");
    Optional<String> node =
        catalogue.has(NODE)
            ? Optional.of(catalogue.requiredText(NODE)).filter(it -> !it.isBlank())
            : Optional.empty();
    catalogue.refuseOthers();
    return file.map(
        it ->
            new CatalogueSettings(
                new CatalogueSource(it, overlays, node),
                shortlist,
                pinned,
                excluded,
                catalogue.location()));
  }

  /** Returns how many and which signals are offered, for fingerprints. */
  public String choice() {
    return shortlist + " " + pinned + " " + excluded + source.node().map(it -> " " + it).orElse("");
  }

  /** Returns a finding for each chosen path that no signal of the catalogue has. */
  List<Diagnostic> check(SignalCatalogue catalogue) {
    List<Diagnostic> found = new ArrayList<>();
    Set<String> chosen = new LinkedHashSet<>(pinned);
    chosen.addAll(excluded);
    for (String path : catalogue.signals().isEmpty() ? Set.<String>of() : chosen) {
      if (catalogue.signals().stream().noneMatch(it -> SignalCatalogue.isIn(it, path))) {
        String message = "The catalogue has no signal and no group '" + path + "'.";
        List<String> paths = catalogue.signals().stream().map(CatalogueSignal::path).toList();
        found.add(
            Diagnostic.of(ProjectRules.PROJECT_CATALOGUE, message, place)
                .withHint(
                    NearestName.of(path, paths)
                        .map(near -> "Did you mean `" + near + "`?")
                        .orElse("Write a path as the catalogue has it, such as Vehicle.Speed.")));
      }
    }
    return found;
  }

  private static Optional<Path> path(String file, ObjectReader settings, String key, Path folder) {
    try {
      Path path = folder.resolve(file).normalize();
      if (!file.isBlank() && path.getFileName() != null) {
        return Optional.of(path);
      }
    } catch (InvalidPathException e) {
      // reported below
    }
    if (!file.isBlank()) {
      settings.find(
          Diagnostic.of(
              ProjectSettings.RULES.range(),
              "'" + file + "' cannot be a file of signals.",
              settings.at(key)));
    }
    return Optional.empty();
  }
}
