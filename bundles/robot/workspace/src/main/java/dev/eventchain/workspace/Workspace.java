package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.messages.RosFolder;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.workspace.launch.LaunchElement;
import dev.eventchain.workspace.launch.LaunchRules;
import dev.eventchain.workspace.launch.LaunchRun;
import dev.eventchain.workspace.launch.LaunchSources;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Reader of a workspace of ROS 2: its nodes in Python, those in C++ as far as their tokens go, and
 * how a launch file starts them. Nothing of the workspace is run or imported.
 */
public final class Workspace {

  private final Path root;
  private final List<OpenQuestion> questions = new ArrayList<>();

  private Workspace(Path root) {
    this.root = root;
  }

  /**
   * Reads a workspace.
   *
   * @param launch the launch file that starts the software, in the workspace; by default the only
   *     one that no other one includes
   * @throws DiagnosticException INPUT if it cannot be read ({@code file.unreadable}, {@code
   *     workspace.unread}), has no package ({@code workspace.empty}), or not that launch file
   *     ({@code workspace.launch})
   */
  public static FoundSoftware read(
      Path root, Optional<Path> launch, PythonEnvironment environment) {
    return new Workspace(root).read(launch, environment);
  }

  private FoundSoftware read(Optional<Path> launch, PythonEnvironment environment) {
    RosFolder folder = list();
    if (folder.packages().isEmpty()) {
      throw refused(
          WorkspaceRules.EMPTY,
          "There is no package of ROS 2 here: no folder has a package.xml with a name.",
          "Name the folder of a colcon workspace, or one of packages.");
    }
    WorkspaceFiles files = WorkspaceFiles.read(root, folder, questions);
    ObjectNode request = files.request();
    JsonNode facts = SourceReader.read(environment, root, request);
    facts.path("questions").forEach(each -> questions.add(OpenQuestion.of(each)));
    LaunchSources sources =
        new LaunchSources(launchFiles(files, facts), folders(files, folder), files::named);
    Optional<String> start = launch.map(file -> named(file, sources)).or(() -> only(sources));
    StartedNodes nodes =
        new StartedNodes(
            facts,
            sources.packages().keySet(),
            again -> SourceReader.read(environment, root, request.set("again", again)),
            questions);
    List<FoundNode> found =
        start.map(file -> started(file, nodes, sources)).orElseGet(nodes::alone);
    return new FoundSoftware(found, files.modules(found), List.copyOf(questions));
  }

  /** Returns the nodes that a launch file starts; all, if none of these is known. */
  private List<FoundNode> started(String file, StartedNodes nodes, LaunchSources sources) {
    List<FoundNode> found = nodes.launched(LaunchRun.of(file, sources, this::ask));
    if (found.isEmpty()) {
      String text =
          "Which nodes are a part of the software? This file starts none that is known: each is"
              + " taken once, under its own name.";
      ask(text, file, 0);
      return nodes.alone();
    }
    nodes.askAboutOthers(file);
    return found;
  }

  private void ask(String text, String file, int line) {
    questions.add(new OpenQuestion(text, file, line));
  }

  private RosFolder list() {
    try {
      return RosFolder.list(root);
    } catch (IOException e) {
      throw FileRules.refusal("The workspace", root, e);
    }
  }

  private DiagnosticException refused(Rule rule, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, SourceLocation.of(root)).withHint(hint));
  }

  private static Map<String, String> folders(WorkspaceFiles files, RosFolder folder) {
    Map<String, String> found = new TreeMap<>();
    folder.packages().values().forEach(it -> found.put(it.name(), files.name(it.folder())));
    return found;
  }

  private Map<String, List<LaunchElement>> launchFiles(WorkspaceFiles files, JsonNode facts) {
    Map<String, List<LaunchElement>> found = new TreeMap<>();
    facts
        .path("launch")
        .properties()
        .forEach(
            each -> found.put(each.getKey(), LaunchElement.of(each.getKey(), each.getValue())));
    files
        .declared()
        .forEach(
            (name, text) -> {
              try {
                found.put(name, declared(name, text));
              } catch (DiagnosticException e) {
                Diagnostic problem = e.diagnostics().get(0);
                ask(
                    "What does this file launch? It is not read: " + problem.message(),
                    name,
                    problem.location().line());
              }
            });
    return found;
  }

  private static List<LaunchElement> declared(String name, SourceText text) {
    if (name.endsWith(".xml")) {
      return LaunchElement.of(name, XmlElement.parse(text, LaunchRules.LAUNCH));
    }
    DocumentRules rules = DocumentRules.all(LaunchRules.LAUNCH);
    List<Diagnostic> problems = new ArrayList<>();
    Document yaml = Document.parse(text, DocumentFormat.YAML, rules, problems::add);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return LaunchElement.of(name, yaml);
  }

  /** Returns the name of a launch file that was asked for. */
  private String named(Path file, LaunchSources sources) {
    List<String> names = new ArrayList<>(List.of(file.toString().replace('\\', '/')));
    if (file.toAbsolutePath().normalize().startsWith(root.toAbsolutePath().normalize())) {
      names.add(
          root.toAbsolutePath()
              .normalize()
              .relativize(file.toAbsolutePath().normalize())
              .toString());
    }
    return names.stream()
        .filter(sources.files()::containsKey)
        .findFirst()
        .orElseThrow(
            () ->
                refused(
                    LaunchRules.LAUNCH,
                    "No launch file that can be read is called " + file + " in the workspace.",
                    "It has " + String.join(", ", sources.files().keySet()) + "."));
  }

  /** Returns the only launch file that no other one includes; several are asked for. */
  private Optional<String> only(LaunchSources sources) {
    List<String> roots = LaunchRun.roots(sources);
    if (roots.size() > 1) {
      String text =
          "Which launch file starts the software: %s? Without one, each node is taken once, under"
                  .formatted(String.join(", ", roots))
              + " its own name; --launch FILE names one.";
      ask(text, roots.get(0), 0);
    }
    return roots.size() == 1 ? Optional.of(roots.get(0)) : Optional.empty();
  }
}
