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
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
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
 * simulation, and after its response time on one that it shares. A message is on its way as long as
 * its ends state, and not at all where they state nothing. What activates a node that is given
 * whole is not in the model, so that no bound is known of a path with one: its timer may have any
 * period, and its messages may queue. Nor is how long a message waits for those that a component
 * takes together with it.
 */
public final class ChainTiming {

  private final EventChain chain;
  private final DataFlowIndex flow;
  private final TopicIndex topics;
  private final Deployment deployment;
  private final TaskGraph graph = new TaskGraph();
  private final Map<SoftwareNode, String> names = new HashMap<>();
  private final Transports transports;
  private final Arrivals arrivals;

  /** Ways of messages that take time, by the names of their tasks. */
  private final Map<String, Transports.Way> ways = new HashMap<>();

  /** Pairs of components between which messages are stated to take no time. */
  private final Set<List<String>> statedAtOnce = new HashSet<>();

  private ChainTiming(EventChain chain, Stimuli stimuli) {
    this.chain = chain;
    deployment = Deployment.of(chain);
    flow = DataFlowIndex.of(chain);
    topics = TopicIndex.of(chain);
    transports = new Transports(topics, flow);
    arrivals = new Arrivals(topics, flow, deployment, transports, stimuli);
    // Names may be missing or occur twice, which other rules report.
    chain.getSoftware().forEach(node -> names.put(node, name(node)));
    chain.getSoftware().forEach(node -> graph.add(task(node, names.get(node))));
    for (SoftwareNode node : chain.getSoftware()) {
      flow.successors(node).forEach(reader -> connect(node, reader));
    }
  }

  /** Connects two components, by a task of its own where the messages between them take time. */
  private void connect(SoftwareNode writer, SoftwareNode reader) {
    String from = names.get(writer);
    String to = names.get(reader);
    Optional<Transports.Way> way = transports.between(writer, reader);
    if (way.isEmpty() || way.get().isNone()) {
      // A task that takes no time would hide that both may share a processor.
      graph.connect(from, to);
      way.ifPresent(it -> statedAtOnce.add(List.of(from, to)));
      return;
    }
    String name = way.get().topic() + " from " + from + " to " + to;
    while (names.containsValue(name) || ways.containsKey(name)) {
      name += " (" + ways.size() + ")";
    }
    ways.put(name, way.get());
    graph.add(Task.onMessage(name, way.get().time()));
    graph.connect(from, name);
    graph.connect(name, to);
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
        deployment.response(node),
        0,
        placement(node));
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
    long outside = arrivals.before(type, constraint, unknown);
    return estimate(
        type, outside, List.of(constraint.getFirst()), List.of(constraint.getLast()), unknown);
  }

  /**
   * Returns the estimate of the reaction from the inputs of a component to the outputs of another
   * one. Any components that connect the same topics may be in between.
   */
  public LatencyEstimate reaction(SoftwareNode first, SoftwareNode last) {
    Set<String> read = arrivals.topics(first);
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
    Set<String> unknown = new LinkedHashSet<>();
    long outside = 0;
    for (SoftwareNode each : firsts) {
      outside = Math.max(outside, arrivals.transport(each, unknown));
    }
    return estimate(LatencyType.REACTION, outside, firsts, lasts, unknown);
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
        type,
        outside,
        paths,
        unavoidable(paths),
        placed(paths) + transported(paths),
        List.copyOf(unknown));
  }

  /** Returns the sum of the stated worst cases on the shortest path. */
  private long unavoidable(List<PathLatency> paths) {
    return paths.stream()
        .mapToLong(path -> path.path().stream().mapToLong(this::worstCase).sum())
        .min()
        .orElse(0);
  }

  /** Returns the worst case of a task by itself, and 0 where it is not known. */
  private long worstCase(Task task) {
    if (ways.containsKey(task.name())) {
      return task.response().orElse(0);
    }
    SoftwareNode node = node(task.name());
    return NodeTimes.isOverloaded(node) ? 0 : NodeTimes.execution(node).orElse(0);
  }

  /** Returns the components on a path, without the ways between them. */
  private List<SoftwareNode> nodes(PathLatency path) {
    return path.path().stream()
        .map(Task::name)
        .filter(name -> !ways.containsKey(name))
        .map(this::node)
        .toList();
  }

  /** Returns which messages on paths are taken to be there at once, in words. */
  private String transported(List<PathLatency> paths) {
    Set<String> atOnce = new LinkedHashSet<>();
    for (PathLatency path : paths) {
      SoftwareNode first = node(path.path().get(0).name());
      for (String topic : arrivals.atOnce(first)) {
        atOnce.add("of " + topic + " to '" + names.get(first) + "'");
      }
      for (int i = 1; i < path.path().size(); i++) {
        Task from = path.path().get(i - 1);
        Task to = path.path().get(i);
        boolean stated = statedAtOnce.contains(List.of(from.name(), to.name()));
        if (!isWay(from) && !isWay(to) && !stated) {
          atOnce.add("from '" + from.name() + "' to '" + to.name() + "'");
        }
      }
    }
    boolean none = chain.getData().stream().noneMatch(Data::isSetWorstCaseTransportTime);
    if (atOnce.isEmpty()) {
      return "";
    }
    return none
        ? "; messages take no time"
        : "; messages " + String.join(", ", atOnce) + " take no time";
  }

  private boolean isWay(Task task) {
    return ways.containsKey(task.name());
  }

  /** Returns what is taken to execute the components on paths, in words. */
  private String placed(List<PathLatency> paths) {
    List<String> alone =
        paths.stream()
            .flatMap(path -> nodes(path).stream())
            .distinct()
            .filter(node -> node.getMappedTo() == null)
            .map(node -> "'" + names.get(node) + "'")
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
    for (SoftwareNode node : nodes(path)) {
      if (!NodeTimes.isComponent(node)) {
        unknown.add(activation(names.get(node)));
      }
      if (TopicIndex.synchronizedBy(node).size() > 1) {
        unknown.add(
            "'%s' synchronizes its inputs, and the model does not say how long a message waits for the others"
                .formatted(names.get(node)));
      }
    }
    path.gaps().forEach(gap -> unknown.add(text(gap)));
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
    if (ways.containsKey(gap.task())) {
      return Arrivals.noTime(ways.get(gap.task()));
    }
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
    boolean late =
        deployment.share(node).filter(it -> it.response().outcome() == Outcome.LATE).isPresent();
    String on = " on '" + node.getMappedTo().getName() + "'";
    return late
        ? name + " may end after its period" + on
        : "how long " + name + " waits for others" + on + " is not known";
  }
}
