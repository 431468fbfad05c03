package dev.eventchain.simulation.tracing;

import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import dev.eventchain.simulation.tracing.RosActivity.Execution;
import dev.eventchain.simulation.tracing.RosActivity.Node;
import dev.eventchain.simulation.tracing.RosActivity.Publication;
import dev.eventchain.simulation.tracing.RosActivity.Take;
import dev.eventchain.simulation.tracing.TraceEvent.ThreadId;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * Activity of a component: the executions that make its outputs, with what they were based on.
 *
 * <p>An output is based on the last message of each input that the node had handled when the
 * execution started, and on the message that the execution was called with. Where callbacks are not
 * in the trace, as in Python, it is based on the last messages that its thread has taken before.
 */
final class ComponentActivity {

  /** Readings of a topic that the trace does not explain. */
  record Unmatched(String topic, int count, int of) {}

  /**
   * Time in which messages that wait at the start, of the trace or a component, are read, in ns.
   */
  private static final long WHILE_BEGINNING = 1_000_000_000L;

  private final Node node;
  private final Set<String> inputs;
  private final Set<String> outputs;
  private final TracedMessages messages;
  private final long begin;

  /** Samples of a topic by the time at which their callbacks had ended. */
  private final Map<String, NavigableMap<Long, SampleId>> handled = new LinkedHashMap<>();

  /** Samples that a thread took by itself, by topic and time. */
  private final Map<ThreadId, Map<String, NavigableMap<Long, SampleId>>> polled =
      new LinkedHashMap<>();

  private final Map<String, Integer> taken = new LinkedHashMap<>();
  private final Map<String, Integer> unmatched = new LinkedHashMap<>();
  private final Map<String, Integer> earlier = new LinkedHashMap<>();
  private final Map<String, Long> firstReads = new LinkedHashMap<>();
  private final Map<String, List<Long>> waiting = new LinkedHashMap<>();
  private final List<Activation> activations = new ArrayList<>();
  private final List<Long> executionTimes = new ArrayList<>();

  /**
   * Collects the activity of a node.
   *
   * @param inputs the topics that the component reads
   * @param outputs the topics that it writes
   */
  ComponentActivity(
      Node node,
      Set<String> inputs,
      Set<String> outputs,
      RosActivity activity,
      TracedMessages messages) {
    this.node = node;
    this.inputs = inputs;
    this.outputs = outputs;
    this.messages = messages;
    begin = activity.begin;
    activity.takes.stream().filter(this::isInput).forEach(this::read);
    List<Execution> executions =
        activity.executions.stream().filter(it -> node.equals(it.callback.node())).toList();
    executions.stream().filter(this::isUnknownInput).forEach(it -> unmatched(topic(it)));
    executions(executions).forEach(this::activate);
    group(activity.publications.stream().filter(this::isFree).toList());
    activations.sort(Comparator.comparingLong(Activation::start));
  }

  private boolean isInput(Take take) {
    return node.equals(take.subscription.node()) && inputs.contains(take.subscription.topic());
  }

  /** Returns whether a callback of an input was called with a message that is not known. */
  private boolean isUnknownInput(Execution execution) {
    return execution.take == null
        && execution.callback.subscription() != null
        && inputs.contains(topic(execution));
  }

  private static String topic(Execution execution) {
    return execution.callback.subscription().topic();
  }

  private boolean isFree(Publication publication) {
    return publication.execution == null
        && node.equals(publication.publisher.node())
        && outputs.contains(publication.publisher.topic());
  }

  private void unmatched(String topic) {
    taken.merge(topic, 1, Integer::sum);
    unmatched.merge(topic, 1, Integer::sum);
  }

  private void read(Take take) {
    String topic = take.subscription.topic();
    firstReads.putIfAbsent(topic, take.time);
    Optional<SampleId> sample = messages.taken(take);
    if (sample.isEmpty()) {
      if (isEarlier(take)) {
        earlier.merge(topic, 1, Integer::sum);
      } else {
        unmatched(topic);
      }
      return;
    }
    taken.merge(topic, 1, Integer::sum);
    long published = messages.publications().get(topic).get(sample.get().sequence());
    long start = take.execution == null ? take.time : take.execution.start;
    waiting.computeIfAbsent(topic, it -> new ArrayList<>()).add(start - published);
    if (take.execution == null) {
      polled
          .computeIfAbsent(take.thread, it -> new LinkedHashMap<>())
          .computeIfAbsent(topic, it -> new TreeMap<>())
          .put(take.time, sample.get());
    } else if (take.execution.end > 0) {
      handled.computeIfAbsent(topic, it -> new TreeMap<>()).put(take.execution.end, sample.get());
    }
  }

  /**
   * Returns whether a message was underway when the trace began, so that its publication is not in
   * it. Later on, such a time is that of another clock.
   */
  private boolean isEarlier(Take take) {
    String topic = take.subscription.topic();
    long beginning = taken.containsKey(topic) ? begin : firstReads.get(topic);
    return take.stamp != 0 && take.stamp < begin && take.time - beginning < WHILE_BEGINNING;
  }

  /**
   * Returns the executions that count as activations: of the callbacks that write outputs; else of
   * timers; else of the inputs' callbacks.
   */
  private List<Execution> executions(List<Execution> all) {
    Set<RosActivity.Callback> writing = new HashSet<>();
    for (Execution each : all) {
      if (each.publications.stream().anyMatch(it -> outputs.contains(it.publisher.topic()))) {
        writing.add(each.callback);
      }
    }
    boolean timers = all.stream().anyMatch(it -> it.callback.timer() != null);
    return all.stream()
        .filter(it -> it.end > 0)
        .filter(
            it ->
                writing.isEmpty()
                    ? (timers ? it.callback.timer() != null : inputs.contains(topic(it)))
                    : writing.contains(it.callback))
        .toList();
  }

  private void activate(Execution execution) {
    List<Publication> written =
        execution.publications.stream()
            .filter(it -> outputs.contains(it.publisher.topic()))
            .toList();
    long until = written.isEmpty() ? execution.end : written.get(0).time;
    Map<String, SampleId> reads = reads(execution.start, execution.thread, until);
    if (execution.take != null && inputs.contains(topic(execution))) {
      messages.taken(execution.take).ifPresent(it -> reads.put(it.topic(), it));
    }
    executionTimes.add(execution.end - execution.start);
    add(execution.start, execution.end, reads, written);
  }

  private void add(
      long start, long end, Map<String, SampleId> reads, List<Publication> publications) {
    List<SampleId> writes =
        publications.stream().flatMap(it -> messages.published(it).stream()).toList();
    activations.add(new Activation(start, end, 0, List.copyOf(reads.values()), writes));
  }

  /**
   * Returns the last samples of the topics.
   *
   * @param start the time until which callbacks must have ended
   * @param until the time until which the thread itself takes messages
   */
  private Map<String, SampleId> reads(long start, ThreadId thread, long until) {
    Map<String, SampleId> reads = new TreeMap<>();
    for (String topic : inputs) {
      Map.Entry<Long, SampleId> by = last(handled, topic, start);
      Map.Entry<Long, SampleId> own = last(polled.getOrDefault(thread, Map.of()), topic, until);
      boolean isOwn = by == null || (own != null && own.getKey() > by.getKey());
      Map.Entry<Long, SampleId> found = isOwn ? own : by;
      if (found != null) {
        reads.put(topic, found.getValue());
      }
      if (isTakenElsewhere(topic, thread, until)) {
        unmatched.merge(topic, 1, Integer::sum);
      }
    }
    return reads;
  }

  /** Returns whether another thread, without a callback, has taken messages of a topic. */
  private boolean isTakenElsewhere(String topic, ThreadId thread, long until) {
    return polled.entrySet().stream()
        .anyMatch(it -> !it.getKey().equals(thread) && last(it.getValue(), topic, until) != null);
  }

  private static Map.Entry<Long, SampleId> last(
      Map<String, NavigableMap<Long, SampleId>> samples, String topic, long until) {
    NavigableMap<Long, SampleId> ofTopic = samples.get(topic);
    return ofTopic == null ? null : ofTopic.floorEntry(until);
  }

  /**
   * Adds publications outside of known callbacks, each with the next ones on other topics as long
   * as the thread has taken nothing.
   */
  private void group(List<Publication> free) {
    Map<ThreadId, List<Publication>> open = new LinkedHashMap<>();
    for (Publication each : free) {
      List<Publication> group = open.computeIfAbsent(each.thread, it -> new ArrayList<>());
      boolean isNext =
          group.stream().anyMatch(it -> it.publisher.topic().equals(each.publisher.topic()))
              || (!group.isEmpty() && hasTaken(each.thread, group.get(0).time, each.time));
      if (isNext) {
        close(group);
        group.clear();
      }
      group.add(each);
    }
    open.values().forEach(this::close);
  }

  private boolean hasTaken(ThreadId thread, long from, long until) {
    return polled.getOrDefault(thread, Map.of()).values().stream()
        .anyMatch(it -> !it.subMap(from, until).isEmpty());
  }

  private void close(List<Publication> group) {
    long start = group.get(0).time;
    long end = group.get(group.size() - 1).time;
    add(start, end, reads(start, group.get(0).thread, start), group);
  }

  /** Returns the activations, in the order of time. */
  List<Activation> activations() {
    return activations;
  }

  /** Returns the times of executions, in ns; none where callbacks are not in the trace. */
  List<Long> executionTimes() {
    return executionTimes;
  }

  /** Returns the times from the publication of messages to what read them, in ns, by topic. */
  Map<String, List<Long>> waiting() {
    return waiting;
  }

  /** Returns the topics of which it read messages that are not known. */
  List<Unmatched> unmatched() {
    return unmatched.entrySet().stream()
        .map(it -> new Unmatched(it.getKey(), it.getValue(), taken.getOrDefault(it.getKey(), 0)))
        .toList();
  }

  /** Returns how many messages it read that were underway when the trace began, by topic. */
  Map<String, Integer> earlier() {
    return earlier;
  }

  /** Returns whether one of its outputs was written. */
  boolean writes() {
    return activations.stream().anyMatch(it -> !it.writes().isEmpty());
  }
}
