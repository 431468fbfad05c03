package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.SoftwareBaseNames;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * The files of a software base that describe software which exists: signals, components that are
 * nodes, the definitions of their messages, and the questions that are open.
 */
public final class SoftwareBaseFiles {

  /** The folder of nodes that are hosted as they are. */
  static final String NODES = "nodes/";

  private final MessageCatalog messages;
  private final MessageFields fields;
  private final List<OpenQuestion> questions;
  private final SortedMap<String, String> files = new TreeMap<>();

  private SoftwareBaseFiles(MessageCatalog messages, List<OpenQuestion> questions) {
    this.messages = messages;
    this.fields = new MessageFields(messages);
    this.questions = new ArrayList<>(questions);
  }

  /**
   * Returns the texts of the files, by their paths in the software base.
   *
   * @param messages the definitions of the types that the software uses
   */
  public static SortedMap<String, String> of(FoundSoftware software, MessageCatalog messages) {
    SoftwareBaseFiles files = new SoftwareBaseFiles(messages, software.questions());
    software.sources().forEach((name, text) -> files.files.put(NODES + name, text));
    files.keepImported(List.copyOf(software.sources().values()));
    return files.write(software.nodes());
  }

  private SortedMap<String, String> write(List<FoundNode> found) {
    List<DescribedNode> nodes = new ArrayList<>();
    List<String> names = ComponentNames.of(found);
    for (int i = 0; i < found.size(); i++) {
      FoundNode node = found.get(i);
      List<DescribedEndpoint> endpoints = endpoints(node);
      if (endpoints.isEmpty()) {
        ask("What does %s read and write? No topic of it is known.".formatted(node.name()), node);
      } else {
        nodes.add(new DescribedNode(names.get(i), node, endpoints));
      }
    }
    List<DescribedNode> components = nodes.stream().filter(this::isOfAChain).toList();
    components.forEach(this::askAbout);
    files.put(SoftwareBaseNames.COMPONENTS, components(components));
    files.put(SoftwareBaseNames.SIGNALS, SignalsJson.of(nodes, components));
    files.put(SoftwareBaseNames.QUESTIONS, text(questions));
    return files;
  }

  /** Returns whether a node has inputs and outputs, or may have: others begin or end a chain. */
  private boolean isOfAChain(DescribedNode node) {
    boolean reads = node.endpoints().stream().anyMatch(each -> !each.isOutput());
    boolean writes = node.endpoints().stream().anyMatch(DescribedEndpoint::isOutput);
    boolean isKnown =
        node.node().isComplete()
            && node.node().endpoints().stream().allMatch(each -> isDefined(each.type()));
    if ((reads && writes) || !isKnown) {
      return true;
    }
    ask(
        "Is %s a part of the vehicle? It %s, and is left out of the chain."
            .formatted(node.node().name(), reads ? "only reads" : "only writes"),
        node.node());
    return false;
  }

  /** Returns whether there is a definition of a type, without asking for it again. */
  private boolean isDefined(String type) {
    return found(type).isPresent();
  }

  private String components(List<DescribedNode> nodes) {
    ArrayNode json = JsonNodeFactory.instance.arrayNode();
    FlowOrder.of(nodes).forEach(node -> json.add(node.json(hosted(node.node()))));
    return JsonLayout.of(json) + "\n";
  }

  /** Returns the class of a node whose sources are there. */
  private Optional<PythonNode> hosted(FoundNode node) {
    return node.python().filter(it -> files.containsKey(NODES + it.file()));
  }

  /** Returns the endpoints whose types are known; those with equal topic and type are one. */
  private List<DescribedEndpoint> endpoints(FoundNode node) {
    List<DescribedEndpoint> all = new ArrayList<>();
    for (FoundEndpoint endpoint : node.endpoints()) {
      Optional<MessageType> type = type(endpoint);
      List<MessageFields.Leaf> used = type.map(it -> used(node, endpoint, it)).orElse(List.of());
      if (!used.isEmpty()) {
        DescribedEndpoint.add(endpoint, used, all);
      }
    }
    return all;
  }

  /**
   * Returns the fields that a node uses, as far as that is known; none of a type without fields.
   * Where only the arrival of a message matters, its first field stands for it.
   */
  private List<MessageFields.Leaf> used(FoundNode node, FoundEndpoint endpoint, MessageType type) {
    List<MessageFields.Leaf> all = fields.all(type);
    Optional<List<MessageFields.Leaf>> used =
        endpoint.fields().flatMap(paths -> fields.of(type, paths));
    if (all.isEmpty()) {
      ask(
          "%s on %s has no fields, so that no chain has it. Does it matter to %s?"
              .formatted(endpoint.type(), endpoint.topic(), node.name()),
          endpoint.file(),
          endpoint.line());
    } else if (used.isEmpty() && all.size() > 1) {
      ask(
          "Which fields of %s on %s does %s use? All are taken."
              .formatted(endpoint.type(), endpoint.topic(), node.name()),
          endpoint.file(),
          endpoint.line());
    } else if (used.filter(List::isEmpty).isPresent()) {
      ask(
          "Which fields of %s on %s does %s use? None was found, and '%s' stands for its messages."
              .formatted(endpoint.type(), endpoint.topic(), node.name(), all.get(0).path()),
          endpoint.file(),
          endpoint.line());
      return List.of(all.get(0));
    }
    return used.orElse(all);
  }

  private Optional<MessageType> type(FoundEndpoint endpoint) {
    String problem = "There is no such definition";
    try {
      Optional<MessageType> type = messages.find(endpoint.type());
      if (type.isPresent()) {
        keep(type.get());
        return type;
      }
    } catch (DiagnosticException e) {
      problem = e.diagnostics().get(0).message().replaceFirst("\\.$", "");
    }
    ask(
        ("What is %s, the type of %s? %s; add its package to the workspace and import that again, or put it"
                + " into software-base/msg, and the topic into components.json.")
            .formatted(endpoint.type(), endpoint.topic(), problem),
        endpoint.file(),
        endpoint.line());
    return Optional.empty();
  }

  /** Adds the definitions of messages and services that modules import, on topics or not. */
  private void keepImported(List<String> sources) {
    for (String name : messages.ownNames()) {
      if (isImported(name, sources)) {
        found(name).ifPresent(this::keep);
      }
    }
    messages
        .services()
        .forEach(
            (name, file) -> {
              if (isImported(name, sources)) {
                String path = SoftwareBaseNames.MESSAGES + "/" + name + ".srv";
                files.put(path, SourceText.read(file).text());
                found(name + "_Request").ifPresent(this::keepUsed);
                found(name + "_Response").ifPresent(this::keepUsed);
              }
            });
  }

  /** Returns whether a module names a package and one of its types. */
  private static boolean isImported(String type, List<String> sources) {
    String[] parts = type.split("/", 3);
    Pattern word = Pattern.compile("\\b" + Pattern.quote(parts[2]) + "\\b");
    return sources.stream()
        .filter(text -> text.contains(parts[0] + "." + parts[1]))
        .anyMatch(text -> word.matcher(text).find());
  }

  /** Returns a type; empty where its definition is not valid, which the software's run reports. */
  private Optional<MessageType> found(String type) {
    try {
      return messages.find(type);
    } catch (DiagnosticException e) {
      return Optional.empty();
    }
  }

  /** Adds the definition of a type of the workspace, and those that it uses. */
  private void keep(MessageType type) {
    Optional<Path> file = messages.file(type.name());
    if (file.isPresent()) {
      String name = file.get().getFileName().toString();
      String ending = name.substring(name.lastIndexOf('.'));
      files.put(
          SoftwareBaseNames.MESSAGES + "/" + type.name() + ending,
          SourceText.read(file.get()).text());
    }
    keepUsed(type);
  }

  private void keepUsed(MessageType type) {
    type.fields().forEach(field -> field.type().message().ifPresent(this::keep));
  }

  private void askAbout(DescribedNode node) {
    long inputs = node.endpoints().stream().filter(each -> !each.isOutput()).count();
    long outputs = node.endpoints().size() - inputs;
    if (inputs * outputs > 1) {
      ask(
          "Which input of %s causes which output? Each is taken to cause each."
              .formatted(node.component()),
          node.node());
    }
    if (node.node().frequency().isEmpty()) {
      ask(
          "How often does %s act? No timer says so, and its frequency is that of eventchain.yaml."
              .formatted(node.component()),
          node.node());
    }
  }

  private void ask(String text, FoundNode node) {
    ask(text, node.file(), node.line());
  }

  private void ask(String text, String file, int line) {
    OpenQuestion question = new OpenQuestion(text, file, line);
    if (!questions.contains(question)) {
      questions.add(question);
    }
  }

  /** Returns the text of {@code questions.json}. */
  static String text(List<OpenQuestion> questions) {
    ArrayNode json = JsonNodeFactory.instance.arrayNode();
    for (OpenQuestion question : questions) {
      ObjectNode entry = json.addObject().put("question", question.text());
      entry.put("file", question.file());
      if (question.line() > 0) {
        entry.put("line", question.line());
      }
    }
    return JsonLayout.of(json) + "\n";
  }
}
