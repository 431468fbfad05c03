package dev.eventchain.model;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Which components pass data to which in an event chain. Data flows from an output to an input when
 * both are on the same topic ({@link TopicIndex}), the rule that DDS matches by, and the output
 * sets what the input reads: the same field, or one of which the other is a part ({@code header}
 * and {@code header.stamp.sec}). {@code SoftwareNode::feeds} of the standard rules says the same in
 * OCL.
 *
 * <p>A snapshot: later changes of the chain are not seen. All lists are in chain order.
 */
public final class DataFlowIndex {

  private final Map<Data, List<Data>> producers = new HashMap<>();
  private final Map<Data, List<Data>> consumers = new HashMap<>();
  private final Map<Data, List<SoftwareNode>> writers = new HashMap<>();
  private final Map<Data, List<SoftwareNode>> readers = new HashMap<>();
  private final Map<SoftwareNode, List<SoftwareNode>> successors = new HashMap<>();
  private final Map<SoftwareNode, List<SoftwareNode>> predecessors = new HashMap<>();
  private final List<List<SoftwareNode>> cycles;

  private DataFlowIndex(EventChain chain) {
    List<SoftwareNode> nodes = chain.getSoftware();
    Map<SoftwareNode, Integer> order = new HashMap<>();
    for (SoftwareNode node : nodes) {
      order.put(node, order.size());
      node.getOutput()
          .forEach(data -> writers.computeIfAbsent(data, key -> new ArrayList<>()).add(node));
      node.getInput()
          .forEach(data -> readers.computeIfAbsent(data, key -> new ArrayList<>()).add(node));
    }
    TopicIndex topics = TopicIndex.of(chain);
    nodes.forEach(node -> connect(node, order, topics));
    cycles = new Cycles(nodes, successors).find();
  }

  private void connect(SoftwareNode reader, Map<SoftwareNode, Integer> order, TopicIndex topics) {
    Set<SoftwareNode> before = new HashSet<>();
    for (Data input : reader.getInput()) {
      TopicIndex.nameOf(input, reader)
          .flatMap(topics::find)
          .ifPresent(topic -> topic.publishers().forEach(from -> connect(from, input, before)));
    }
    List<SoftwareNode> sorted = new ArrayList<>(before);
    sorted.sort(Comparator.comparing(order::get));
    predecessors.put(reader, sorted);
    for (SoftwareNode writer : sorted) {
      successors.computeIfAbsent(writer, key -> new ArrayList<>()).add(reader);
    }
  }

  private void connect(TopicIndex.Endpoint publisher, Data input, Set<SoftwareNode> before) {
    for (Data output : publisher.data()) {
      if (overlap(output.getFieldName(), input.getFieldName())) {
        addOnce(producers, input, output);
        addOnce(consumers, output, input);
        before.add(publisher.node());
      }
    }
  }

  /** The data flow of a chain. */
  public static DataFlowIndex of(EventChain chain) {
    return new DataFlowIndex(chain);
  }

  /** The components that read something that this one writes; itself too if it does. */
  public List<SoftwareNode> successors(SoftwareNode node) {
    return view(successors, node);
  }

  /** The components that write something that this one reads; itself too if it does. */
  public List<SoftwareNode> predecessors(SoftwareNode node) {
    return view(predecessors, node);
  }

  /** The outputs that an input gets its values from. */
  public List<Data> producers(Data input) {
    return view(producers, input);
  }

  /** The inputs that get their values from an output. */
  public List<Data> consumers(Data output) {
    return view(consumers, output);
  }

  /** The components that have this data as an output: one in a sound model. */
  public List<SoftwareNode> writers(Data data) {
    return view(writers, data);
  }

  /** The components that have this data as an input: one in a sound model. */
  public List<SoftwareNode> readers(Data data) {
    return view(readers, data);
  }

  /**
   * The groups of components that each depend on their own output. Every group is as large as
   * possible, so no component is in two of them.
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
