package dev.eventchain.model;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * Index of the topics of an event chain with their publishers and subscribers. The data of a
 * component on the same topic form one endpoint: a publisher or subscription at run time. Names are
 * fully resolved as in ROS 2 for nodes in the root namespace: {@code a/x} and {@code /a/x} are one
 * topic, {@code ~/x} is one for each component. Data without a topic are skipped.
 *
 * <p>A snapshot: later changes of the chain are not seen. All lists are in chain order.
 */
public final class TopicIndex {

  /**
   * The data that a component writes to a topic or reads from it.
   *
   * @param data the fields, in the order of the component; at least one
   */
  public record Endpoint(SoftwareNode node, List<Data> data) {}

  /**
   * A topic with its publishers and subscribers, at least one in all.
   *
   * @param name its full name
   */
  public record Topic(String name, List<Endpoint> publishers, List<Endpoint> subscribers) {}

  private final Map<String, Topic> topics = new LinkedHashMap<>();

  private TopicIndex(EventChain chain) {
    for (SoftwareNode node : chain.getSoftware()) {
      byTopic(node, node.getInput())
          .forEach((name, data) -> topic(name).subscribers().add(new Endpoint(node, data)));
      byTopic(node, node.getOutput())
          .forEach((name, data) -> topic(name).publishers().add(new Endpoint(node, data)));
    }
    topics.replaceAll(
        (name, topic) ->
            new Topic(name, List.copyOf(topic.publishers()), List.copyOf(topic.subscribers())));
  }

  private Topic topic(String name) {
    return topics.computeIfAbsent(
        name, key -> new Topic(key, new ArrayList<>(), new ArrayList<>()));
  }

  private static Map<String, List<Data>> byTopic(SoftwareNode node, List<Data> all) {
    Map<String, List<Data>> groups = new LinkedHashMap<>();
    for (Data data : all) {
      nameOf(data, node)
          .ifPresent(name -> groups.computeIfAbsent(name, key -> new ArrayList<>()).add(data));
    }
    return groups;
  }

  /** Returns the topics of a chain. */
  public static TopicIndex of(EventChain chain) {
    return new TopicIndex(chain);
  }

  /**
   * Returns the full name of the topic of a component's data.
   *
   * @return empty if there is no topic
   */
  public static Optional<String> nameOf(Data data, SoftwareNode node) {
    String name = data.getTopicName();
    String owner = node.getName() == null ? "" : RosNames.nodeName(node.getName());
    return name == null || name.isEmpty()
        ? Optional.empty()
        : Optional.of(RosNames.resolve(name, owner));
  }

  /** Returns the full names of the topics whose messages a component is given together, sorted. */
  public static List<String> synchronizedBy(SoftwareNode node) {
    return node.getSynchronized().stream()
        .flatMap(input -> nameOf(input, node).stream())
        .distinct()
        .sorted()
        .toList();
  }

  /** Returns all topics, in the order of appearance. */
  public Collection<Topic> topics() {
    return Collections.unmodifiableCollection(topics.values());
  }

  /**
   * Returns a topic.
   *
   * @param name its full name
   * @return empty if the chain neither reads nor writes it
   */
  public Optional<Topic> find(String name) {
    return Optional.ofNullable(topics.get(name));
  }

  /** Returns the full names of the topics that a node reads, in their order. */
  public SortedSet<String> readBy(SoftwareNode node) {
    return of(node, Topic::subscribers);
  }

  /** Returns the full names of the topics that a node writes, in their order. */
  public SortedSet<String> writtenBy(SoftwareNode node) {
    return of(node, Topic::publishers);
  }

  private SortedSet<String> of(SoftwareNode node, Function<Topic, List<Endpoint>> side) {
    return topics.values().stream()
        .filter(topic -> side.apply(topic).stream().anyMatch(end -> end.node() == node))
        .map(Topic::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * Returns the full names of the topics whose messages depend on software components: those that
   * they write, and those that further components derive from these. Nodes that are given whole,
   * and not as a component, are left out: what they do is not known.
   */
  public Set<String> influencedBy(Collection<SoftwareNode> components) {
    return influencedBy(
        components, node -> node.getImplementation() == ComponentImplementation.COMPONENT);
  }

  /**
   * As {@link #influencedBy(Collection)}.
   *
   * @param isKnown whether it is known what a node does
   */
  public Set<String> influencedBy(
      Collection<SoftwareNode> components, Predicate<SoftwareNode> isKnown) {
    Set<String> influenced = new HashSet<>();
    Set<SoftwareNode> reached = new HashSet<>(components);
    Deque<SoftwareNode> open = new ArrayDeque<>(components);
    while (!open.isEmpty()) {
      SoftwareNode node = open.remove();
      if (isKnown.test(node)) {
        node.getOutput().stream()
            .flatMap(output -> nameOf(output, node).stream())
            .filter(influenced::add)
            .flatMap(name -> find(name).stream())
            .flatMap(topic -> topic.subscribers().stream())
            .map(Endpoint::node)
            .filter(reached::add)
            .forEach(open::add);
      }
    }
    return influenced;
  }
}
