package dev.eventchain.workspace;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Nodes that a launch file starts without arguments, in its order. */
final class LaunchRun {

  private static final int DEEPEST = 20;
  private static final Pattern VARIABLE = Pattern.compile("\\$\\((?:var|arg) '?([^)' ]+)'?\\)");
  private static final Pattern SHARE =
      Pattern.compile("\\$\\(find-pkg-share '?([^)' ]+)'?\\)/+(.+)");
  private static final Pattern HERE = Pattern.compile("\\$\\(dirname\\)/+(.+)");

  /** Value of a variable that is not known: it is never complete. */
  private static final String UNKNOWN = "$(unknown)";

  /** Attributes with the arguments of a node. */
  private static final List<String> ARGUMENTS = List.of("args", "ros_args");

  private static final Pattern ASSIGNS = Pattern.compile("(^|\\s)(-p|--param\\S*)(\\s|$)");
  private static final Pattern WITHOUT_EFFECT =
      Pattern.compile("\\s*(--ros-args\\s*)?(--log-level\\s+\\S+\\s*)*(--\\s*)?");

  private static final Set<String> WITHOUT_NODES =
      Set.of("log", "set_env", "unset_env", "ignored", "param", "remap");

  /**
   * A node that is started.
   *
   * @param owner the package that has the executable
   * @param name that it is given; empty for its own
   * @param isNameUnknown whether it is given one that is not known
   * @param parameters what is assigned to its parameters, in the order in which launch gives it
   */
  record Started(
      String owner,
      String executable,
      Optional<String> name,
      boolean isNameUnknown,
      Optional<String> namespace,
      List<TopicNames.Remap> remaps,
      List<ParameterAssignment> parameters,
      String file,
      int line) {}

  /**
   * Files and packages that launch files refer to.
   *
   * @param files elements of all launch files by their names in the workspace
   * @param packages the folders of packages in the workspace, by the names of packages
   * @param texts returns the text of a file by its name in the workspace
   */
  record Sources(
      Map<String, List<LaunchElement>> files,
      Map<String, String> packages,
      Function<String, Optional<SourceText>> texts) {}

  private static final class Scope {
    final Map<String, String> variables;

    /** Values of variables that no argument gives, from where they are used. */
    final Map<String, String> fallbacks = new HashMap<>();

    final List<TopicNames.Remap> remaps;
    Optional<String> namespace;

    /** Assignments to the parameters of all later nodes. */
    final List<ParameterAssignment> parameters;

    Scope() {
      this(Map.of(), List.of(), Optional.of("/"), new ArrayList<>());
    }

    private Scope(
        Map<String, String> variables,
        List<TopicNames.Remap> remaps,
        Optional<String> space,
        List<ParameterAssignment> parameters) {
      this.variables = new HashMap<>(variables);
      this.remaps = new ArrayList<>(remaps);
      this.namespace = space;
      this.parameters = parameters;
    }

    /** Returns the scope of a group, which keeps what it changes. */
    Scope inner() {
      return inner(new ArrayList<>(parameters));
    }

    /** Returns the scope of an included file; the parameters that it sets stay set behind it. */
    Scope included() {
      return inner(parameters);
    }

    private Scope inner(List<ParameterAssignment> set) {
      Scope inner = new Scope(variables, remaps, namespace, set);
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
    run.file(file, new Scope(), 0);
    return run.started;
  }

  /** Returns the files that no other file includes. */
  static List<String> roots(Sources sources) {
    LaunchRun run = new LaunchRun(sources, new ArrayList<>());
    for (String file : sources.files().keySet()) {
      run.file(file, new Scope(), 0);
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
          path(element, "default", scope)
              .ifPresent(value -> scope.fallbacks.put(known(element, "name").orElse(""), value));
      case "let" -> variable(element, "value", scope);
      case "push_ros_namespace" -> scope.namespace = namespace(element, scope);
      case "set_remap" -> scope.remaps.addAll(0, remaps(element, List.of(element), scope));
      case "group" -> group(element, scope, depth);
      case "include" -> include(element, scope, depth);
      case "node" -> node(element, scope);
      case "set_parameter", "set_parameters_from_file" ->
          scope.parameters.addAll(parameters(scope).ofAll(element));
      default -> {
        if (!WITHOUT_NODES.contains(element.kind())) {
          String reason = known(element, "text").orElse("'" + element.kind() + "' is not read");
          ask(element, "Which nodes does this launch: " + reason + "?");
        }
      }
    }
  }

  private void group(LaunchElement element, Scope scope, int depth) {
    if (!text(element, "forwarding", scope).orElse("true").equalsIgnoreCase("true")) {
      ask(element, "What does this group get of what is set around it? It is taken to get all.");
    }
    Scope inner = isScoped(element, scope) ? scope.inner() : scope;
    element.children().forEach(child -> element(child, inner, depth));
  }

  private void argument(LaunchElement element, String value, Scope scope) {
    if (!known(element, "name").filter(scope.variables::containsKey).isPresent()) {
      variable(element, value, scope);
    }
  }

  /** Sets a variable, also to what is not known: then it has no longer its earlier value. */
  private void variable(LaunchElement element, String attribute, Scope scope) {
    String value = path(element, attribute, scope).orElse(UNKNOWN);
    known(element, "name").ifPresent(name -> scope.variables.put(name, value));
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
    Optional<String> file =
        path(element, "file", scope)
            .flatMap(it -> located(it, element.file()))
            .filter(sources.files()::containsKey);
    if (file.isEmpty() || depth > DEEPEST) {
      ask(element, "Which nodes does the included launch file start? It is not in the workspace.");
      return;
    }
    included.add(file.get());
    Scope inner = scope.included();
    if (element.children("arg").stream().anyMatch(it -> known(it, "name").isEmpty())) {
      ask(
          element,
          "Which arguments does this give the included launch file? It is taken to give none.");
    }
    element.children("arg").forEach(child -> variable(child, "value", inner));
    element.children("let").forEach(child -> variable(child, "value", inner));
    file(file.get(), inner, depth + 1);
  }

  /** Returns the name in the workspace of a file that launch names. */
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
    return found;
  }

  private LaunchParameters parameters(Scope scope) {
    return new LaunchParameters(
        text -> text(text, scope).filter(LaunchRun::isComplete),
        element -> {
          String attribute = element.attributes().containsKey("from") ? "from" : "filename";
          return path(element, attribute, scope)
              .flatMap(it -> located(it, element.file()))
              .flatMap(sources.texts());
        },
        questions);
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
    Optional<String> namespace = namespace(element, scope);
    started.add(
        new Started(
            owner.get(),
            executable.get(),
            name,
            unknown,
            namespace,
            remaps,
            parameters(element, scope, name, namespace),
            element.file(),
            element.line()));
    arguments(element, owner.get(), scope);
  }

  /** Returns what is assigned to the parameters of a node: to all nodes, then to itself. */
  private List<ParameterAssignment> parameters(
      LaunchElement element, Scope scope, Optional<String> name, Optional<String> namespace) {
    boolean isNamed =
        name.isPresent()
            && (element.attributes().containsKey("namespace")
                || !namespace.equals(Optional.of("/")));
    String nodes =
        isNamed
            ? namespace.map(it -> TopicNames.join(it, name.get())).orElse(ParameterAssignment.ALL)
            : ParameterAssignment.ALL;
    List<ParameterAssignment> all = new ArrayList<>(scope.parameters);
    all.addAll(parameters(scope).of(element, nodes));
    if (mayAssign(element, scope)) {
      all.add(ParameterAssignment.unknown());
    }
    return all;
  }

  /** Returns whether the arguments of a node may give it parameters. */
  private static boolean mayAssign(LaunchElement element, Scope scope) {
    return ARGUMENTS.stream()
        .filter(element.attributes()::containsKey)
        .map(attribute -> text(element, attribute, scope))
        .anyMatch(it -> it.isEmpty() || ASSIGNS.matcher(it.get()).find());
  }

  /** Asks about arguments of a node of the workspace, which a host does not give it. */
  private void arguments(LaunchElement element, String owner, Scope scope) {
    for (String attribute : ARGUMENTS) {
      Optional<String> given = text(element, attribute, scope);
      boolean isPlain = given.filter(it -> WITHOUT_EFFECT.matcher(it).matches()).isPresent();
      if (element.attributes().containsKey(attribute)
          && !isPlain
          && sources.packages().containsKey(owner)) {
        String which = given.map(it -> " '" + it.strip() + "'").orElse("");
        ask(element, "What do the arguments" + which + " change of this node? It gets none.");
      }
    }
  }

  /** Returns whether a group keeps what it changes, which it does unless it says otherwise. */
  private boolean isScoped(LaunchElement element, Scope scope) {
    if (!element.attributes().containsKey("scoped")) {
      return true;
    }
    Optional<String> scoped = text(element, "scoped", scope);
    if (scoped.filter(it -> it.matches("(?i:true|false)")).isEmpty()) {
      ask(element, "Does this group keep its namespace, remappings and parameters to itself?");
    }
    return scoped.filter(it -> it.equalsIgnoreCase("false")).isEmpty();
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
    return path(element, attribute, scope).filter(LaunchRun::isComplete);
  }

  private static boolean isComplete(String text) {
    return !text.contains("$(");
  }

  /** Returns the value of an attribute likewise, which may begin with the folder of a package. */
  private static Optional<String> path(LaunchElement element, String attribute, Scope scope) {
    return known(element, attribute).flatMap(written -> text(written, scope));
  }

  private static Optional<String> text(String written, Scope scope) {
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
    return Optional.of(found.appendTail(text).toString());
  }

  private void ask(LaunchElement element, String text) {
    questions.add(new OpenQuestion(text, element.file(), element.line()));
  }
}
