package dev.eventchain.contracts.latency;

import dev.eventchain.contracts.timing.Gap;
import dev.eventchain.contracts.timing.LatencyType;
import dev.eventchain.contracts.timing.PathLatency;
import dev.eventchain.contracts.timing.ResponseTimes.Outcome;
import dev.eventchain.contracts.timing.Task;
import dev.eventchain.contracts.timing.TaskGraph;
import dev.eventchain.contracts.timing.Trigger;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;

/**
 * Bounds on the latencies of an event chain. Each component is a periodic task of any phase: its
 * timer has the model's frequency, it reads the last messages when it starts, and publishes when it
 * has ended. That is after its worst-case execution time on a processor of its own, as in a
 * simulation, and after its response time on one that it shares. What activates a node that is
 * given whole is not in the model, so that no bound is known of a path with one: its timer may have
 * any period, and its messages may queue. Nor is how long a message waits for those that a
 * component takes together with it.
 */
public final class ChainTiming {

  private static final double MILLISECOND = 1e6;

  private final EventChain chain;
  private final DataFlowIndex flow;
  private final TopicIndex topics;
  private final Stimuli stimuli;
  private final Deployment deployment;
  private final TaskGraph graph = new TaskGraph();
  private final Map<SoftwareNode, String> names = new HashMap<>();

  private ChainTiming(EventChain chain, Stimuli stimuli) {
    this.chain = chain;
    this.stimuli = stimuli;
    deployment = Deployment.of(chain);
    flow = DataFlowIndex.of(chain);
    topics = TopicIndex.of(chain);
    // Names may be missing or occur twice, which other rules report.
    chain.getSoftware().forEach(node -> names.put(node, name(node)));
    chain.getSoftware().forEach(node -> graph.add(task(node, names.get(node))));
    for (SoftwareNode node : chain.getSoftware()) {
      flow.successors(node).forEach(reader -> graph.connect(names.get(node), names.get(reader)));
    }
  }

  /** Returns the bounds of a chain; later changes of the chain are not seen. */
  public static ChainTiming of(EventChain chain, Stimuli stimuli) {
    return new ChainTiming(chain, stimuli);
  }

  private String name(SoftwareNode node) {
    boolean known = node.getName() != null && !names.containsValue(node.getName());
    return known ? node.getName() : node.getName() + " (" + names.size() + ")";
  }

  private Task task(SoftwareNode node, String name) {
    boolean timer = NodeTimes.isComponent(node);
    return new Task(
        name,
        timer ? Trigger.PERIODIC : Trigger.SPORADIC,
        timer ? NodeTimes.period(node) : OptionalLong.empty(),
        OptionalLong.empty(),
        response(node),
        0,
        placement(node));
  }

  /** Returns the worst-case response time; empty if it is unknown or may exceed the period. */
  private OptionalLong response(SoftwareNode node) {
    Optional<Deployment.Share> share = share(node);
    if (share.isPresent()) {
      return share.get().response().bound();
    }
    return NodeTimes.isOverloaded(node) ? OptionalLong.empty() : NodeTimes.execution(node);
  }

  /** Returns the share of a component in a processor that others use, too. */
  private Optional<Deployment.Share> share(SoftwareNode node) {
    return deployment
        .shared(node)
        .flatMap(load -> load.shares().stream().filter(it -> it.node() == node).findFirst());
  }

  /** Returns the place of a component; unknown where it has a processor of its own. */
  private Task.Placement placement(SoftwareNode node) {
    return deployment
        .shared(node)
        .map(
            load ->
                new Task.Placement(
                    "processor " + deployment.loads().indexOf(load),
                    load.ordered() ? OptionalInt.of(node.getPriority()) : OptionalInt.empty()))
        .orElse(Task.Placement.UNKNOWN);
  }

  /** Returns the estimate of a constraint with both ends. */
  public LatencyEstimate of(LatencyConstraint constraint) {
    LatencyType type =
        constraint.getKind() == LatencyKind.DATA_AGE ? LatencyType.DATA_AGE : LatencyType.REACTION;
    Set<String> unknown = new LinkedHashSet<>();
    long outside = outside(type, constraint, unknown);
    return estimate(
        type, outside, List.of(constraint.getFirst()), List.of(constraint.getLast()), unknown);
  }

  /**
   * Returns the estimate of the reaction from what comes to a component to what another one makes
   * of it, on whichever components read and write the same topics as they do.
   */
  public LatencyEstimate reaction(SoftwareNode first, SoftwareNode last) {
    Set<String> read = stimuli(first);
    Set<SoftwareNode> firsts = new LinkedHashSet<>(List.of(first));
    Set<SoftwareNode> lasts = new LinkedHashSet<>(List.of(last));
    for (TopicIndex.Topic topic : topics.topics()) {
      if (read.contains(topic.name())) {
        topic.subscribers().forEach(end -> firsts.add(end.node()));
      }
      if (topic.publishers().stream().anyMatch(end -> end.node() == last)) {
        topic.publishers().forEach(end -> lasts.add(end.node()));
      }
    }
    return estimate(LatencyType.REACTION, 0, firsts, lasts, new LinkedHashSet<>());
  }

  private LatencyEstimate estimate(
      LatencyType type,
      long outside,
      Collection<SoftwareNode> firsts,
      Collection<SoftwareNode> lasts,
      Set<String> unknown) {
    List<PathLatency> paths = new ArrayList<>();
    for (SoftwareNode first : firsts) {
      for (SoftwareNode last : lasts) {
        Optional<List<PathLatency>> found = graph.between(type, names.get(first), names.get(last));
        if (found.isEmpty()) {
          unknown.add("data take more than 1,000 paths, or pass more than 1,000 components");
        }
        paths.addAll(found.orElse(List.of()));
      }
    }
    paths.forEach(path -> addUnknown(path, unknown));
    return new LatencyEstimate(
        type, outside, paths, unavoidable(paths), placed(paths), List.copyOf(unknown));
  }

  /** Returns the sum of the stated worst cases on the shortest path. */
  private long unavoidable(List<PathLatency> paths) {
    return paths.stream()
        .mapToLong(
            path ->
                path.path().stream()
                    .map(task -> node(task.name()))
                    .filter(node -> !NodeTimes.isOverloaded(node))
                    .mapToLong(node -> NodeTimes.execution(node).orElse(0))
                    .sum())
        .min()
        .orElse(0);
  }

  /** Returns what is taken to execute the components on paths, in words. */
  private String placed(List<PathLatency> paths) {
    List<String> alone =
        paths.stream()
            .flatMap(path -> path.path().stream())
            .map(Task::name)
            .distinct()
            .filter(name -> node(name).getMappedTo() == null)
            .map(name -> "'" + name + "'")
            .toList();
    boolean none = chain.getSoftware().stream().allMatch(node -> node.getMappedTo() == null);
    if (none) {
      return "each component runs on a processor of its own";
    }
    return alone.isEmpty()
        ? "nothing else runs on the processors"
        : String.join(", ", alone) + " on processors of their own, and nothing else on the others";
  }

  /** Adds what is not known of a path, also where the sum would need no period. */
  private void addUnknown(PathLatency path, Set<String> unknown) {
    for (Task task : path.path()) {
      SoftwareNode node = node(task.name());
      if (!NodeTimes.isComponent(node)) {
        unknown.add(activation(task.name()));
      }
      if (TopicIndex.synchronizedBy(node).size() > 1) {
        unknown.add(
            "'%s' synchronizes its inputs, and the model does not say how long a message waits for the others"
                .formatted(task.name()));
      }
    }
    path.gaps().forEach(gap -> unknown.add(text(gap)));
  }

  /** Returns what counts before the first component, and adds what is not known of it. */
  private long outside(LatencyType type, LatencyConstraint constraint, Set<String> unknown) {
    long longest = 0;
    for (String topic : stimuli(constraint.getFirst())) {
      long time = stimuli.before(topic, constraint);
      if (type == LatencyType.DATA_AGE) {
        OptionalLong interval = interval(topic, constraint.getFirst());
        if (interval.isEmpty()) {
          unknown.add("how long a message of " + topic + " stays the last one is not known");
        }
        time += interval.orElse(0);
      }
      longest = Math.max(longest, time);
    }
    return longest;
  }

  /**
   * Returns the topics that a component reads, except for those written by components behind it.
   */
  private Set<String> stimuli(SoftwareNode first) {
    Set<SoftwareNode> behind = new LinkedHashSet<>(List.of(first));
    Deque<SoftwareNode> open = new ArrayDeque<>(behind);
    while (!open.isEmpty()) {
      flow.successors(open.remove()).stream().filter(behind::add).forEach(open::add);
    }
    Set<String> found = new LinkedHashSet<>();
    for (Data input : first.getInput()) {
      TopicIndex.nameOf(input, first)
          .filter(topic -> writers(topic).stream().noneMatch(behind::contains))
          .ifPresent(found::add);
    }
    return found;
  }

  private List<SoftwareNode> writers(String topic) {
    return topics.find(topic).stream()
        .flatMap(found -> found.publishers().stream())
        .map(TopicIndex.Endpoint::node)
        .toList();
  }

  /** Returns how old a message may be when a component reads it; empty if not known. */
  private OptionalLong interval(String topic, SoftwareNode reader) {
    List<SoftwareNode> writers = writers(topic);
    List<OptionalLong> intervals = new ArrayList<>();
    if (writers.isEmpty()) {
      intervals.add(stimuli.interval(topic));
    }
    for (SoftwareNode writer : writers) {
      OptionalLong period =
          NodeTimes.isComponent(writer) ? NodeTimes.period(writer) : OptionalLong.empty();
      OptionalLong response = response(writer);
      intervals.add(
          period.isPresent() && response.isPresent()
              ? OptionalLong.of(period.getAsLong() + response.getAsLong())
              : OptionalLong.empty());
    }
    return intervals.stream().allMatch(OptionalLong::isPresent)
        ? intervals.stream().mapToLong(OptionalLong::getAsLong).max()
        : maximumAge(topic, reader);
  }

  /** Returns the age from which on a component does not execute with a message. */
  private static OptionalLong maximumAge(String topic, SoftwareNode reader) {
    return reader.getInput().stream()
        .filter(input -> TopicIndex.nameOf(input, reader).filter(topic::equals).isPresent())
        .filter(input -> input.isSetMaximumAge() && input.getMaximumAge() > 0)
        .mapToLong(input -> (long) Math.ceil(input.getMaximumAge() * MILLISECOND))
        .min();
  }

  private SoftwareNode node(String task) {
    return chain.getSoftware().stream()
        .filter(each -> names.get(each).equals(task))
        .findFirst()
        .orElseThrow();
  }

  private static String activation(String task) {
    return "'" + task + "' is a node of its own, and the model does not say what activates it";
  }

  private String text(Gap gap) {
    SoftwareNode node = node(gap.task());
    String name = "'" + gap.task() + "'";
    if (gap.kind() == Gap.Kind.PERIOD) {
      return NodeTimes.isComponent(node) ? name + " states no frequency" : activation(gap.task());
    }
    if (NodeTimes.isOverloaded(node)) {
      return name + " may execute longer than its period";
    }
    return NodeTimes.execution(node).isEmpty()
        ? name + " states no worst-case execution time"
        : waiting(node, name);
  }

  /** Returns why the response time on a shared processor is not known. */
  private String waiting(SoftwareNode node, String name) {
    boolean late = share(node).filter(it -> it.response().outcome() == Outcome.LATE).isPresent();
    String on = " on '" + node.getMappedTo().getName() + "'";
    return late
        ? name + " may end after its period" + on
        : "how long " + name + " waits for others" + on + " is not known";
  }
}
