package dev.eventchain.model;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Index of the data flow between the components of an event chain. Data flows from an output to an
 * input if both are on the same topic ({@link TopicIndex}), as DDS matches, and the output sets the
 * field that the input reads. One field may be part of the other ({@code header.stamp.sec} of
 * {@code header}). {@code SoftwareNode::feeds} of the standard rules is the same in OCL.
 *
 * <p>A snapshot: later changes of the chain are not seen. All lists are in chain order.
 */
public final class DataFlowIndex {

  private final Map<Data, List<Data>> producers = new HashMap<>();
  private final Map<SoftwareNode, List<SoftwareNode>> successors = new HashMap<>();
  private final List<List<SoftwareNode>> cycles;

  private DataFlowIndex(EventChain chain) {
    List<SoftwareNode> nodes = chain.getSoftware();
    TopicIndex topics = TopicIndex.of(chain);
    nodes.forEach(node -> connect(node, topics));
    cycles = new Cycles(nodes, successors).find();
  }

  private void connect(SoftwareNode reader, TopicIndex topics) {
    Set<SoftwareNode> before = new HashSet<>();
    for (Data input : reader.getInput()) {
      TopicIndex.nameOf(input, reader)
          .flatMap(topics::find)
          .ifPresent(topic -> topic.publishers().forEach(from -> connect(from, input, before)));
    }
    before.forEach(
        writer -> successors.computeIfAbsent(writer, key -> new ArrayList<>()).add(reader));
  }

  private void connect(TopicIndex.Endpoint publisher, Data input, Set<SoftwareNode> before) {
    for (Data output : publisher.data()) {
      if (overlap(output.getFieldName(), input.getFieldName())) {
        addOnce(producers, input, output);
        before.add(publisher.node());
      }
    }
  }

  /** Returns the data flow of a chain. */
  public static DataFlowIndex of(EventChain chain) {
    return new DataFlowIndex(chain);
  }

  /** Returns the components that read data of this one, including itself if it does. */
  public List<SoftwareNode> successors(SoftwareNode node) {
    return view(successors, node);
  }

  /**
   * Returns the components that data of this one reach, through others as well, the nearest first;
   * including itself if data of it come back.
   */
  public Set<SoftwareNode> behind(SoftwareNode node) {
    Set<SoftwareNode> reached = new LinkedHashSet<>();
    Deque<SoftwareNode> open = new ArrayDeque<>(List.of(node));
    while (!open.isEmpty()) {
      successors(open.remove()).stream().filter(reached::add).forEach(open::add);
    }
    return reached;
  }

  /** Returns the outputs that feed an input. */
  public List<Data> producers(Data input) {
    return view(producers, input);
  }

  /**
   * Returns the maximal groups of components that depend on their own output. No component is in
   * two of them.
   */
  public List<List<SoftwareNode>> cycles() {
    return cycles;
  }

  private static boolean overlap(String written, String read) {
    return written != null && read != null && RosNames.overlap(written, read);
  }

  private static <K, V> void addOnce(Map<K, List<V>> map, K key, V value) {
    List<V> values = map.computeIfAbsent(key, unused -> new ArrayList<>());
    if (!values.contains(value)) {
      values.add(value);
    }
  }

  private static <K, V> List<V> view(Map<K, List<V>> map, K key) {
    return Collections.unmodifiableList(map.getOrDefault(key, List.of()));
  }
}
