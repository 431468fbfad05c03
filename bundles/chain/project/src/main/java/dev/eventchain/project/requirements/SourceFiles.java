package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/** The files of a source, which is one of them or a folder, and the readers of their formats. */
final class SourceFiles {

  private static final int MOST = 10_000;
  private static final String NEEDS = "needs.json";
  private static final List<String> ITEMS = List.of(".yml", ".yaml", ".md");
  private static final List<String> FORMATS =
      List.of(".reqif", ".reqifz", ".sdoc", ".sgra", ".trlc", ".rsl");
  private static final List<String> TEXTS = List.of(".md", ".rst");

  private SourceFiles() {}

  /**
   * Returns the files that may be read of a source: its own, sorted, and after them those that its
   * texts name. They need not exist.
   *
   * @throws DiagnosticException INPUT if a folder cannot be read
   */
  static List<Path> of(RequirementSource source) {
    List<Path> own = own(source.file());
    List<Path> texts = own.stream().filter(SourceFiles::isText).toList();
    Set<Path> all = new LinkedHashSet<>(own);
    all.addAll(new RstReferences(texts, new TextFolders(source)).files());
    return List.copyOf(all);
  }

  private static List<Path> own(Path source) {
    if (Files.isDirectory(source)) {
      List<Path> all = below(source);
      List<Path> ofTools = all.stream().filter(SourceFiles::isRead).toList();
      return ofTools.isEmpty() ? all.stream().filter(SourceFiles::isText).toList() : ofTools;
    }
    List<Path> files = new ArrayList<>(List.of(source));
    Path folder = source.toAbsolutePath().getParent();
    if (has(source, ".trlc") && Files.isDirectory(folder)) {
      Path shown = source.getParent() == null ? Path.of("") : source.getParent();
      below(folder).stream()
          .filter(each -> has(each, ".rsl"))
          .forEach(each -> files.add(shown.resolve(folder.relativize(each))));
    }
    return files;
  }

  private static boolean isRead(Path file) {
    return FORMATS.stream().anyMatch(format -> has(file, format))
        || file.getFileName().toString().equals(NEEDS)
        || (isItem(file) && document(file).isPresent());
  }

  /** Returns whether a file is a text, which is read where no tool keeps the requirements. */
  private static boolean isText(Path file) {
    return TEXTS.stream().anyMatch(suffix -> has(file, suffix)) && document(file).isEmpty();
  }

  /** Returns whether a file may be an item of Doorstop, or the settings of a document. */
  private static boolean isItem(Path file) {
    return ITEMS.stream().anyMatch(suffix -> has(file, suffix));
  }

  static boolean has(Path file, String suffix) {
    return file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(suffix);
  }

  /** Returns the settings of the Doorstop document whose folder, or a part of it, holds a file. */
  private static Optional<Path> document(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    for (Path above = absolute.getParent(); above != null; above = above.getParent()) {
      Path settings = above.resolve(DoorstopReader.SETTINGS);
      if (Files.exists(settings)) {
        return Optional.of(settings);
      }
    }
    return Optional.empty();
  }

  private static List<Path> below(Path folder) {
    try (Stream<Path> files = Files.walk(folder, FileVisitOption.FOLLOW_LINKS)) {
      List<Path> found =
          files
              .filter(file -> !isHidden(folder.relativize(file)))
              .filter(file -> Files.isRegularFile(file) || isLinkToNothing(file))
              .limit(MOST + 1L)
              .sorted()
              .toList();
      if (found.size() > MOST) {
        throw Reading.refused(
            "The folder has more than " + MOST + " files.",
            SourceLocation.of(folder),
            "Name a folder of requirements alone.");
      }
      return found;
    } catch (IOException e) {
      throw FileRules.refusal("The folder", folder, e);
    } catch (UncheckedIOException e) {
      throw FileRules.refusal("The folder", folder, e.getCause());
    }
  }

  private static boolean isLinkToNothing(Path file) {
    return Files.isSymbolicLink(file) && !Files.exists(file);
  }

  private static boolean isHidden(Path file) {
    for (Path part : file) {
      boolean settings = part.toString().equals(DoorstopReader.SETTINGS);
      if (part.toString().startsWith(".") && !settings) {
        return true;
      }
    }
    return false;
  }

  /** Reads all items of a source. */
  static void read(RequirementSource source, Reading reading) {
    List<Path> files = own(source.file());
    TrlcTypes types = new TrlcTypes();
    Map<Path, List<Path>> documents = new TreeMap<>();
    for (Path file : files) {
      if (has(file, ".rsl")) {
        Reading.file(file, reading, text -> done(() -> types.read(new TrlcTokens(text))));
      } else if (isItem(file)) {
        document(file).ifPresent(it -> documents.computeIfAbsent(it, key -> new ArrayList<>()));
        document(file).ifPresent(it -> addItem(documents.get(it), file));
      }
    }
    for (Path file : files) {
      if (!isText(file)) {
        readFile(file, files, types, reading);
      }
    }
    readTexts(source, files.stream().filter(SourceFiles::isText).toList(), reading);
    documents.forEach(
        (settings, items) -> DoorstopReader.read(shown(settings, source), items, reading));
    if (files.isEmpty()) {
      reading.unread(
          "The folder holds no requirements in a format that is read.",
          SourceLocation.of(source.file()),
          "These are .reqif, .reqifz, .sdoc, .trlc, needs.json, the folders of Doorstop, .md and .rst.");
    }
  }

  /**
   * Reads texts, and those that they name. A text that another one takes in is read there, with
   * what is around it; only where none does, it is read by itself.
   */
  private static void readTexts(RequirementSource source, List<Path> own, Reading reading) {
    TextFolders folders = new TextFolders(source);
    RstFiles files = new RstFiles(reading, folders);
    TextItems texts = new TextItems(reading, files);
    Set<Path> parts = new RstReferences(own, folders).included();
    Set<Path> done = new HashSet<>();
    List<Path> open = new ArrayList<>(own.stream().filter(it -> !isIn(parts, it)).toList());
    open.addAll(own.stream().filter(it -> isIn(parts, it)).toList());
    for (int i = 0; i < open.size(); i++) {
      Path file = open.get(i).normalize();
      if (done.add(file) && !files.isIncluded(file)) {
        Reading.file(file, reading, text -> done(() -> texts.read(file, text)));
      }
      boolean isLast = i + 1 == open.size();
      files.documents().stream().filter(it -> isLast && !done.contains(it)).forEach(open::add);
    }
    texts.end();
  }

  private static boolean isIn(Set<Path> files, Path file) {
    return files.contains(file.normalize());
  }

  private static void addItem(List<Path> items, Path file) {
    if (!file.getFileName().toString().equals(DoorstopReader.SETTINGS)) {
      items.add(file);
    }
  }

  /** Returns a file as it is displayed: below the source as the project names that. */
  private static Path shown(Path file, RequirementSource source) {
    Path base = source.file().toAbsolutePath().normalize();
    return file.startsWith(base) ? source.file().resolve(base.relativize(file)) : file;
  }

  private static void readFile(Path file, List<Path> files, TrlcTypes types, Reading reading) {
    if (has(file, ".reqifz")) {
      try {
        ReqIfArchive.read(file, reading);
      } catch (DiagnosticException e) {
        reading.findings.addAll(e.diagnostics());
      }
    } else if (has(file, ".reqif")) {
      Reading.file(file, reading, text -> done(() -> ReqIfReader.read(text, reading)));
    } else if (has(file, ".sdoc")) {
      Reading.file(file, reading, text -> done(() -> sdoc(file, files, text, reading)));
    } else if (has(file, ".trlc")) {
      Reading.file(
          file, reading, text -> done(() -> TrlcReader.read(new TrlcTokens(text), types, reading)));
    } else if (has(file, ".json")) {
      Reading.file(file, reading, text -> done(() -> JsonItems.read(text, reading)));
    } else if (!isItem(file) && !has(file, ".rsl") && !has(file, ".sgra")) {
      unknown(file, reading);
    } else if (isItem(file) && document(file).isEmpty()) {
      unknown(file, reading);
    }
  }

  private static void sdoc(Path file, List<Path> files, SourceText text, Reading reading) {
    SdocReader.Neighbours neighbours =
        new SdocReader.Neighbours() {
          @Override
          public Optional<List<String>> grammar(String name) {
            return Reading.file(file.resolveSibling(name), reading, Optional::of)
                .map(grammar -> grammar.text().lines().toList());
          }

          @Override
          public boolean isRead(String name) {
            Path wanted = file.resolveSibling(name).normalize();
            return files.stream().anyMatch(each -> each.normalize().equals(wanted));
          }
        };
    SdocReader.read(text, neighbours, reading);
  }

  private static void unknown(Path file, Reading reading) {
    SourceText.read(file); // says if there is none
    reading.unread(
        "This is not a format of requirements that is read.",
        SourceLocation.of(file),
        "Name a .reqif, .reqifz, .sdoc, .trlc, .json, .md or .rst file, or a folder.");
  }

  private static Optional<Boolean> done(Runnable reading) {
    reading.run();
    return Optional.of(true);
  }
}
