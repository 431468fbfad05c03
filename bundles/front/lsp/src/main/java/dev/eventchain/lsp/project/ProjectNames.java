package dev.eventchain.lsp.project;

import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.lsp.project.ProjectSchemas.Kind;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.ProjectBench;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Places where the YAML of a project names its requirements, components, topics and scenarios. */
final class ProjectNames {

  private static final Set<String> COMPONENT = Set.of("kill", "stop", "node");

  private static final Pattern COMPONENT_STEP = Pattern.compile("/software\\[([^\\]\\n]+)\\]");

  private final ProjectFiles project;
  private final Path file;

  ProjectNames(ProjectFiles project, Path file) {
    this.project = project;
    this.file = file;
  }

  /** Returns the numbers that a campaign in the file may vary, by their paths. */
  Map<String, String> factorPaths(String scenario) {
    return project.factorPaths(file, scenario);
  }

  /** Returns the names that may stand at a place, as a key or a value. */
  Map<String, String> at(Kind kind, YamlPlace place) {
    Map<String, String> all = new LinkedHashMap<>();
    if (place.takesKeys()) {
      all.putAll(keys(kind, place));
    }
    if (place.takesValue()) {
      all.putAll(values(kind, place));
    }
    return all;
  }

  /** Returns the names that may be keys at a place, each with what is known about it. */
  Map<String, String> keys(Kind kind, YamlPlace place) {
    List<String> path = place.path();
    String last = place.lastKey();
    return switch (kind) {
      case SCENARIO ->
          last.equals("phases_ms")
              ? project.components()
              : last.equals("judges")
                      || (path.size() > 1 && path.get(path.size() - 2).equals("judges"))
                  ? requirements(path)
                  : Map.of();
      case BENCH ->
          path.equals(List.of("provides")) || path.equals(List.of("consumes"))
              ? project.topics()
              : isFields(path) ? project.fieldsOf(path.get(1)) : Map.of();
      case SETTINGS -> path.equals(List.of("strength", "requirements")) ? requirements() : Map.of();
      case TESTS -> tested().keys(path);
      case SUPPRESSIONS, MUTANTS, FAULTS, CAMPAIGN -> Map.of();
    };
  }

  /** Returns the inputs and outputs of the component whose tests the file has. */
  private ComponentNames tested() {
    return new ComponentNames(project, file.getFileName().toString().replaceFirst("\\.ya?ml$", ""));
  }

  private static boolean namesComponent(Kind kind, YamlPlace place) {
    return kind == Kind.TESTS && place.path().equals(List.of("component"));
  }

  /** Returns whether a name is that of one thing: fields and inputs are called as others are. */
  static boolean isUnique(Kind kind, YamlPlace place) {
    return kind == Kind.TESTS ? namesComponent(kind, place) : !isFields(place.path());
  }

  /** Returns whether a path leads to the fields of a topic in a bench. */
  private static boolean isFields(List<String> path) {
    return path.size() == 3 && path.get(2).equals("fields");
  }

  /** Returns the paths of the components in the chain where suppressions name an element. */
  Map<String, String> elements(Kind kind, YamlPlace place) {
    return namesElement(kind, place) ? project.elements() : Map.of();
  }

  private static boolean namesElement(Kind kind, YamlPlace place) {
    return kind == Kind.SUPPRESSIONS && place.takesValue() && place.lastKey().equals("element");
  }

  /** Returns the component in the path of an element at an offset of a place. */
  Optional<MatchResult> inElement(Kind kind, YamlPlace place, String text, int offset) {
    int begin = offset == 0 ? 0 : text.lastIndexOf('\n', offset - 1) + 1;
    int end = text.indexOf('\n', offset);
    return namesElement(kind, place)
        ? COMPONENT_STEP
            .matcher(text)
            .region(begin, end < 0 ? text.length() : end)
            .results()
            .filter(each -> each.start(1) <= offset && offset <= each.end(1))
            .filter(each -> project.components().containsKey(each.group(1)))
            .findFirst()
        : Optional.empty();
  }

  /** Returns what is known of a component. */
  String about(String component) {
    return project.components().getOrDefault(component, "");
  }

  /**
   * Returns the units that may stand at a place, those of the field there first; they have no place
   * of their own that editors could lead to.
   */
  List<String> units(Kind kind, YamlPlace place) {
    return kind == Kind.BENCH && place.lastKey().equals("unit")
        ? ProjectBench.units(fieldUnit(project, place.path()))
        : List.of();
  }

  /** Returns the unit of the field that a path in a bench leads to; empty if there is none. */
  static String fieldUnit(ProjectFiles project, List<String> path) {
    return path.size() > 3 && isFields(path.subList(0, 3))
        ? project.unit(path.get(1), path.get(3))
        : "";
  }

  /** Returns the names that may be the value of a place, each with what is known about it. */
  Map<String, String> values(Kind kind, YamlPlace place) {
    String last = place.lastKey();
    boolean isOfScenarios = kind == Kind.FAULTS || kind == Kind.CAMPAIGN;
    if (isOfScenarios && last.equals("scenario")) {
      return project.scenarios();
    } else if (kind == Kind.FAULTS && COMPONENT.contains(last)) {
      return project.components();
    } else if (kind == Kind.TESTS) {
      return last.equals("requirement")
          ? requirements()
          : namesComponent(kind, place) ? project.components() : tested().values(place);
    } else if (kind == Kind.MUTANTS && last.equals("component")) {
      return project.components();
    } else if (kind == Kind.FAULTS && last.equals("topic")) {
      return project.topics();
    } else if (kind == Kind.SCENARIO && last.equals("requirements")) {
      return requirements();
    } else if (kind == Kind.SUPPRESSIONS && last.equals("id")) {
      return suppressible();
    }
    return Map.of();
  }

  /** Returns the ids of the findings that may be suppressed. */
  private static Map<String, String> suppressible() {
    Map<String, String> found = new LinkedHashMap<>();
    RulePage.all().stream()
        .filter(RulePage::mayBeSuppressed)
        .forEach(page -> found.put(page.id(), page.firstSentence()));
    return found;
  }

  /** Returns the requirements that criteria judge: below a criterion, or that of a formula. */
  private Map<String, String> requirements(List<String> path) {
    boolean namesCriteria = path.equals(List.of("accept", "judges"));
    return namesCriteria ? Map.of() : requirements();
  }

  private Map<String, String> requirements() {
    Map<String, String> found = new LinkedHashMap<>();
    for (WrittenRequirement each : project.requirements()) {
      found.put(each.id(), each.text());
    }
    return found;
  }
}
