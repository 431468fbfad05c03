package dev.eventchain.workspace.launch;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** Nodes that a launch file starts without arguments, in its order. */
public final class LaunchRun {

  /** For runs whose questions are those of another one. */
  private static final Questions NONE = (text, file, line) -> {};

  private static final int DEEPEST = 20;
  private static final int MOST_INCLUDES = 2_000;

  /** Elements of a container that are no nodes. */
  private static final Set<String> CONTAINED = Set.of("param", "remap", "env");

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
  public record Started(
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
   * A timer or an event handler, whose nodes are started later.
   *
   * @param nodes those that it starts in the scope in which it stands
   */
  private record Later(LaunchElement element, List<Started> nodes, int depth) {}

  private final LaunchSources sources;
  private final Questions questions;
  private final List<Started> started = new ArrayList<>();
  private final List<Later> later = new ArrayList<>();

  /** Groups that may leave remappings or parameters behind for nodes that are started later. */
  private final List<LaunchElement> leaking = new ArrayList<>();

  /** Questions about each element, which a file that is included twice has twice. */
  private final IdentityHashMap<LaunchElement, Set<String>> asked = new IdentityHashMap<>();

  private final Set<String> included = new TreeSet<>();
  private final boolean isWhole;
  private int includes;

  /**
   * Creates a run.
   *
   * @param isWhole whether what conditions exclude is followed, too
   */
  private LaunchRun(LaunchSources sources, Questions questions, boolean isWhole) {
    this.sources = sources;
    this.questions = questions;
    this.isWhole = isWhole;
  }

  /**
   * Returns the nodes that a file starts.
   *
   * @param questions receives what is not known
   */
  public static List<Started> of(String file, LaunchSources sources, Questions questions) {
    LaunchRun run = new LaunchRun(sources, questions, false);
    LaunchScope scope = new LaunchScope();
    run.file(file, scope, 0);
    run.later.forEach(each -> run.askAbout(each, scope));
    return run.started;
  }

  /** Returns the files that no other file includes. */
  public static List<String> roots(LaunchSources sources) {
    LaunchSources unread =
        new LaunchSources(sources.files(), sources.packages(), name -> Optional.empty());
    Set<String> included = new TreeSet<>();
    for (String file : sources.files().keySet()) {
      for (boolean isWhole : List.of(true, false)) {
        LaunchRun run = new LaunchRun(unread, NONE, isWhole);
        run.file(file, new LaunchScope(), 0);
        run.included.remove(file);
        included.addAll(run.included);
      }
    }
    return sources.files().keySet().stream().filter(it -> !included.contains(it)).toList();
  }

  private void file(String file, LaunchScope scope, int depth) {
    for (LaunchElement element : sources.files().getOrDefault(file, List.of())) {
      element(element, scope, depth);
    }
  }

  private void element(LaunchElement element, LaunchScope scope, int depth) {
    Optional<Boolean> condition = LaunchCondition.holds(element, it -> scope.text(element, it));
    if (condition.isEmpty() && !element.kind().equals("arg")) {
      ask(element, "Is this launched? It is under a condition, and taken as launched.");
    }
    if (isWhole || condition.orElse(true)) {
      launched(element, scope, depth, condition.isPresent());
    }
  }

  private void launched(LaunchElement element, LaunchScope scope, int depth, boolean isSure) {
    switch (element.kind()) {
      case "arg" -> argument(element, isSure ? "default" : "", scope);
      case "let", "keep" -> variable(element, isSure ? "value" : "", scope);
      case "unset" -> element.known("name").ifPresent(scope::unset);
      case "push_ros_namespace" -> scope.namespace = namespace(element, scope);
      case "set_remap" -> scope.remaps.addAll(remaps(element, List.of(element), scope));
      case "group" -> group(element, scope, depth);
      case "timer", "ros_timer", "event_handler" -> later(element, scope, depth);
      case "include" -> include(element, scope, depth);
      case "node" -> node(element, "exec", scope);
      case "node_container", "load_composable_node" -> container(element, scope, depth);
      case "composable_node" -> node(element, "plugin", scope);
      case "set_parameter", "set_parameters_from_file" ->
          scope.assign(parameters(scope).ofAll(element), isSure);
      default -> {
        if (!WITHOUT_NODES.contains(element.kind())) {
          String reason = element.known("text").orElse("'" + element.kind() + "' is not read");
          ask(element, "Which nodes does this launch: " + reason + "?");
        }
      }
    }
  }

  private void group(LaunchElement element, LaunchScope scope, int depth) {
    if (!scope.text(element, "forwarding").orElse("true").equalsIgnoreCase("true")) {
      ask(element, "What does this group get of what is set around it? It is taken to get all.");
    }
    LaunchScope inner = isScoped(element, scope) ? scope.inner() : scope;
    List<LaunchElement> children = new ArrayList<>(element.children("keep"));
    element.children().stream().filter(it -> !it.kind().equals("keep")).forEach(children::add);
    children.forEach(child -> element(child, inner, depth));
    if (inner != scope && inner.addsTo(scope)) {
      leaking.add(element);
    }
  }

  /** Launches the nodes that are loaded into a container, which has no topics of its own. */
  private void container(LaunchElement element, LaunchScope scope, int depth) {
    boolean isUsual = scope.text(element, "pkg").equals(Optional.of("rclcpp_components"));
    if (element.kind().equals("node_container") && !isUsual) {
      node(element, "exec", scope);
    }
    element.children().stream()
        .filter(child -> !CONTAINED.contains(child.kind()))
        .forEach(child -> element(child, scope, depth));
  }

  /** Launches what starts later, as if it did so at once, in a scope of its own. */
  private void later(LaunchElement element, LaunchScope scope, int depth) {
    int first = started.size();
    LaunchScope inner = scope.inner();
    element.children().forEach(child -> element(child, inner, depth));
    List<Started> nodes = List.copyOf(started.subList(first, started.size()));
    later.add(new Later(element, nodes, depth));
  }

  /** Asks about what starts other nodes in the scope that is left at the end, or may not start. */
  private void askAbout(Later each, LaunchScope end) {
    LaunchElement element = each.element();
    if (!each.nodes().isEmpty() && element.kind().equals("event_handler")) {
      askAboutEvent(element);
    }
    LaunchRun run = new LaunchRun(sources, NONE, isWhole);
    LaunchScope scope = end.inner();
    element.children().forEach(child -> run.element(child, scope, each.depth()));
    if (!run.started.equals(each.nodes())) {
      String what =
          element.kind().equals("event_handler")
              ? "event handler get? Those where it stands are taken; ROS 2 may take those that are"
                  + " left when the event comes."
              : "timer get? Those where it stands are taken, as newer versions of ROS 2 do; older"
                  + " ones take those that are left when it fires.";
      ask(
          element,
          "Which arguments, namespace, remappings and parameters do the nodes of this " + what);
    }
  }

  /** Asks about an event that is not the start of a node that is started. */
  private void askAboutEvent(LaunchElement element) {
    Optional<String> target = element.known("target");
    boolean comes =
        started.stream()
            .filter(node -> element.known("event").equals(Optional.of("start")))
            .filter(node -> node.file().equals(element.file()))
            .anyMatch(node -> target.equals(Optional.of(String.valueOf(node.line()))));
    if (!comes) {
      ask(
          element,
          "Is this launched? It waits for an event of another process, and is taken as launched.");
    }
  }

  private void argument(LaunchElement element, String value, LaunchScope scope) {
    if (!element.known("name").filter(scope::isSet).isPresent()) {
      variable(element, value, scope);
    }
  }

  private void variable(LaunchElement element, String attribute, LaunchScope scope) {
    Optional<String> value = scope.path(element, attribute);
    element.known("name").ifPresent(name -> scope.set(name, value));
  }

  private Optional<String> namespace(LaunchElement element, LaunchScope scope) {
    if (!element.attributes().containsKey("namespace")) {
      return scope.namespace;
    }
    Optional<String> given = scope.text(element, "namespace");
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

  private void include(LaunchElement element, LaunchScope scope, int depth) {
    Optional<String> file =
        scope
            .path(element, "file")
            .flatMap(it -> sources.located(it, element.file()))
            .filter(sources.files()::containsKey);
    if (file.isEmpty() || depth > DEEPEST || ++includes > MOST_INCLUDES) {
      ask(
          element,
          "Which nodes does the included launch file start? "
              + (file.isEmpty()
                  ? "It is not in the workspace."
                  : "Files include each other too deeply or too often."));
      return;
    }
    included.add(file.get());
    if (element.children("arg").stream().anyMatch(it -> it.known("name").isEmpty())) {
      ask(
          element,
          "Which arguments does this give the included launch file? It is taken to give none.");
    }
    element.children("arg").forEach(child -> variable(child, "value", scope));
    element.children("let").forEach(child -> variable(child, "value", scope));
    file(file.get(), scope, depth + 1);
  }

  private LaunchParameters parameters(LaunchScope scope) {
    return new LaunchParameters(
        text -> scope.text(text).filter(LaunchScope::isComplete),
        element -> {
          String attribute = element.attributes().containsKey("from") ? "from" : "filename";
          return scope
              .path(element, attribute)
              .flatMap(it -> sources.located(it, element.file()))
              .flatMap(sources.texts());
        },
        questions);
  }

  /**
   * Starts a node.
   *
   * @param program the attribute that names its executable, or its class in a library
   */
  private void node(LaunchElement element, String program, LaunchScope scope) {
    Optional<String> owner = scope.text(element, "pkg");
    Optional<String> executable = scope.text(element, program);
    if (owner.isEmpty() || executable.isEmpty()) {
      ask(element, "Which executable of which package is this?");
      return;
    }
    Optional<String> name = scope.text(element, "name");
    boolean unknown = isNameUnknown(element, name);
    List<TopicNames.Remap> remaps = new ArrayList<>(scope.remaps);
    remaps.addAll(remaps(element, element.children("remap"), scope));
    askAboutLeaking();
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
    if (sources.packages().containsKey(owner.get())) {
      parameters(scope).askAboutArguments(element, scope);
    }
  }

  /** Returns whether a node is given a name that is not known, for which it asks. */
  private boolean isNameUnknown(LaunchElement element, Optional<String> name) {
    boolean unknown = element.attributes().containsKey("name") && name.isEmpty();
    if (unknown) {
      ask(element, "What is the name of this node?");
    }
    return unknown;
  }

  /** Asks about groups that stand before a node: there is one list of what is set for all nodes. */
  private void askAboutLeaking() {
    leaking.forEach(
        group ->
            ask(
                group,
                "Does what this group sets for all of its nodes end with it? It is taken to; but"
                    + " ROS 2 adds remappings and parameters to what is set around the group."));
    leaking.clear();
  }

  /** Returns what is assigned to the parameters of a node: to all nodes, then to itself. */
  private List<ParameterAssignment> parameters(
      LaunchElement element, LaunchScope scope, Optional<String> name, Optional<String> namespace) {
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
    if (LaunchParameters.mayAssign(element, scope)) {
      all.add(ParameterAssignment.unknown());
    }
    return all;
  }

  /** Returns whether a group keeps what it changes, which it does unless it says otherwise. */
  private boolean isScoped(LaunchElement element, LaunchScope scope) {
    if (!element.attributes().containsKey("scoped")) {
      return true;
    }
    Optional<String> scoped = scope.text(element, "scoped");
    if (scoped.filter(it -> it.matches("(?i:true|false)")).isEmpty()) {
      ask(element, "Does this group keep its namespace, remappings and parameters to itself?");
    }
    return scoped.filter(it -> it.equalsIgnoreCase("false")).isEmpty();
  }

  private List<TopicNames.Remap> remaps(
      LaunchElement owner, List<LaunchElement> elements, LaunchScope scope) {
    List<TopicNames.Remap> found = new ArrayList<>();
    for (LaunchElement remap : elements) {
      LaunchElement pair = remap.children("remap").stream().findFirst().orElse(remap);
      Optional<String> from = scope.text(pair, "from");
      Optional<String> to = scope.text(pair, "to");
      if (from.isPresent() && to.isPresent()) {
        found.add(new TopicNames.Remap(from.get(), to.get()));
      } else {
        ask(owner, "Which name is remapped to which?");
      }
    }
    return found;
  }

  private void ask(LaunchElement element, String text) {
    if (asked.computeIfAbsent(element, it -> new HashSet<>()).add(text)) {
      questions.add(text, element.file(), element.line());
    }
  }
}
