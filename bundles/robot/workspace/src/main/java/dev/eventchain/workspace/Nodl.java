package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.RosNames;
import dev.eventchain.workspace.launch.TopicNames;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;

/**
 * Reader of interfaces of nodes in NoDL 2 (ros-tooling/nodl): publishers and subscriptions.
 * Services, actions, parameters and documents that are included from elsewhere have no counterpart
 * in a chain, and are asked for.
 */
public final class Nodl {

  private static final DocumentRules RULES = DocumentRules.all(WorkspaceRules.NODL);
  private static final String INTERFACE = ".nodl";
  private static final String LOCAL = "local://";
  private static final List<String> LEFT_OUT =
      List.of("service_servers", "service_clients", "action_servers", "action_clients");

  private final List<Diagnostic> findings = new ArrayList<>();
  private final List<OpenQuestion> questions = new ArrayList<>();

  private Nodl() {}

  /**
   * Reads documents, each of one node with the name of its file.
   *
   * @throws DiagnosticException INPUT if one cannot be read or is no such document ({@code
   *     workspace.nodl})
   */
  public static FoundSoftware read(List<Path> files) {
    Nodl reader = new Nodl();
    List<FoundNode> nodes = new ArrayList<>();
    files.forEach(file -> reader.node(file).ifPresent(nodes::add));
    if (!reader.findings.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.findings);
    }
    return new FoundSoftware(nodes, new TreeMap<>(), List.copyOf(reader.questions));
  }

  /** The document of a node, and those that it includes. */
  private final class Interface {
    final TopicNames names;
    final List<FoundEndpoint> endpoints = new ArrayList<>();
    final Set<Path> read = new LinkedHashSet<>();
    final Map<String, List<String>> fields = new HashMap<>();
    String description = "";
    OptionalDouble frequency = OptionalDouble.empty();

    Interface(String name) {
      names = new TopicNames(Optional.of("/"), Optional.of(name), List.of());
    }

    void add(Path file) {
      if (!read.add(file.toAbsolutePath().normalize())) {
        findings.add(
            Diagnostic.of(
                WorkspaceRules.NODL,
                "This document is included more than once.",
                SourceLocation.of(file)));
        return;
      }
      boolean isJson = file.toString().endsWith(".json");
      DocumentFormat format = isJson ? DocumentFormat.JSON : DocumentFormat.YAML;
      Document.parse(SourceText.read(file), format, RULES, findings::add)
          .object("", findings::add)
          .ifPresent(json -> add(json, file));
    }

    private void add(ObjectReader json, Path file) {
      json.requiredWholeNumber("nodl_version", NumberRange.of(2, 2));
      description = description.isEmpty() ? json.text("description").orElse("") : description;
      json.object("codegen").ifPresent(this::codegen);
      json.objects("publishers").forEach(each -> endpoint(each, true));
      json.objects("subscriptions").forEach(each -> endpoint(each, false));
      for (String kind : LEFT_OUT) {
        json.value(kind).ifPresent(value -> leftOut(json, kind, value));
      }
      json.value("parameters").ifPresent(value -> leftOut(json, "parameters", value));
      for (ObjectReader include : json.objects("include")) {
        include(include, file);
      }
      json.refuseOthers();
    }

    /** Reads what the template for NoDL writes, and no other tool. */
    private void codegen(ObjectReader tools) {
      Optional<ObjectReader> own = tools.object("eventchain");
      if (own.isPresent()) {
        frequency = own.get().number("frequency", NumberRange.above(0));
        for (ObjectReader value : own.get().objects("values")) {
          fields
              .computeIfAbsent(value.requiredText("topic"), topic -> new ArrayList<>())
              .add(value.requiredText("field"));
        }
      }
    }

    private void leftOut(ObjectReader json, String kind, JsonNode value) {
      if (!value.isEmpty()) {
        String text = "It has %s, which a chain does not have. Do they matter?";
        ask(text.formatted(kind.replace('_', ' ')), json.at(kind));
      }
    }

    private void include(ObjectReader include, Path file) {
      String ref = include.requiredText("ref");
      include.refuseOthers();
      if (ref.startsWith(LOCAL)) {
        add(file.resolveSibling(ref.substring(LOCAL.length())));
      } else {
        ask("What does the included document '" + ref + "' have?", include.at("ref"));
      }
    }

    private void endpoint(ObjectReader json, boolean isPublisher) {
      String name = json.requiredText("name");
      String type = RosNames.fullMessageType(json.requiredText("type"));
      json.text("description");
      Optional<ObjectReader> policies = json.requiredObject("qos");
      Optional<QosSettings> qos = policies.flatMap(NodlQos::read);
      qos.flatMap(read -> NodlQos.withoutCounterpart(policies.get()))
          .ifPresent(text -> ask(text, policies.get().location()));
      json.refuseOthers();
      SourceLocation place = json.location();
      Optional<String> topic = names.resolve(name);
      if (topic.isEmpty() || !RosNames.isMessageType(type)) {
        json.find(
            WorkspaceRules.NODL,
            "'%s' with the type '%s' is no topic of ROS 2.".formatted(name, type),
            place);
        return;
      }
      Optional<List<String>> used = Optional.ofNullable(fields.get(topic.get()));
      endpoints.add(
          new FoundEndpoint(isPublisher, topic.get(), type, qos, used, place.file(), place.line()));
    }
  }

  private Optional<FoundNode> node(Path file) {
    String name = file.getFileName().toString();
    int end = name.indexOf(INTERFACE);
    String simple = end < 0 ? name.replaceFirst("\\..*", "") : name.substring(0, end);
    String node = simple.substring(simple.lastIndexOf("__") < 0 ? 0 : simple.lastIndexOf("__") + 2);
    if (!RosNames.isTopic("/" + node)) {
      findings.add(
          Diagnostic.of(
                  WorkspaceRules.NODL,
                  "'" + node + "' cannot be the name of a node.",
                  SourceLocation.of(file))
              .withHint("Name the file as its node: NODE.nodl.yaml."));
      return Optional.empty();
    }
    Interface read = new Interface(node);
    read.add(file);
    return Optional.of(
        new FoundNode(
            "/" + node,
            read.description,
            read.frequency,
            read.endpoints,
            true,
            Optional.empty(),
            SourceLocation.of(file).file(),
            1));
  }

  private void ask(String text, SourceLocation place) {
    questions.add(new OpenQuestion(text, place.file(), place.line()));
  }
}
