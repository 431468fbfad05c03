package dev.eventchain.lsp.project;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Texts with all keys that a mapping needs, by the schema, and places for their values in the
 * syntax of the Language Server Protocol: the missing ones of a mapping, one text for each
 * alternative, and a key with what its own value needs.
 */
final class SchemaSnippets {

  /** The most alternatives that are proposed. */
  private static final int MOST = 12;

  /** The number of keys around a value down to which it is written out. */
  private static final int DEEPEST = 5;

  private final ProjectSchema schema;
  private final String margin;

  /** The number of the last place for a value. */
  private int places;

  /** A text under the keys that it begins with. */
  record Snippet(String label, String text) {}

  private SchemaSnippets(ProjectSchema schema, String margin) {
    this.schema = schema;
    this.margin = margin;
  }

  /** Returns the texts for a place that takes keys, in lines of their own. */
  static List<Snippet> at(ProjectSchema schema, YamlPlace place) {
    SchemaSnippets snippets = new SchemaSnippets(schema, " ".repeat(place.extra()));
    List<Snippet> found = new ArrayList<>();
    for (Set<String> each : schema.needs(place.path(), place.keys())) {
      List<ProjectSchema.Key> missing =
          schema.keys(place.path()).stream()
              .filter(it -> each.contains(it.name()) && !place.keys().contains(it.name()))
              .toList();
      if (missing.size() > 1 && found.size() < MOST) {
        found.add(snippets.mapping(place.path(), missing));
      }
    }
    for (ProjectSchema.Key each : schema.keys(place.path())) {
      if (!place.keys().contains(each.name()) && (each.isOf("object") || each.isOf("array"))) {
        snippets.places = 0;
        String text = snippets.entry(place.path(), each, snippets.margin);
        if (snippets.places > 1) {
          found.add(new Snippet(each.name() + " \u2026", text));
        }
      }
    }
    return found;
  }

  private Snippet mapping(List<String> path, List<ProjectSchema.Key> keys) {
    places = 0;
    List<String> lines = keys.stream().map(each -> entry(path, each, margin)).toList();
    String label = String.join(", ", keys.stream().map(ProjectSchema.Key::name).toList());
    return new Snippet(label, String.join("\n" + margin, lines));
  }

  private String entry(List<String> path, ProjectSchema.Key key, String indent) {
    return key.name() + ":" + value(below(path, key.name()), key, indent);
  }

  private static List<String> below(List<String> path, String step) {
    List<String> steps = new ArrayList<>(path);
    steps.add(step);
    return steps;
  }

  /** Returns the value at a path, behind the colon of its key or the dash of its list. */
  private String value(List<String> path, ProjectSchema.Key key, String indent) {
    List<String> values = ProjectSchema.values(key.values());
    if (values.size() == 1 && key.values().size() == 1) {
      return " " + values.get(0);
    } else if (!values.isEmpty()) {
      return " " + place(values.get(0));
    } else if (key.isScalar() || path.size() > DEEPEST) {
      return " " + place("");
    } else if (key.isOf("array")) {
      List<String> item = below(path, YamlPlace.ITEM);
      String inner = indent + "    ";
      return "\n" + indent + "  - " + content(item, inner).stripLeading();
    }
    return content(path, indent + "  ");
  }

  /** Returns what a mapping or value needs, each key in a line of its own. */
  private String content(List<String> path, String indent) {
    Set<String> needed = schema.needs(path, Set.of()).get(0);
    List<ProjectSchema.Key> keys =
        schema.keys(path).stream().filter(each -> needed.contains(each.name())).toList();
    StringBuilder text = new StringBuilder();
    keys.forEach(each -> text.append('\n').append(indent).append(entry(path, each, indent)));
    if (!text.isEmpty()) {
      return text.toString();
    }
    ProjectSchema.Key value = new ProjectSchema.Key("", false, schema.at(path));
    List<String> any = below(path, YamlPlace.ANY);
    boolean isNamed = schema.keys(path).isEmpty() && !schema.at(any).isEmpty();
    if (isNamed && !value.isScalar()) {
      ProjectSchema.Key named = new ProjectSchema.Key(place("name"), false, schema.at(any));
      return "\n" + indent + named.name() + ":" + value(any, named, indent);
    }
    return value.isScalar() ? value(path, value, indent) : "\n" + indent + place("");
  }

  private String place(String value) {
    places++;
    String known = value.matches("[\\w.-]*") ? value : "";
    return known.isEmpty() ? "$" + places : "${" + places + ":" + known + "}";
  }
}
