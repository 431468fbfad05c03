package dev.eventchain.lsp.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import dev.eventchain.lsp.project.ProjectSchemas.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/** Proposals in a YAML file of a project: what its schema has, and names of the project. */
final class YamlCompletion {

  /** Words that are no texts in YAML. */
  private static final Pattern TRUTH = Pattern.compile("(?i)true|false|yes|no|on|off|y|n|null");

  private final Kind kind;
  private final ProjectSchema schema;
  private final ProjectNames names;
  private final String text;
  private final TextLines lines;

  YamlCompletion(Kind kind, ProjectSchema schema, ProjectNames names, String text) {
    this.kind = kind;
    this.schema = schema;
    this.names = names;
    this.text = text;
    this.lines = new TextLines(text);
  }

  /** Returns the proposals at an offset, keys that are needed first. */
  List<Completion> at(int offset) {
    return new YamlText(text).place(offset).map(this::at).orElse(List.of());
  }

  /** Returns what the schema says about the key at an offset, or the project about a name. */
  Optional<Hover> described(int offset) {
    Optional<YamlPlace> place = new YamlText(text).place(offset);
    return place
        .filter(YamlPlace::takesKeys)
        .flatMap(
            at ->
                schema.keys(at.path()).stream()
                    .filter(each -> each.name().equals(word(at)))
                    .map(each -> ProjectSchema.description(each.values()))
                    .filter(each -> !each.isEmpty())
                    .map(each -> new Hover(each, replaced(at)))
                    .findFirst())
        .or(
            () ->
                place.flatMap(
                    at ->
                        Optional.ofNullable(names.at(kind, at).get(word(at)))
                            .filter(about -> !about.isEmpty())
                            .map(about -> new Hover(about, replaced(at)))))
        .or(
            () ->
                place
                    .flatMap(at -> names.inElement(kind, at, text, offset))
                    .filter(step -> !names.about(step.group(1)).isEmpty())
                    .map(
                        step ->
                            new Hover(
                                names.about(step.group(1)),
                                lines.range(step.start(1), step.end(1)))));
  }

  /** Returns the name at an offset, if the project has it: of a component, topic or scenario. */
  Optional<String> name(int offset) {
    Optional<YamlPlace> place = new YamlText(text).place(offset);
    return place
        .filter(at -> names.at(kind, at).containsKey(word(at)))
        .filter(at -> ProjectNames.isUnique(kind, at))
        .map(this::word)
        .or(
            () ->
                place
                    .flatMap(at -> names.inElement(kind, at, text, offset))
                    .map(step -> step.group(1)));
  }

  private String word(YamlPlace place) {
    return text.substring(place.start(), place.end());
  }

  private List<Completion> at(YamlPlace place) {
    List<Completion> found = new ArrayList<>();
    if (place.takesKeys()) {
      for (ProjectSchema.Key each : schema.keys(place.path())) {
        if (!place.keys().contains(each.name())) {
          found.add(key(each, place));
        }
      }
      names.keys(kind, place).entrySet().stream()
          .filter(each -> !place.keys().contains(each.getKey()))
          .map(each -> name(each, place, isBeforeColon(place) ? "" : ": "))
          .forEach(found::add);
      if (!place.isFlow() && !isBeforeColon(place)) {
        SchemaSnippets.at(schema, place).forEach(each -> found.add(snippet(each, place)));
      }
    }
    if (place.takesValue()) {
      values(place, found);
    }
    return found;
  }

  private boolean isBeforeColon(YamlPlace place) {
    return text.startsWith(":", place.end());
  }

  private Completion snippet(SchemaSnippets.Snippet snippet, YamlPlace place) {
    return new Completion(
        snippet.label(),
        ElementKind.SNIPPET,
        "with what is required",
        "",
        snippet.text(),
        true,
        replaced(place));
  }

  private Completion key(ProjectSchema.Key key, YamlPlace place) {
    boolean isList = key.isOf("array");
    boolean isNested = !key.isScalar() && (isList || key.isOf("object"));
    String after = ": ";
    boolean isSnippet = false;
    List<String> values = ProjectSchema.values(key.values());
    if (isBeforeColon(place)) {
      after = "";
    } else if (isNested && place.isFlow()) {
      after = isList ? ": [$0]" : ": {$0}";
      isSnippet = true;
    } else if (isNested) {
      // Editors indent each further line as the first one.
      after = ":\n" + " ".repeat(place.extra() + 2) + (isList ? "- " : "") + "$0";
      isSnippet = true;
    } else if (values.size() == 1 && key.values().size() == 1) {
      after = ": " + values.get(0);
    }
    return new Completion(
        key.name(),
        ElementKind.ATTRIBUTE,
        key.isRequired() ? "required" : "",
        ProjectSchema.description(key.values()),
        key.name() + after,
        isSnippet,
        replaced(place));
  }

  private void values(YamlPlace place, List<Completion> found) {
    List<JsonNode> schemas = schema.at(place.path());
    String description = ProjectSchema.description(schemas);
    ProjectSchema.values(schemas)
        .forEach(
            each -> found.add(value(each, ElementKind.ENUMERATION_LITERAL, description, place)));
    names.values(kind, place).forEach((name, about) -> found.add(named(name, about, place)));
    names.elements(kind, place).forEach((path, about) -> found.add(path(path, "", about, place)));
    names.units(kind, place).forEach(unit -> found.add(unit(unit, place)));
    if (kind == Kind.CAMPAIGN) {
      FactorPlace.of(place)
          .map(it -> it.scenario(new YamlText(text)))
          .map(names::factorPaths)
          .ifPresent(paths -> paths.forEach((path, now) -> found.add(path(path, now, "", place))));
    }
  }

  /** Returns a path, which replaces all that is written, and needs quotes in brackets. */
  private Completion path(String path, String now, String about, YamlPlace place) {
    int start = place.start();
    boolean isQuoted = start > 0 && "\"'".indexOf(text.charAt(start - 1)) >= 0;
    String ends = isQuoted ? "\"'\r\n" : place.isFlow() ? ",}\r\n" : "\r\n";
    int end = start;
    while (end < text.length()
        && ends.indexOf(text.charAt(end)) < 0
        && !text.startsWith(" #", end)) {
      end++;
    }
    boolean needsQuotes = place.isFlow() && !isQuoted && path.indexOf('[') >= 0;
    boolean isJoined = start > 0 && text.charAt(start - 1) == ':';
    return new Completion(
        path,
        ElementKind.REFERENCE,
        now,
        about,
        (isJoined ? " " : "") + (needsQuotes ? '"' + path + '"' : path),
        false,
        lines.range(start, start + text.substring(start, end).stripTrailing().length()));
  }

  private Completion named(String name, String about, YamlPlace place) {
    boolean isText = kind == Kind.TESTS && about.isEmpty();
    return isText && !name.matches("true|false")
        ? quoted(name, name.matches("(?i)[a-z_]\\w*") && !TRUTH.matcher(name).matches(), place)
        : value(name, ElementKind.REFERENCE, about, place);
  }

  /** Returns a unit; in YAML, a number and a percentage need quotation marks to be one. */
  private Completion unit(String unit, YamlPlace place) {
    return quoted(unit, Character.isLetter(unit.charAt(0)), place);
  }

  private Completion quoted(String name, boolean isText, YamlPlace place) {
    char before = place.start() > 0 ? text.charAt(place.start() - 1) : ' ';
    boolean isPlain = "\"'".indexOf(before) >= 0 || isText;
    return new Completion(
        name,
        ElementKind.ENUMERATION_LITERAL,
        "",
        "",
        (before == ':' ? " " : "") + (isPlain ? name : '"' + name + '"'),
        false,
        replaced(place));
  }

  private Completion value(
      String value, ElementKind kindOfIt, String documentation, YamlPlace place) {
    boolean isJoined = place.start() > 0 && text.charAt(place.start() - 1) == ':';
    return new Completion(
        value, kindOfIt, "", documentation, isJoined ? " " + value : value, false, replaced(place));
  }

  private Completion name(Map.Entry<String, String> name, YamlPlace place, String after) {
    return new Completion(
        name.getKey(),
        ElementKind.REFERENCE,
        "",
        name.getValue(),
        name.getKey() + after,
        false,
        replaced(place));
  }

  private TextRange replaced(YamlPlace place) {
    return lines.range(place.start(), place.end());
  }
}
