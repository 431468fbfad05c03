package dev.eventchain.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.project.requirements.RequirementSource;
import dev.eventchain.project.requirements.RequirementSource.Fields;
import dev.eventchain.project.requirements.RequirementSource.Only;
import dev.eventchain.project.requirements.SourceRequirements;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The files and folders of requirements that {@code eventchain.yaml} names under {@code
 * requirements}, besides {@code requirements.md}: one, or a list, each a name or a mapping with
 * {@code file}, {@code only} and {@code fields}.
 */
public final class RequirementSources {

  /** None. */
  public static final RequirementSources NONE = new RequirementSources(List.of());

  private static final String SETTING = "requirements";
  private static final String FILE = "file";

  private final List<RequirementSource> sources;

  private RequirementSources(List<RequirementSource> sources) {
    this.sources = List.copyOf(sources);
  }

  /**
   * Reads the setting; the reader reports invalid values.
   *
   * @param folder the folder of the project, from which names are relative
   */
  public static RequirementSources read(ObjectReader settings, Path folder) {
    Optional<JsonNode> value = settings.value(SETTING);
    List<RequirementSource> sources = new ArrayList<>();
    if (value.isEmpty() && !settings.has(SETTING)) {
      return NONE;
    } else if (value.filter(JsonNode::isArray).isPresent()) {
      boolean names = value.get().size() > 0 && value.get().get(0).isTextual();
      List<String> files = names ? settings.texts(SETTING) : List.of();
      files.forEach(file -> named(file, settings, folder).ifPresent(sources::add));
      if (!names) {
        settings.objects(SETTING).forEach(each -> source(each, folder).ifPresent(sources::add));
      }
      if (value.get().isEmpty()) {
        String message = "'" + SETTING + "' names nothing; leave it out.";
        settings.find(ProjectSettings.RULES.missing(), message, settings.at(SETTING));
      }
    } else if (value.filter(JsonNode::isObject).isPresent()) {
      settings.object(SETTING).flatMap(each -> source(each, folder)).ifPresent(sources::add);
    } else {
      named(settings.requiredText(SETTING), settings, folder).ifPresent(sources::add);
    }
    return new RequirementSources(sources);
  }

  private static Optional<RequirementSource> named(
      String file, ObjectReader settings, Path folder) {
    return path(file, settings, SETTING, folder)
        .map(it -> new RequirementSource(it, folder, Only.ALL, Fields.USUAL, settings.at(SETTING)));
  }

  private static Optional<RequirementSource> source(ObjectReader source, Path folder) {
    Optional<Path> file = path(source.requiredText(FILE), source, FILE, folder);
    Only only = source.object("only").map(RequirementSources::only).orElse(Only.ALL);
    Fields fields = source.object("fields").map(RequirementSources::fields).orElse(Fields.USUAL);
    source.refuseOthers();
    return file.map(it -> new RequirementSource(it, folder, only, fields, source.location()));
  }

  private static Only only(ObjectReader only) {
    Only read = new Only(several(only, "type"), several(only, "status"), several(only, "tag"));
    only.refuseOthers();
    return read;
  }

  private static Fields fields(ObjectReader fields) {
    Fields read =
        new Fields(
            fields.text("id"),
            fields.text("text"),
            fields.text("status"),
            fields.text("tags"),
            several(fields, "parents"));
    fields.refuseOthers();
    return read;
  }

  private static List<String> several(ObjectReader settings, String key) {
    Optional<JsonNode> value = settings.value(key);
    if (value.filter(JsonNode::isArray).isPresent()) {
      if (value.get().isEmpty()) {
        String message = "'" + key + "' names nothing, so nothing would count; leave it out.";
        settings.find(ProjectSettings.RULES.missing(), message, settings.at(key));
      }
      return settings.texts(key);
    }
    return settings.has(key) ? List.of(settings.requiredText(key)) : List.of();
  }

  private static Optional<Path> path(String file, ObjectReader settings, String key, Path folder) {
    try {
      Path path = folder.resolve(file).normalize();
      if (path.getFileName() != null) {
        return file.isBlank() ? Optional.empty() : Optional.of(path);
      }
    } catch (InvalidPathException e) {
      // reported below
    }
    settings.find(
        Diagnostic.of(
            ProjectSettings.RULES.range(),
            "'" + file + "' cannot be a file or folder of requirements.",
            settings.at(key)));
    return Optional.empty();
  }

  /** Returns whether there are none. */
  public boolean isEmpty() {
    return sources.isEmpty();
  }

  /** Returns whether a file is one of them. */
  boolean has(Path file) {
    Path wanted = file.toAbsolutePath().normalize();
    return sources.stream()
        .anyMatch(each -> each.file().toAbsolutePath().normalize().equals(wanted));
  }

  List<RequirementSource> all() {
    return sources;
  }

  /**
   * Reads an older state of the requirements: with the choice of the source that has its name, or
   * else of the first one in its format; without one if there is neither.
   *
   * @param old Markdown, or a file or folder in another format
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT as {@link
   *     ProjectFolder#readRequirements}
   */
  public Requirements readOlder(Path old) {
    boolean list =
        old.toString().endsWith(".md")
            && sources.stream().noneMatch(each -> isAlike(each.file(), old));
    Requirements all =
        list
            ? Requirements.read(SourceText.read(old))
            : Requirements.read(Optional.empty(), like(old));
    ProjectFolder.refuseErrors(all.diagnostics());
    return all;
  }

  private RequirementSources like(Path other) {
    Path project = ProjectFolder.around(other).map(ProjectFolder::folder).orElse(other);
    RequirementSource usual =
        new RequirementSource(other, project, Only.ALL, Fields.USUAL, SourceLocation.of(other));
    return new RequirementSources(
        List.of(
            sources.stream()
                .filter(each -> name(each.file()).equals(name(other)))
                .findFirst()
                .or(() -> sources.stream().filter(each -> isAlike(each.file(), other)).findFirst())
                .map(
                    each ->
                        new RequirementSource(
                            other, project, each.only(), each.fields(), each.place()))
                .orElse(usual)));
  }

  /** Returns whether two files have one format, by their names, or are two folders. */
  private static boolean isAlike(Path file, Path other) {
    return suffix(file).equals(suffix(other));
  }

  private static String suffix(Path file) {
    return Files.isDirectory(file) ? "" : name(file).replaceFirst(".*\\.", "");
  }

  /** Returns the last part of a path; empty for the root of a file system. */
  private static String name(Path file) {
    return file.getFileName() == null ? "" : file.getFileName().toString();
  }

  /** Returns the named files and folders. */
  public List<Path> named() {
    return sources.stream().map(RequirementSource::file).toList();
  }

  /**
   * Returns the files that are read, which need not exist.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a folder cannot be read
   */
  public List<Path> files() {
    return sources.stream()
        .flatMap(source -> SourceRequirements.files(source).stream())
        .distinct()
        .toList();
  }

  /** Returns what is read and what counts, for fingerprints. */
  public String asValue() {
    return sources.stream()
        .map(each -> name(each.file()) + " " + each.only() + " " + each.fields())
        .toList()
        .toString();
  }
}
