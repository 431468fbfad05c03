package dev.eventchain.simulation.tracing;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.measure.ChainLatency;
import dev.eventchain.simulation.measure.MeasuredModel;
import dev.eventchain.simulation.tracing.RosActivity.Node;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Latency;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Part;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.zip.CRC32;

/**
 * Times of a chain in a recorded trace of ROS 2. Components are nodes of their names; topics have
 * their full names in the trace.
 *
 * @param components the components that are in the trace, in chain order
 * @param missing the components that are not, with the reason
 * @param hops the ways of messages to the components' callbacks
 * @param latencies of the chain's latency constraints, in their order; empty for one that was not
 *     measured
 * @param unanswered the messages that no output is based on, of each latency constraint
 * @param unmatched what components read although no publication of it is known
 * @param earlier what components read that was underway when the trace began, and is left out
 * @param outside numbers of messages whose publishers are not in the trace, by topic
 * @param intervals the longest times between two messages, in ns, by topic
 */
public record TraceMeasurement(
    List<Component> components,
    Map<String, String> missing,
    List<Hop> hops,
    List<Optional<Latency>> latencies,
    List<Unanswered> unanswered,
    List<Unmatched> unmatched,
    List<Unmatched> earlier,
    Map<String, Integer> outside,
    Map<String, Long> intervals) {

  private static final double MILLISECOND = 1e6;

  /**
   * A component in the trace.
   *
   * @param node the full name of its node
   * @param times of its activations; without execution times where callbacks are not in the trace
   * @param writes whether it wrote one of its outputs
   */
  public record Component(String node, Measurements.Node times, boolean writes) {}

  /**
   * Messages on their way to a component.
   *
   * @param waiting from the publication to the start of the callback, in ms
   */
  public record Hop(String topic, String reader, Measurements.Statistics waiting) {}

  /** Readings of a topic that belong to no known publication. */
  public record Unmatched(String topic, String reader, int count) {}

  /**
   * Messages on which no output is based, from the first one on that has an output, in ms.
   *
   * @param untilLater the longest time until an output was based on a later one; 0 for none
   * @param untilEnd the time from the first of those at the end to the end of the trace; 0 for none
   */
  public record Unanswered(int count, double untilLater, double untilEnd) {

    /** No message. */
    static final Unanswered NONE = new Unanswered(0, 0, 0);

    /** Returns the longest of the times. */
    public double longest() {
      return Math.max(untilLater, untilEnd);
    }
  }

  /** Measures a chain in a trace. */
  public static TraceMeasurement of(EventChain chain, RecordedTrace trace) {
    return new Measuring(chain, trace.activity()).result();
  }

  /** Returns a copy of the chain with what was measured, under a name for the trace. */
  public EventChain measuredModel(EventChain chain, String name, boolean passed) {
    Measurements all =
        new Measurements(
            runId(),
            "",
            "",
            components.stream().map(Component::times).toList(),
            new MessageFlow(List.of(), List.of(), List.of()));
    return MeasuredModel.ofTrace(chain, all, name, latencies, passed);
  }

  private String runId() {
    CRC32 digest = new CRC32();
    digest.update((components + " " + latencies).getBytes(StandardCharsets.UTF_8));
    return String.format(Locale.ROOT, "trace-%08x", digest.getValue());
  }

  /** A measurement while it is made. */
  private static final class Measuring {

    private final EventChain chain;
    private final RosActivity activity;
    private final TopicIndex topics;
    private final TracedMessages messages;
    private final Map<String, String> missing = new LinkedHashMap<>();
    private final List<Component> components = new ArrayList<>();
    private final List<Hop> hops = new ArrayList<>();
    private final List<Unmatched> unmatched = new ArrayList<>();
    private final List<Unmatched> earlier = new ArrayList<>();
    private final Map<String, List<Activation>> activations = new LinkedHashMap<>();

    Measuring(EventChain chain, RosActivity activity) {
      this.chain = chain;
      this.activity = activity;
      topics = TopicIndex.of(chain);
      messages =
          new TracedMessages(
              activity,
              topics.topics().stream().map(TopicIndex.Topic::name).collect(Collectors.toSet()));
      chain.getSoftware().forEach(this::measure);
    }

    private void measure(SoftwareNode component) {
      List<Node> nodes = nodes(component);
      if (nodes.size() != 1) {
        missing.put(nameOf(component), reason(component, nodes));
        return;
      }
      ComponentActivity found =
          new ComponentActivity(
              nodes.get(0),
              topics.readBy(component),
              topics.writtenBy(component),
              activity,
              messages);
      components.add(component(component, nodes.get(0), found));
      boolean isSilent = !component.getOutput().isEmpty() && !found.writes();
      activations.put(nameOf(component), isSilent ? List.of() : found.activations());
      found
          .waiting()
          .forEach(
              (topic, times) ->
                  statistics(times)
                      .ifPresent(it -> hops.add(new Hop(topic, nameOf(component), it))));
      found
          .unmatched()
          .forEach(it -> unmatched.add(new Unmatched(it.topic(), nameOf(component), it.count())));
      found
          .earlier()
          .forEach((topic, count) -> earlier.add(new Unmatched(topic, nameOf(component), count)));
    }

    /**
     * Returns the nodes of a component's name; of several, that in the root namespace, or else that
     * with the component's topics.
     */
    private List<Node> nodes(SoftwareNode component) {
      String name = RosNames.nodeName(nameOf(component));
      List<Node> named =
          activity.nodes.stream()
              .filter(it -> name.equals(RosNames.nodeName(it.name())) || name.equals(joined(it)))
              .distinct()
              .toList();
      List<Node> root = named.stream().filter(it -> it.namespace().equals("/")).toList();
      List<Node> near =
          root.isEmpty() ? named.stream().filter(it -> hasTopics(it, component)).toList() : root;
      return near.isEmpty() ? named : near;
    }

    /** Returns the name of a node with that of its namespace in front, as that of a component. */
    private static String joined(Node node) {
      return RosNames.nodeName(node.fullName().substring(1).replace('/', '_'));
    }

    private boolean hasTopics(Node node, SoftwareNode component) {
      return activity.publishers.stream()
              .filter(it -> it.node().equals(node))
              .map(RosActivity.Publisher::topic)
              .collect(Collectors.toSet())
              .containsAll(topics.writtenBy(component))
          && activity.subscriptions.stream()
              .filter(it -> it.node().equals(node))
              .map(RosActivity.Subscription::topic)
              .collect(Collectors.toSet())
              .containsAll(topics.readBy(component));
    }

    private static String reason(SoftwareNode component, List<Node> nodes) {
      return nodes.isEmpty()
          ? "no node is called '" + RosNames.nodeName(nameOf(component)) + "'"
          : "several nodes are called so, and none of them alone is in the root namespace or has its topics";
    }

    private static String nameOf(SoftwareNode component) {
      return component.getName() == null ? "" : component.getName();
    }

    private static Component component(SoftwareNode component, Node node, ComponentActivity found) {
      List<Long> periods = new ArrayList<>();
      for (int i = 1; i < found.activations().size(); i++) {
        periods.add(found.activations().get(i).start() - found.activations().get(i - 1).start());
      }
      double nominal = SimulatedChain.period(component);
      double[] jitter =
          periods.stream().mapToDouble(it -> Math.abs(it / MILLISECOND - nominal)).toArray();
      return new Component(
          node.fullName(),
          new Measurements.Node(
              nameOf(component),
              found.activations().size(),
              statistics(periods),
              Measurements.Statistics.of(nominal > 0 ? jitter : new double[0]),
              statistics(found.executionTimes()),
              Optional.empty()),
          found.writes());
    }

    private static Optional<Measurements.Statistics> statistics(Collection<Long> nanoseconds) {
      return Measurements.Statistics.of(
          nanoseconds.stream().mapToDouble(it -> it / MILLISECOND).toArray());
    }

    private TraceMeasurement result() {
      RunLog log = new RunLog(activations, messages.publications());
      List<Optional<Latency>> latencies =
          chain.getLatencyConstraints().stream().map(it -> latency(log, it)).toList();
      List<Unanswered> unanswered =
          chain.getLatencyConstraints().stream().map(it -> unanswered(log, it)).toList();
      Map<String, Long> intervals = new LinkedHashMap<>();
      for (TopicIndex.Topic topic : topics.topics()) {
        messages.interval(topic.name()).ifPresent(it -> intervals.put(topic.name(), it));
      }
      return new TraceMeasurement(
          components,
          missing,
          hops,
          latencies,
          unanswered,
          unmatched,
          earlier,
          messages.outside(),
          intervals);
    }

    private Unanswered unanswered(RunLog log, LatencyConstraint constraint) {
      if (constraint.getFirst() == null || constraint.getLast() == null) {
        return Unanswered.NONE;
      }
      ChainLatency.Unanswered found =
          ChainLatency.unanswered(
              log, constraint.getFirst().getName(), constraint.getLast().getName(), activity.end);
      return new Unanswered(
          found.count(), found.untilLater() / MILLISECOND, found.untilEnd() / MILLISECOND);
    }

    private static Optional<Latency> latency(RunLog log, LatencyConstraint constraint) {
      if (constraint.getFirst() == null || constraint.getLast() == null) {
        return Optional.empty();
      }
      List<ChainLatency.Latency> found =
          ChainLatency.between(
              log,
              constraint.getFirst().getName(),
              constraint.getLast().getName(),
              constraint.getKind() == LatencyKind.DATA_AGE);
      return Measurements.Statistics.of(
              found.stream()
                  .flatMapToDouble(it -> DoubleStream.of(it.time() / MILLISECOND))
                  .toArray())
          .map(it -> new Latency(it, slowest(found), 0));
    }

    private static List<Part> slowest(List<ChainLatency.Latency> found) {
      ChainLatency.Latency slowest = found.get(0);
      for (ChainLatency.Latency each : found) {
        slowest = each.time() > slowest.time() ? each : slowest;
      }
      return slowest.parts().stream()
          .map(it -> new Part(it.node(), it.waiting() / MILLISECOND, it.execution() / MILLISECOND))
          .toList();
    }
  }
}
