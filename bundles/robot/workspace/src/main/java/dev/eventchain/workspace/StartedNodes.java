package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.workspace.launch.GivenParameters;
import dev.eventchain.workspace.launch.LaunchRun;
import dev.eventchain.workspace.launch.TopicNames;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.StreamSupport;

/** The nodes of the sources, under the names under which they are started. */
final class StartedNodes {

  private final JsonNode facts;
  private final Set<String> packages;
  private final Function<ArrayNode, JsonNode> reader;
  private final List<OpenQuestion> questions;
  private final Set<Integer> asked = new LinkedHashSet<>();

  /**
   * Creates it.
   *
   * @param facts what the reader of sources says
   * @param packages the names of the packages of the workspace
   * @param reader reads the sources again, with parameters of some nodes
   * @param questions receives what is not known
   */
  StartedNodes(
      JsonNode facts,
      Set<String> packages,
      Function<ArrayNode, JsonNode> reader,
      List<OpenQuestion> questions) {
    this.facts = facts;
    this.packages = packages;
    this.reader = reader;
    this.questions = questions;
  }

  /**
   * A node of a launch file.
   *
   * @param number that of its class, as it is made
   */
  private record Launched(
      int number, LaunchRun.Started started, Optional<String> name, GivenParameters parameters) {}

  /** Returns the numbers of the nodes of all executables. */
  private Set<Integer> executable() {
    Set<Integer> all = new LinkedHashSet<>();
    for (JsonNode executable : facts.path("executables")) {
      executable.path("nodes").forEach(number -> all.add(number.asInt()));
    }
    return all;
  }

  /** Asks about the nodes of executables that a launch file does not start. */
  void askAboutOthers(String launch) {
    Set<Integer> others = executable();
    others.removeAll(asked);
    if (!others.isEmpty()) {
      String names =
          others.stream()
              .map(number -> facts.path("nodes").path(number).path("class").asText())
              .distinct()
              .collect(Collectors.joining(", "));
      ask(
          "Are these nodes a part of the software: %s? This file starts none of them, and they are left out."
              .formatted(names),
          launch,
          0);
    }
  }

  /** Returns the nodes of all executables, each by itself. */
  List<FoundNode> alone() {
    List<FoundNode> found = new ArrayList<>();
    for (int number : executable()) {
      JsonNode node = facts.path("nodes").path(number);
      asked.add(number);
      TopicNames names = names(node, text(node, "name"), Optional.of("/"), List.of());
      found.add(node(node, names, GivenParameters.NONE));
    }
    return found;
  }

  /** Returns the nodes that a launch file starts. */
  List<FoundNode> launched(List<LaunchRun.Started> all) {
    List<Launched> launched = new ArrayList<>();
    for (LaunchRun.Started started : all) {
      List<Integer> numbers = nodesOf(started);
      if (numbers.isEmpty()) {
        ask(
            packages.contains(started.owner())
                ? "What does the node '%s' of %s read and write? Its source was not understood."
                    .formatted(started.executable(), started.owner())
                : "What does the node '%s' read and write? The package %s is not in the workspace."
                    .formatted(started.executable(), started.owner()),
            started.file(),
            started.line());
      }
      for (int number : numbers) {
        asked.add(number);
        launched.add(launched(number, started));
      }
    }
    List<JsonNode> read = withParameters(launched);
    List<FoundNode> found = new ArrayList<>();
    for (int i = 0; i < launched.size(); i++) {
      LaunchRun.Started started = launched.get(i).started();
      TopicNames names =
          names(read.get(i), launched.get(i).name(), started.namespace(), started.remaps());
      found.add(node(read.get(i), names, launched.get(i).parameters()));
    }
    return found;
  }

  private Launched launched(int number, LaunchRun.Started started) {
    JsonNode node = facts.path("nodes").path(number);
    Optional<String> name =
        started.isNameUnknown() ? Optional.empty() : started.name().or(() -> text(node, "name"));
    Optional<String> space = names(node, name, started.namespace(), List.of()).namespace();
    Optional<String> full = space.flatMap(it -> name.map(simple -> TopicNames.join(it, simple)));
    GivenParameters parameters =
        GivenParameters.of(
            started.parameters(), full, text -> ask(text, started.file(), started.line()));
    return new Launched(number, started, name, parameters);
  }

  /** Returns what is known of nodes, with the parameters on which it depends. */
  private List<JsonNode> withParameters(List<Launched> launched) {
    ArrayNode again = JsonNodeFactory.instance.arrayNode();
    List<JsonNode> found = new ArrayList<>();
    List<Integer> places = new ArrayList<>();
    for (Launched each : launched) {
      JsonNode node = facts.path("nodes").path(each.number());
      Set<String> read = new TreeSet<>();
      node.path("reads").forEach(name -> read.add(name.asText()));
      if (each.parameters().concerns(read)) {
        places.add(found.size());
        again.add(request(each));
      }
      found.add(node);
    }
    JsonNode nodes = again.isEmpty() ? again : reader.apply(again).path("again");
    for (int i = 0; i < places.size(); i++) {
      found.set(places.get(i), nodes.path(i));
    }
    return found;
  }

  private static ObjectNode request(Launched launched) {
    GivenParameters given = launched.parameters();
    ObjectNode request = JsonNodeFactory.instance.objectNode().put("node", launched.number());
    request.putObject("values").setAll(given.values());
    given.unknown().forEach(request.putArray("unknown")::add);
    return request.put("open", given.isOpen());
  }

  private List<Integer> nodesOf(LaunchRun.Started started) {
    List<Integer> found = new ArrayList<>();
    for (JsonNode executable : facts.path("executables")) {
      if (executable.path("package").asText().equals(started.owner())
          && executable.path("name").asText().equals(started.executable())) {
        executable.path("nodes").forEach(number -> found.add(number.asInt()));
      }
    }
    return found;
  }

  /** Returns the names of a node; a namespace of launch takes the place of its own. */
  private static TopicNames names(
      JsonNode node,
      Optional<String> name,
      Optional<String> launched,
      List<TopicNames.Remap> remaps) {
    String own = node.path("namespace").asText();
    Optional<String> namespace =
        launched
            .filter(space -> own.isEmpty() || !space.equals("/"))
            .or(() -> launched.map(space -> TopicNames.join(space, own)));
    return new TopicNames(namespace, name, remaps);
  }

  private FoundNode node(JsonNode node, TopicNames names, GivenParameters parameters) {
    node.path("questions").forEach(each -> ask(OpenQuestion.of(each)));
    List<FoundEndpoint> endpoints = new ArrayList<>();
    for (JsonNode endpoint : node.path("endpoints")) {
      endpoint(endpoint, names).ifPresent(endpoints::add);
    }
    String file = node.path("file").asText();
    int line = node.path("line").asInt();
    String simple = names.name().orElse(node.path("class").asText());
    return new FoundNode(
        TopicNames.join(names.namespace().orElse("/"), simple),
        node.path("description").asText(),
        frequency(node, simple),
        List.copyOf(endpoints),
        areTopicsKnown(node) && endpoints.size() == node.path("endpoints").size(),
        python(node, names, parameters),
        file,
        line);
  }

  /** Returns whether no question about a node is one about its topics. */
  private static boolean areTopicsKnown(JsonNode node) {
    return StreamSupport.stream(node.path("questions").spliterator(), false)
        .allMatch(each -> each.path("beside_topics").asBoolean());
  }

  /** Returns the class; only what differs from its own name and namespace is given to it. */
  private static Optional<PythonNode> python(
      JsonNode node, TopicNames names, GivenParameters parameters) {
    String module = node.path("module").asText();
    String name = names.name().filter(it -> !it.equals(node.path("name").asText())).orElse("");
    String namespace = names.namespace().filter(it -> !it.equals("/")).orElse("");
    return module.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new PythonNode(
                module,
                node.path("class").asText(),
                name,
                namespace,
                names.remappings(),
                Optional.of(node.path("arguments")).filter(JsonNode::isObject),
                parameters.values()));
  }

  private Optional<FoundEndpoint> endpoint(JsonNode json, TopicNames names) {
    String file = json.path("file").asText();
    int line = json.path("line").asInt();
    String written = json.path("topic").asText();
    Optional<String> topic = names.resolve(written);
    if (topic.isEmpty()) {
      ask("What is the full name of the topic '" + written + "' of this node?", file, line);
      return Optional.empty();
    }
    Optional<List<String>> fields =
        json.path("fields").isArray()
            ? Optional.of(
                StreamSupport.stream(json.path("fields").spliterator(), false)
                    .map(JsonNode::asText)
                    .toList())
            : Optional.empty();
    return Optional.of(
        new FoundEndpoint(
            json.path("kind").asText().equals("publisher"),
            topic.get(),
            json.path("type").asText(),
            qos(json, topic.get(), file, line),
            fields,
            file,
            line));
  }

  private Optional<QosSettings> qos(JsonNode json, String topic, String file, int line) {
    JsonNode written = json.path("qos");
    if (!written.isObject()) {
      return Optional.empty(); // the reader of sources has asked
    }
    Optional<QosSettings> read = SourceQos.read(written);
    if (read.isEmpty()) {
      ask(
          "What is the quality of service of '%s'? It is %s.".formatted(topic, written),
          file,
          line);
    }
    return read;
  }

  /** Returns the frequency of the fastest timer. */
  private OptionalDouble frequency(JsonNode node, String name) {
    JsonNode timers = node.path("timers");
    double[] periods =
        StreamSupport.stream(timers.spliterator(), false)
            .mapToDouble(timer -> timer.path("period").asDouble())
            .distinct()
            .sorted()
            .toArray();
    if (periods.length > 1) {
      ask(
          "At which frequency does %s act? It has several timers; that of the fastest is taken."
              .formatted(name),
          node.path("file").asText(),
          timers.path(0).path("line").asInt());
    }
    return DoubleStream.of(periods).limit(1).map(StartedNodes::frequency).findFirst();
  }

  /**
   * Returns the frequency of a period in s, without the digits that are not those of the source.
   */
  private static double frequency(double period) {
    return Math.round(1e9 / period) / 1e9;
  }

  private static Optional<String> text(JsonNode json, String name) {
    return json.path(name).isTextual() ? Optional.of(json.path(name).asText()) : Optional.empty();
  }

  private void ask(String text, String file, int line) {
    ask(new OpenQuestion(text, file, line));
  }

  private void ask(OpenQuestion question) {
    if (!questions.contains(question)) {
      questions.add(question);
    }
  }
}
