package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Nodes that a launch file starts without arguments, in its order. */
final class LaunchRun {

  private static final int DEEPEST = 20;
  private static final Pattern VARIABLE = Pattern.compile("\\$\\((?:var|arg) '?([^)' ]+)'?\\)");
  private static final Pattern SHARE =
      Pattern.compile("\\$\\(find-pkg-share '?([^)' ]+)'?\\)/+(.+)");
  private static final Pattern HERE = Pattern.compile("\\$\\(dirname\\)/+(.+)");
  private static final Set<String> WITHOUT_NODES =
      Set.of("log", "set_env", "unset_env", "ignored", "param", "remap");

  /**
   * A node that is started.
   *
   * @param owner the package that has the executable
   * @param name that it is given; empty for its own
   * @param isNameUnknown whether it is given one that is not known
   * @param parameters values of its parameters, by their names, as far as they are known
   */
  record Started(
      String owner,
      String executable,
      Optional<String> name,
      boolean isNameUnknown,
      Optional<String> namespace,
      List<TopicNames.Remap> remaps,
      Map<String, JsonNode> parameters,
      String file,
      int line) {}

  /**
   * Elements of all launch files by their names, and folders of packages, both in the workspace.
   */
  record Sources(Map<String, List<LaunchElement>> files, Map<String, String> packages) {}

  private static final class Scope {
    final Map<String, String> variables;

    /** Values of variables that no argument gives, from where they are used. */
    final Map<String, String> fallbacks = new HashMap<>();

    final List<TopicNames.Remap> remaps;
    Optional<String> namespace;

    Scope(Map<String, String> variables, List<TopicNames.Remap> remaps, Optional<String> space) {
      this.variables = new HashMap<>(variables);
      this.remaps = new ArrayList<>(remaps);
      this.namespace = space;
    }

    Scope inner() {
      Scope inner = new Scope(variables, remaps, namespace);
      inner.fallbacks.putAll(fallbacks);
      return inner;
    }
  }

  private final Sources sources;
  private final List<OpenQuestion> questions;
  private final List<Started> started = new ArrayList<>();
  private final Set<String> included = new TreeSet<>();

  private LaunchRun(Sources sources, List<OpenQuestion> questions) {
    this.sources = sources;
    this.questions = questions;
  }

  /**
   * Returns the nodes that a file starts.
   *
   * @param questions receives what is not known
   */
  static List<Started> of(String file, Sources sources, List<OpenQuestion> questions) {
    LaunchRun run = new LaunchRun(sources, questions);
    run.file(file, new Scope(Map.of(), List.of(), Optional.of("/")), 0);
    return run.started;
  }

  /** Returns the files that no other file includes. */
  static List<String> roots(Sources sources) {
    LaunchRun run = new LaunchRun(sources, new ArrayList<>());
    for (String file : sources.files().keySet()) {
      run.file(file, new Scope(Map.of(), List.of(), Optional.of("/")), 0);
    }
    return sources.files().keySet().stream().filter(it -> !run.included.contains(it)).toList();
  }

  private void file(String file, Scope scope, int depth) {
    for (LaunchElement element : sources.files().getOrDefault(file, List.of())) {
      element(element, scope, depth);
    }
  }

  private void element(LaunchElement element, Scope scope, int depth) {
    if (element.isConditional() && !element.kind().equals("arg")) {
      ask(element, "Is this launched? It is under a condition, and taken as launched.");
    }
    switch (element.kind()) {
      case "arg" -> argument(element, "default", scope);
      case "fallback" ->
          text(element, "default", scope)
              .ifPresent(value -> scope.fallbacks.put(known(element, "name").orElse(""), value));
      case "let" -> variable(element, "value", scope);
      case "push_ros_namespace" -> scope.namespace = namespace(element, scope);
      case "set_remap" -> scope.remaps.addAll(0, remaps(element, List.of(element), scope));
      case "group" -> {
        Scope inner = scope.inner();
        element.children().forEach(child -> element(child, inner, depth));
      }
      case "include" -> include(element, scope, depth);
      case "node" -> node(element, scope);
      case "set_parameter" -> parameter(element);
      default -> {
        if (!WITHOUT_NODES.contains(element.kind())) {
          String reason = known(element, "text").orElse("'" + element.kind() + "' is not read");
          ask(element, "Which nodes does this launch: " + reason + "?");
        }
      }
    }
  }

  private void argument(LaunchElement element, String value, Scope scope) {
    if (!known(element, "name").filter(scope.variables::containsKey).isPresent()) {
      variable(element, value, scope);
    }
  }

  private void variable(LaunchElement element, String attribute, Scope scope) {
    Optional<String> value = text(element, attribute, scope);
    known(element, "name")
        .ifPresent(name -> value.ifPresent(known -> scope.variables.put(name, known)));
  }

  private Optional<String> namespace(LaunchElement element, Scope scope) {
    if (!element.attributes().containsKey("namespace")) {
      return scope.namespace;
    }
    Optional<String> given = text(element, "namespace", scope);
    if (given.isEmpty()) {
      ask(element, "What is the namespace?");
    }
    return given.flatMap(
        name ->
            name.startsWith("/")
                ? Optional.of(name)
                : scope.namespace.map(
                    space -> name.isEmpty() ? space : TopicNames.join(space, name)));
  }

  private void include(LaunchElement element, Scope scope, int depth) {
    Optional<String> file = text(element, "file", scope).flatMap(it -> located(it, element.file()));
    if (file.isEmpty() || depth > DEEPEST) {
      ask(element, "Which nodes does the included launch file start? It is not in the workspace.");
      return;
    }
    included.add(file.get());
    Scope inner = scope.inner();
    element.children("arg").forEach(child -> variable(child, "value", inner));
    element.children("let").forEach(child -> variable(child, "value", inner));
    file(file.get(), inner, depth + 1);
  }

  /** Returns the name in the workspace of a launch file. */
  private Optional<String> located(String path, String from) {
    Matcher share = SHARE.matcher(path);
    Matcher here = HERE.matcher(path);
    Optional<String> found = Optional.empty();
    if (share.matches()) {
      String below = share.group(2);
      found =
          Optional.ofNullable(sources.packages().get(share.group(1)))
              .map(folder -> Path.of(folder).resolve(below).normalize().toString());
    } else if (here.matches()) {
      found = Optional.of(Path.of(from).resolveSibling(here.group(1)).normalize().toString());
    }
    return found.filter(sources.files()::containsKey);
  }

  private void node(LaunchElement element, Scope scope) {
    Optional<String> owner = text(element, "pkg", scope);
    Optional<String> executable = text(element, "exec", scope);
    if (owner.isEmpty() || executable.isEmpty()) {
      ask(element, "Which executable of which package is this?");
      return;
    }
    Optional<String> name = text(element, "name", scope);
    boolean unknown = element.attributes().containsKey("name") && name.isEmpty();
    if (unknown) {
      ask(element, "What is the name of this node?");
    }
    List<TopicNames.Remap> remaps =
        new ArrayList<>(remaps(element, element.children("remap"), scope));
    remaps.addAll(scope.remaps);
    started.add(
        new Started(
            owner.get(),
            executable.get(),
            name,
            unknown,
            namespace(element, scope),
            remaps,
            LaunchParameters.of(
                element, child -> text(child, "value", scope), question -> ask(element, question)),
            element.file(),
            element.line()));
  }

  private void parameter(LaunchElement element) {
    String name = known(element, "name").orElse("");
    if (!name.equals(LaunchParameters.SIMULATED)) {
      ask(
          element,
          "Which nodes get the parameter '%s'? 'parameters' of each in components.json say it."
              .formatted(name));
    }
  }

  private List<TopicNames.Remap> remaps(
      LaunchElement owner, List<LaunchElement> elements, Scope scope) {
    List<TopicNames.Remap> found = new ArrayList<>();
    for (LaunchElement remap : elements) {
      LaunchElement pair = remap.children("remap").stream().findFirst().orElse(remap);
      Optional<String> from = text(pair, "from", scope);
      Optional<String> to = text(pair, "to", scope);
      if (from.isPresent() && to.isPresent()) {
        found.add(new TopicNames.Remap(from.get(), to.get()));
      } else {
        ask(owner, "Which name is remapped to which?");
      }
    }
    return found;
  }

  private static Optional<String> known(LaunchElement element, String attribute) {
    return element.attributes().getOrDefault(attribute, Optional.empty());
  }

  /** Returns the value of an attribute with its variables; empty if it is not known. */
  private static Optional<String> text(LaunchElement element, String attribute, Scope scope) {
    return known(element, attribute)
        .flatMap(
            written -> {
              StringBuilder text = new StringBuilder();
              Matcher found = VARIABLE.matcher(written);
              while (found.find()) {
                String name = found.group(1);
                String value = scope.variables.getOrDefault(name, scope.fallbacks.get(name));
                if (value == null) {
                  return Optional.empty();
                }
                found.appendReplacement(text, Matcher.quoteReplacement(value));
              }
              String value = found.appendTail(text).toString();
              boolean open = value.contains("$(") && !attribute.equals("file");
              return open ? Optional.empty() : Optional.of(value);
            });
  }

  private void ask(LaunchElement element, String text) {
    questions.add(new OpenQuestion(text, element.file(), element.line()));
  }
}
