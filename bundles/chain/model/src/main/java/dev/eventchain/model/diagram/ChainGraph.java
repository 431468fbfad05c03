package dev.eventchain.model.diagram;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.TopicIndex.Endpoint;
import dev.eventchain.model.TopicIndex.Topic;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.LineKind;
import dev.eventchain.model.eventchain.ComponentOrigin;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The components and topics of a chain and the flow between them, in chain order. */
final class ChainGraph {

  final List<Vertex> vertices = new ArrayList<>();
  final List<Vertex.Edge> edges = new ArrayList<>();
  private final IdentityHashMap<SoftwareNode, Vertex> components = new IdentityHashMap<>();

  ChainGraph(EventChain chain) {
    for (SoftwareNode node : chain.getSoftware()) {
      components.put(node, component(node, components.size()));
    }
    TopicIndex.of(chain).topics().forEach(this::addTopic);
    chain.getSoftware().forEach(this::addNextStep);
  }

  private Vertex component(SoftwareNode node, int index) {
    Vertex vertex = new Vertex(Kind.COMPONENT, text(node.getName()), index);
    vertex.elements.add(node);
    vertex.isGenerated = node.getOrigin() == ComponentOrigin.GENERATED;
    List<String> facts = new ArrayList<>();
    if (node.isSetFrequency()) {
      facts.add(hertz(node.getFrequency()));
    }
    facts.add(vertex.isGenerated ? "generated" : "existing");
    String satisfied =
        node.getSatisfies().stream()
            .map(each -> text(each.getId()))
            .collect(Collectors.joining(", "));
    if (!satisfied.isEmpty()) {
      facts.add(satisfied);
    }
    vertex.facts = String.join(" \u00b7 ", facts);
    vertices.add(vertex);
    return vertex;
  }

  /** Formats a frequency, without decimals for whole numbers. */
  private static String hertz(double frequency) {
    String number =
        Double.isFinite(frequency)
            ? BigDecimal.valueOf(frequency).stripTrailingZeros().toString()
            : Double.toString(frequency);
    return (number.contains("E") ? Double.toString(frequency).replaceAll("\\.0$", "") : number)
        + " Hz";
  }

  private void addTopic(Topic topic) {
    boolean isWritten = !topic.publishers().isEmpty();
    boolean isRead = !topic.subscribers().isEmpty();
    boolean leavesToo =
        isRead
            && topic.publishers().stream()
                .flatMap(p -> p.data().stream())
                .anyMatch(Data::isExternal);
    Vertex vertex =
        topicVertex(!isWritten ? Kind.SIGNAL_IN : isRead ? Kind.TOPIC : Kind.SIGNAL_OUT, topic);
    topic.publishers().forEach(end -> connect(components.get(end.node()), vertex, LineKind.FLOW));
    topic.subscribers().forEach(end -> connect(vertex, components.get(end.node()), LineKind.FLOW));
    if (leavesToo) {
      connect(vertex, topicVertex(Kind.SIGNAL_OUT, topic), LineKind.FLOW);
    }
  }

  private Vertex topicVertex(Kind kind, Topic topic) {
    double rank =
        topic.publishers().stream()
            .mapToDouble(end -> components.get(end.node()).rank)
            .max()
            .orElse(-1);
    Vertex vertex = new Vertex(kind, topic.name(), rank + 0.5);
    Stream.of(topic.publishers(), topic.subscribers())
        .flatMap(List::stream)
        .map(Endpoint::data)
        .forEach(vertex.elements::addAll);
    Set<String> types = new LinkedHashSet<>();
    vertex.elements.forEach(data -> types.add(text(((Data) data).getMessageType())));
    vertex.facts = types.stream().filter(type -> !type.isEmpty()).collect(Collectors.joining(", "));
    vertices.add(vertex);
    return vertex;
  }

  /** Adds an edge for the next step, since a chain without data has an order, too. */
  private void addNextStep(SoftwareNode node) {
    Vertex from = components.get(node);
    Vertex to = components.get(node.getNextstep());
    boolean isFlow =
        from.out.stream()
            .flatMap(edge -> edge.to.out.stream())
            .anyMatch(edge -> edge.to == to && edge.kind == LineKind.FLOW);
    if (to != null && to != from && !isFlow) {
      connect(from, to, LineKind.NEXT_STEP);
    }
  }

  private void connect(Vertex from, Vertex to, LineKind kind) {
    Vertex.Edge edge = new Vertex.Edge(from, to, kind);
    from.out.add(edge);
    to.in.add(edge);
    edges.add(edge);
  }

  private static String text(String value) {
    return value == null ? "" : Printable.clean(value).replaceAll("[\n\t]", " ");
  }
}
