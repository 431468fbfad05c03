package dev.eventchain.catalogue.vss;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The entries of files by path: nested under {@code children} or side by side with whole paths, in
 * JSON or YAML, with the files that they include.
 */
final class VssFiles {

  /** Key of the types of structures, which are no signals. */
  static final String STRUCTURES = "ComplexDataTypes";

  private static final String CHILDREN = "children";
  private static final String INCLUDES = "includes";
  private static final DocumentRules RULES = DocumentRules.all(CatalogueRules.ENTRY);
  private static final Pattern INCLUDE =
      Pattern.compile(
          "^[ \\t]*#include[ \\t]+(?<file>\\S+)(?:[ \\t]+(?<branch>\\S+))?[ \\t]*$",
          Pattern.MULTILINE);

  /** An entry: its attributes, of which later files replace some. */
  record Entry(VssValue last, Map<String, VssValue> attributes) {}

  private final Map<String, Entry> entries = new LinkedHashMap<>();
  private final Deque<Path> reading = new ArrayDeque<>();
  private final Consumer<Diagnostic> findings;

  VssFiles(Consumer<Diagnostic> findings) {
    this.findings = findings;
  }

  /** Returns the entries by path, in the order in which they were first read. */
  Map<String, Entry> entries() {
    return entries;
  }

  /** Reads a catalogue. */
  void read(Path file) {
    read(file, "", this::put);
  }

  /** Reads an overlay, whose entries replace attributes; {@code *} stands for any text. */
  void overlay(Path file) {
    read(
        file,
        "",
        (path, entry) -> {
          if (path.contains("*")) {
            matching(path, entry).forEach(each -> put(each, entry));
          } else {
            put(path, entry);
          }
        });
  }

  private List<String> matching(String pattern, Entry entry) {
    Pattern glob = Pattern.compile(Pattern.quote(pattern).replace("*", "\\E.*\\Q"));
    List<String> found =
        entries.keySet().stream().filter(path -> glob.matcher(path).matches()).toList();
    if (found.isEmpty()) {
      findings.accept(
          Diagnostic.of(
                  CatalogueRules.OVERLAY,
                  "'" + pattern + "' is the path of no entry.",
                  entry.last().key())
              .withHint("Correct it; the instances of branches are not there yet."));
    }
    return found;
  }

  private void put(String path, Entry entry) {
    Entry known = entries.get(path);
    Map<String, VssValue> all = new LinkedHashMap<>();
    if (known != null) {
      all.putAll(known.attributes());
    }
    all.putAll(entry.attributes());
    entries.put(path, new Entry(entry.last(), all));
  }

  /** Files that a branch includes. */
  private record Listed(String path, VssValue files) {}

  private interface Target {
    void put(String path, Entry entry);
  }

  private void read(Path file, String branch, Target target) {
    reading.push(file.toAbsolutePath().normalize());
    try {
      SourceText text = SourceText.read(file);
      DocumentFormat format =
          file.toString().endsWith(".json") ? DocumentFormat.JSON : DocumentFormat.YAML;
      Optional<Document> document = Document.parseIfAny(text, format, RULES, findings);
      document
          .filter(it -> it.object("", findings).isPresent())
          .ifPresent(it -> entries(it, file, branch, target));
      if (format == DocumentFormat.YAML) {
        comments(text, file, branch, target);
      }
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(findings);
    } finally {
      reading.pop();
    }
  }

  /** Reads the entries of a file, and then what they include, which replaces attributes. */
  private void entries(Document document, Path file, String branch, Target target) {
    List<Listed> listed = new ArrayList<>();
    children(new VssValue(document.root(), document, ""), branch, target, listed);
    listed.forEach(each -> include(each, file, target));
  }

  private void children(VssValue parent, String branch, Target target, List<Listed> listed) {
    parent
        .json()
        .properties()
        .forEach(
            field -> {
              String pointer = Document.below(parent.pointer(), field.getKey());
              VssValue value = new VssValue(field.getValue(), parent.document(), pointer);
              String path = branch.isEmpty() ? field.getKey() : branch + "." + field.getKey();
              if (branch.isEmpty() && field.getKey().equals(STRUCTURES)) {
                path = STRUCTURES;
              }
              entry(value, path, target, listed);
            });
  }

  private void entry(VssValue value, String path, Target target, List<Listed> listed) {
    if (!value.json().isObject()) {
      String message = "'" + path + "' must have attributes, such as its type.";
      findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, value.key()));
      return;
    }
    if (path.equals(STRUCTURES)) {
      children(value, STRUCTURES, target, listed);
      return;
    }
    Map<String, VssValue> attributes = attributes(value);
    VssValue below = attributes.remove(CHILDREN);
    VssValue includes = attributes.remove(INCLUDES);
    if (includes != null) {
      listed.add(new Listed(path, includes));
    }
    target.put(path, new Entry(value, attributes));
    if (below != null && below.json().isObject()) {
      children(below, path, target, listed);
    } else if (below != null) {
      String message = "'children' of '" + path + "' must hold entries.";
      findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, below.key()));
    }
  }

  private static Map<String, VssValue> attributes(VssValue entry) {
    Map<String, VssValue> attributes = new LinkedHashMap<>();
    entry
        .json()
        .properties()
        .forEach(
            field -> {
              String pointer = Document.below(entry.pointer(), field.getKey());
              attributes.put(
                  field.getKey(), new VssValue(field.getValue(), entry.document(), pointer));
            });
    return attributes;
  }

  /** Reads what is included in comments: {@code #include FILE BRANCH}. */
  private void comments(SourceText text, Path file, String branch, Target target) {
    Matcher include = INCLUDE.matcher(text.text());
    while (include.find()) {
      String below = include.group("branch");
      include(
          include.group("file"),
          text.at(include.start("file")),
          file,
          below == null ? branch : branch.isEmpty() ? below : branch + "." + below,
          target);
    }
  }

  /** Reads what a branch includes: {@code includes: [FILE]}. */
  private void include(Listed listed, Path from, Target target) {
    VssValue files = listed.files();
    if (!files.json().isArray() && !files.json().isNull()) {
      String message = "'includes' of '" + listed.path() + "' must be a list of files.";
      findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, files.key()));
      return;
    }
    for (int i = 0; i < files.json().size(); i++) {
      SourceLocation place = files.document().at(Document.below(files.pointer(), i));
      include(files.json().get(i).asText(), place, from, listed.path(), target);
    }
  }

  private void include(
      String named, SourceLocation place, Path from, String branch, Target target) {
    Optional<Path> found = find(named, from);
    if (found.isEmpty()) {
      String message = "There is no file '" + named + "' to include.";
      findings.accept(
          Diagnostic.of(CatalogueRules.INCLUDE, message, place)
              .withHint("It is looked for beside this file, and beside the catalogue itself."));
    } else if (reading.contains(found.get())) {
      String message = "'" + named + "' includes itself.";
      findings.accept(Diagnostic.of(CatalogueRules.INCLUDE, message, place));
    } else {
      read(found.get(), branch, target);
    }
  }

  private Optional<Path> find(String named, Path from) {
    List<String> names = new ArrayList<>(List.of(named));
    names.addAll(List.of(named + ".vspec", named + ".yaml", named + ".yml"));
    for (Path folder : List.of(reading.getLast().resolveSibling(""), from.resolveSibling(""))) {
      for (String name : names) {
        try {
          Path file = folder.resolve(name).toAbsolutePath().normalize();
          if (Files.isRegularFile(file)) {
            return Optional.of(file);
          }
        } catch (InvalidPathException e) {
          return Optional.empty();
        }
      }
    }
    return Optional.empty();
  }
}
