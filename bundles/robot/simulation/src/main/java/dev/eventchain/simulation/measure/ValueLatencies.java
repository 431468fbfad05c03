package dev.eventchain.simulation.measure;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.RunLog.Answer;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Delay by which the values of components' outputs answer those of inputs later than their messages
 * say.
 *
 * <p>A value is late if no pulse of the input was answered in the same call or the next one, and
 * several of them equally late: so does a delay. What is answered late for another reason, such as
 * a count that goes on, is not equally late at different moments. Of the late outputs on a topic,
 * the earliest counts, since others may follow from it in a further step.
 */
public final class ValueLatencies {

  /** The number of equally late answers that show a delay. */
  private static final int ENOUGH = 3;

  private static final double MILLISECOND = 1e6;

  /**
   * A delay of values within a component.
   *
   * @param from the topic of the input
   * @param to the topic of the output
   * @param delay in ns
   * @param pulses the number of pulses that were answered that late
   */
  private record Late(
      SoftwareNode node,
      String from,
      String input,
      String to,
      String output,
      long delay,
      int pulses) {}

  private final SimulatedChain chain;
  private final List<Late> found = new ArrayList<>();

  private ValueLatencies(SimulatedChain chain) {
    this.chain = chain;
  }

  /** Returns the delays in the components, from the answers recorded in some runs. */
  public static ValueLatencies in(List<ScenarioRun> runs, SimulatedChain chain) {
    ValueLatencies latencies = new ValueLatencies(chain);
    for (SoftwareNode node : chain.nodes()) {
      Map<List<String>, List<Long>> delays = new LinkedHashMap<>();
      runs.stream()
          .flatMap(run -> run.log().answers().getOrDefault(node.getName(), List.of()).stream())
          .forEach(
              each -> delays.computeIfAbsent(key(each), it -> new ArrayList<>()).add(each.delay()));
      delays.forEach((key, each) -> latencies.add(node, key.get(0), key.get(1), each));
    }
    return latencies;
  }

  private static List<String> key(Answer answer) {
    return List.of(answer.input(), answer.output());
  }

  private void add(SoftwareNode node, String input, String output, List<Long> delays) {
    long least = delays.stream().mapToLong(Long::longValue).min().orElse(0);
    int pulses = (int) delays.stream().filter(delay -> delay == least).count();
    Optional<String> from = topic(node, node.getInput(), input);
    Optional<String> to = topic(node, node.getOutput(), output);
    boolean beyondNextCall = least > SimulatedChain.period(node) * MILLISECOND;
    if (beyondNextCall && pulses >= ENOUGH && from.isPresent() && to.isPresent()) {
      add(new Late(node, from.get(), input, to.get(), output, least, pulses));
    }
  }

  /** Keeps the earliest output of an input on each topic. */
  private void add(Late late) {
    Predicate<Late> same =
        it ->
            it.node().equals(late.node())
                && it.input().equals(late.input())
                && it.to().equals(late.to());
    if (found.stream().filter(same).noneMatch(other -> other.delay() <= late.delay())) {
      found.removeIf(same);
      found.add(late);
    }
  }

  private static Optional<String> topic(SoftwareNode node, List<Data> data, String name) {
    return data.stream()
        .filter(each -> name.equals(each.getName()))
        .findFirst()
        .flatMap(each -> TopicIndex.nameOf(each, node));
  }

  /** Returns a finding for each pair of topics between which a component delays values. */
  public List<Diagnostic> findings() {
    Map<List<Object>, Late> longest = new LinkedHashMap<>();
    for (Late late : found) {
      longest.merge(
          List.of(late.node(), late.from(), late.to()),
          late,
          (one, other) -> other.delay() > one.delay() ? other : one);
    }
    return longest.values().stream().map(ValueLatencies::finding).toList();
  }

  private static Diagnostic finding(Late late) {
    String name = late.node().getName();
    return Diagnostic.of(
            MeasureRules.VALUE_LATE,
            String.format(
                Locale.ROOT,
                "The value latency of '%s' is %.0f ms from '%s' (%s) to '%s' (%s): that much later"
                    + " than its messages say it answered %d changes of the value, and none sooner.",
                name,
                late.delay() / MILLISECOND,
                late.input(),
                late.from(),
                late.output(),
                late.to(),
                late.pulses()),
            SourceLocation.NONE.withElement(name))
        .withHint(
            "Compute an output from the inputs of the same call. Latency constraints count it.");
  }

  /** Returns a verdict whose latencies of constraints count the delays of values. */
  public ScenarioVerdict added(ScenarioVerdict verdict) {
    if (found.isEmpty()) {
      return verdict;
    }
    List<Optional<ScenarioVerdict.Latency>> latencies = new ArrayList<>();
    for (int i = 0; i < verdict.latencies().size(); i++) {
      LatencyConstraint constraint = chain.latencyConstraints().get(i);
      latencies.add(verdict.latencies().get(i).map(it -> it.withValues(delays(constraint))));
    }
    return verdict.withLatencies(latencies);
  }

  /** Returns the delays in the components on the path with the longest ones, in ms. */
  private Map<String, Double> delays(LatencyConstraint constraint) {
    Map<String, Double> delays = new LinkedHashMap<>();
    longest(constraint.getFirst(), Optional.empty(), constraint.getLast(), new HashSet<>())
        .orElse(List.of())
        .forEach(late -> delays.put(late.node().getName(), late.delay() / MILLISECOND));
    return delays;
  }

  /**
   * Returns the delays on the path with the longest ones; empty if there is no path.
   *
   * @param from the topic by which the path comes; empty for any
   * @param passed the components on the path so far
   */
  private Optional<List<Late>> longest(
      SoftwareNode node, Optional<String> from, SoftwareNode last, Set<SoftwareNode> passed) {
    if (node.equals(last)) {
      return Optional.of(in(node, from, Optional.empty()));
    }
    passed.add(node);
    Optional<List<Late>> longest = Optional.empty();
    for (String to : chain.topicsWrittenBy(node)) {
      for (SoftwareNode reader : chain.nodes()) {
        if (!passed.contains(reader) && chain.topicsReadBy(reader).contains(to)) {
          Optional<List<Late>> path =
              longest(reader, Optional.of(to), last, passed)
                  .map(rest -> joined(in(node, from, Optional.of(to)), rest));
          longest = sum(path) > sum(longest) ? path : longest;
        }
      }
    }
    passed.remove(node);
    return longest;
  }

  private static List<Late> joined(List<Late> first, List<Late> rest) {
    return Stream.concat(first.stream(), rest.stream()).toList();
  }

  private static long sum(Optional<List<Late>> path) {
    return path.map(each -> each.stream().mapToLong(Late::delay).sum()).orElse(-1L);
  }

  /** Returns the longest delay in a component between two topics, if there is one. */
  private List<Late> in(SoftwareNode node, Optional<String> from, Optional<String> to) {
    Optional<Late> longest = Optional.empty();
    for (Late late : found) {
      boolean fits =
          late.node().equals(node)
              && from.filter(topic -> !topic.equals(late.from())).isEmpty()
              && to.filter(topic -> !topic.equals(late.to())).isEmpty();
      if (fits && longest.filter(other -> other.delay() >= late.delay()).isEmpty()) {
        longest = Optional.of(late);
      }
    }
    return longest.stream().toList();
  }
}
