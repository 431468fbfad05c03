package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.Version;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The catalogs in the folders that a scenario names. Each folder is read once. */
final class Catalogs {

  /** A catalog, or the reason why a file with the name of one could not be read. */
  private record Catalog(
      String name, Map<String, List<Entry>> entries, Optional<DiagnosticException> failure) {

    static Catalog of(String fileName, XmlElement written, Version version) {
      Map<String, List<Entry>> entries = new LinkedHashMap<>();
      for (XmlElement each : written.children()) {
        entries
            .computeIfAbsent(each.attribute("name").orElse(""), name -> new ArrayList<>())
            .add(new Entry(each, version));
      }
      return new Catalog(written.attribute("name").orElse(fileName), entries, Optional.empty());
    }
  }

  /** A folder as it is written, and where. */
  record Location(String path, SourceLocation place) {}

  /** Target of a reference. */
  record Entry(XmlElement element, Version version) {}

  private final Folder folder;
  private final Map<Path, List<Catalog>> read = new ConcurrentHashMap<>();

  Catalogs(Folder folder) {
    this.folder = folder;
  }

  /** A reference to an entry: two names, and the place that says so. */
  record Reference(String catalog, String entry, SourceLocation place) {}

  /**
   * Returns the entry that a reference leads to; empty, with a finding, if there is none.
   *
   * @param folders the folders to look in
   */
  Optional<Entry> find(Reference reference, List<Location> folders, Findings findings) {
    // Several kinds of catalogs may be in one folder.
    Set<List<Catalog>> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<Catalog> there = new ArrayList<>();
    boolean complete = true;
    for (Location location : folders) {
      Optional<List<Catalog>> all = in(location, findings);
      complete &= all.isPresent();
      all.filter(seen::add).ifPresent(there::addAll);
    }
    List<Catalog> named =
        there.stream().filter(each -> each.name().equals(reference.catalog())).toList();
    for (Catalog each : named.isEmpty() ? there : named) {
      each.failure().ifPresent(failure -> findings.addAll(failure.diagnostics()));
    }
    if (!named.isEmpty()) {
      return entry(reference, named, findings);
    } else if (complete) {
      findings.add(
          DocumentRules.CATALOG_MISSING,
          "No catalog `" + reference.catalog() + "` is in " + listed(folders) + ".",
          reference.place(),
          NearestName.hint(
              reference.catalog(),
              there.stream().filter(each -> each.failure().isEmpty()).map(Catalog::name).toList()));
    }
    return Optional.empty();
  }

  private static Optional<Entry> entry(
      Reference reference, List<Catalog> catalogs, Findings findings) {
    List<Entry> found = new ArrayList<>();
    for (Catalog catalog : catalogs) {
      found.addAll(catalog.entries().getOrDefault(reference.entry(), List.of()));
    }
    boolean unreadable = catalogs.stream().anyMatch(each -> each.failure().isPresent());
    if (found.isEmpty() && !unreadable && !findings.isFull()) {
      Set<String> names = new TreeSet<>();
      catalogs.forEach(each -> names.addAll(each.entries().keySet()));
      findings.add(
          DocumentRules.CATALOG_ENTRY,
          "The catalog `" + reference.catalog() + "` has no `" + reference.entry() + "`.",
          reference.place(),
          NearestName.hint(reference.entry(), names));
    }
    for (Entry again : found.subList(Math.min(1, found.size()), found.size())) {
      findings.add(
          DocumentRules.CATALOG_DUPLICATE,
          "The catalog `" + reference.catalog() + "` has `" + reference.entry() + "` twice.",
          again.element().location(),
          "The other one is at " + found.get(0).element().location() + ": rename one of them.");
    }
    return found.stream().findFirst();
  }

  /** Returns the catalogs of a folder; empty, with a finding, if it cannot be read. */
  private Optional<List<Catalog>> in(Location location, Findings findings) {
    try {
      Path found = folder.find(location.path(), location.place());
      if (Files.isRegularFile(found)) {
        folder.file(location.path(), location.place());
      }
      if (Files.exists(found)) {
        return Optional.of(read.computeIfAbsent(found, each -> read(each, location.place())));
      }
      findings.add(
          DocumentRules.CATALOG_MISSING,
          "There is no folder `" + location.path() + "`.",
          location.place(),
          "The path is relative to the folder of the scenario.");
    } catch (DiagnosticException e) {
      findings.addAll(e.diagnostics());
    }
    return Optional.empty();
  }

  private List<Catalog> read(Path found, SourceLocation place) {
    List<Catalog> catalogs = new ArrayList<>();
    for (Path file : filesOf(found, place)) {
      String name = file.getFileName().toString().replaceFirst("\\.xosc$", "");
      try {
        ScenarioFile each = ScenarioFile.load(file, folder.root());
        each.element()
            .child("Catalog")
            .ifPresent(written -> catalogs.add(Catalog.of(name, written, each.version())));
      } catch (DiagnosticException e) {
        catalogs.add(new Catalog(name, Map.of(), Optional.of(e)));
      }
    }
    return catalogs;
  }

  private static List<Path> filesOf(Path found, SourceLocation place) {
    if (Files.isRegularFile(found)) {
      return List.of(found);
    }
    try (Stream<Path> files = Files.list(found)) {
      return files.filter(file -> file.toString().endsWith(".xosc")).sorted().toList();
    } catch (IOException e) {
      throw Findings.refused(
          DocumentRules.CATALOG_MISSING,
          "The folder `" + SourceLocation.of(found).file() + "` cannot be read.",
          place,
          "");
    }
  }

  private static String listed(List<Location> folders) {
    return folders.stream()
        .map(each -> "`" + each.path() + "`")
        .collect(Collectors.joining(" or "));
  }
}
