package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.RosFolder;
import dev.eventchain.messages.RosPackage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;

/** The files of a workspace that say something about its nodes, as texts. */
final class WorkspaceFiles {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final long LONGEST = 1L << 20;
  private static final long MOST = 64L << 20;
  private static final Pattern LAUNCH = Pattern.compile("(.*[._])?launch\\.(py|xml|ya?ml)");
  private static final Pattern CPP = Pattern.compile(".*\\.(cpp|cc|cxx|hpp|h|hxx)");

  private final Path root;
  private final RosFolder folder;
  private final List<OpenQuestion> questions;
  private final Map<String, SourceText> declared = new TreeMap<>();
  private final Map<String, Optional<SourceText>> named = new TreeMap<>();
  private final ArrayNode packages = JSON.createArrayNode();
  private long read;

  private WorkspaceFiles(Path root, RosFolder folder, List<OpenQuestion> questions) {
    this.root = root;
    this.folder = folder;
    this.questions = questions;
  }

  /**
   * Reads the files.
   *
   * @param questions receives what cannot be read
   */
  static WorkspaceFiles read(Path root, RosFolder folder, List<OpenQuestion> questions) {
    WorkspaceFiles files = new WorkspaceFiles(root, folder, questions);
    folder.packages().values().forEach(files::add);
    folder.files().stream()
        .filter(file -> file.endsWith(RosPackage.MANIFEST) && folder.packageOf(file).isEmpty())
        .forEach(files::askForPackage);
    return files;
  }

  /** Asks for a package of which the name is unknown, so that nothing of it is read. */
  private void askForPackage(Path manifest) {
    String text =
        "What is the name of this package? None can be read here that ROS 2 allows, and nothing of"
            + " the package is read.";
    questions.add(new OpenQuestion(text, name(manifest), 0));
  }

  /** Returns the request to the reader of sources. */
  ObjectNode request() {
    ObjectNode request = JSON.createObjectNode();
    request.set("packages", packages);
    return request;
  }

  /**
   * Returns the modules of Python packages, and those beside nodes that are in none, by their files
   * below the folder of the packages.
   */
  SortedMap<String, String> modules(List<FoundNode> nodes) {
    Set<String> folders = new TreeSet<>();
    nodes.forEach(node -> node.python().ifPresent(it -> folders.add(folder(it.file()))));
    SortedMap<String, String> all = new TreeMap<>();
    for (JsonNode each : packages) {
      for (JsonNode module : each.path("python")) {
        all.putIfAbsent(
            PythonNode.file(module.path("module").asText()), module.path("text").asText());
      }
    }
    SortedMap<String, String> modules = new TreeMap<>(all);
    modules
        .keySet()
        .removeIf(
            file ->
                !all.containsKey(file.replaceFirst("/.*", "") + "/__init__.py")
                    && !folders.contains(folder(file)));
    return modules;
  }

  private static String folder(String file) {
    return file.replaceFirst("[^/]*$", "");
  }

  /** Returns the launch files in XML and YAML, by their names. */
  Map<String, SourceText> declared() {
    return declared;
  }

  /** Returns the text of a file of a package by its name; empty if there is none that is read. */
  Optional<SourceText> named(String name) {
    Path file = root.resolve(name).normalize();
    return named.computeIfAbsent(
        name, it -> folder.files().contains(file) ? text(file) : Optional.empty());
  }

  /** Returns a file's name relative to the workspace. */
  String name(Path file) {
    return root.relativize(file).toString().replace('\\', '/');
  }

  private void add(RosPackage owner) {
    ObjectNode json = packages.addObject().put("name", owner.name());
    for (String part : List.of("python", "setup", "cpp", "cmake", "launch")) {
      json.putObject(part);
    }
    for (Path file : folder.files().tailSet(owner.folder())) {
      if (!file.startsWith(owner.folder())) {
        break;
      }
      add(owner, file, json);
    }
  }

  private void add(RosPackage owner, Path file, ObjectNode json) {
    String simple = file.getFileName().toString();
    if (LAUNCH.matcher(simple).matches()) {
      Optional<SourceText> text = text(file);
      if (!simple.endsWith(".py")) {
        text.ifPresent(it -> declared.put(it.name(), it));
      } else {
        text.ifPresent(it -> module(json, "launch", it, ""));
      }
    } else if (simple.equals("setup.py") || simple.equals("setup.cfg")) {
      text(file).ifPresent(it -> put(json, "setup", it));
    } else if (simple.equals("CMakeLists.txt")) {
      text(file).ifPresent(it -> put(json, "cmake", it));
    } else if (CPP.matcher(simple).matches()) {
      text(file).ifPresent(it -> put(json, "cpp", it));
    } else if (simple.endsWith(".py")) {
      text(file).ifPresent(it -> module(json, "python", it, moduleOf(owner, file)));
    }
  }

  /**
   * Returns the name of a module. Several packages may have a folder {@code scripts}, so what is in
   * no Python package is named after the package of ROS.
   */
  private static String moduleOf(RosPackage owner, Path file) {
    Path path = owner.folder().relativize(file);
    String name = path.toString().replaceFirst("\\.py$", "").replace('\\', '/').replace('/', '.');
    boolean packaged =
        Files.isRegularFile(owner.folder().resolve(path.getName(0)).resolve("__init__.py"));
    return packaged ? name : owner.name() + "." + name;
  }

  private static void put(ObjectNode json, String part, SourceText text) {
    json.withObject("/" + part).put(text.name(), text.text());
  }

  private static void module(ObjectNode json, String part, SourceText text, String name) {
    json.withObject("/" + part).putObject(text.name()).put("module", name).put("text", text.text());
  }

  /** Returns a file's text, under its name in the workspace; what is no text is asked for. */
  private Optional<SourceText> text(Path file) {
    String name = name(file);
    try {
      if (!file.toRealPath().startsWith(root.toRealPath())) {
        return unread(name, "It is a link that leads out of the workspace");
      }
      long size = Files.size(file);
      if (size > LONGEST || read + size > MOST) {
        return unread(name, "It, or all files together, are too large");
      }
      read += size;
      return Optional.of(SourceText.of(name, SourceText.read(file).text()));
    } catch (IOException e) {
      return unread(name, "It cannot be read: " + SourceText.reason(e));
    } catch (DiagnosticException e) {
      return unread(name, e.diagnostics().get(0).message().replaceFirst("\\.$", ""));
    }
  }

  private Optional<SourceText> unread(String name, String reason) {
    questions.add(
        new OpenQuestion("What does this file do? " + reason + ", and is not read.", name, 0));
    return Optional.empty();
  }
}
