package dev.eventchain.simulation.measure;

import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.measure.HopLog.Passed;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.Function;

/** Sums up the message flow of scenarios. */
public final class MessageFlows {

  private static final double MILLISECOND = 1e6;

  private final SimulatedChain chain;
  private final List<ScenarioRun> runs;
  private final List<HopLog> logs;

  private MessageFlows(SimulatedChain chain, List<ScenarioRun> runs) {
    this.chain = chain;
    this.runs = runs;
    this.logs = runs.stream().map(run -> new HopLog(run.log())).toList();
  }

  /** Returns the message flow of the scenarios together. */
  public static MessageFlow of(List<ScenarioRun> runs, SimulatedChain chain) {
    if (chain.isAttached()) { // reads and losses are not visible
      return new MessageFlow(List.of(), List.of(), List.of());
    }
    MessageFlows flows = new MessageFlows(chain, runs);
    List<ChainHop> hops = ChainHop.of(chain);
    return new MessageFlow(
        hops.stream().map(flows::hop).toList(),
        chain.nodes().stream().map(flows::processing).toList(),
        hops.stream().map(ChainHop::topic).distinct().map(flows::topic).toList());
  }

  private MessageFlow.Hop hop(ChainHop hop) {
    List<Passed> passed =
        logs.stream()
            .map(log -> log.passed(hop.topic(), hop.writer(), hop.reader()))
            .filter(Passed::isKnown)
            .toList();
    List<Long> ages = passed.stream().flatMap(each -> each.ages().stream()).toList();
    List<Long> gaps =
        logs.stream().flatMap(log -> log.gaps(hop.topic(), hop.writer()).stream()).toList();
    return new MessageFlow.Hop(
        hop.topic(),
        hop.writer(),
        hop.reader(),
        statistics(passed.stream().flatMap(each -> each.waiting().stream()).toList()),
        statistics(ages),
        passed.stream().map(Passed::samples).reduce(MessageFlows::together),
        exceeded(ages, hop.maximumAge()),
        exceeded(gaps, hop.deadline()));
  }

  private static MessageFlow.Samples together(MessageFlow.Samples one, MessageFlow.Samples other) {
    return new MessageFlow.Samples(
        one.published() + other.published(),
        one.read() + other.read(),
        one.neverRead() + other.neverRead(),
        one.unreadAtEnd() + other.unreadAtEnd());
  }

  /** Counts the times beyond a limit; empty without times or without a limit. */
  private static Optional<MessageFlow.Exceeded> exceeded(List<Long> times, OptionalDouble limit) {
    if (times.isEmpty() || limit.isEmpty()) {
      return Optional.empty();
    }
    double most = limit.getAsDouble();
    long beyond = times.stream().filter(time -> time / MILLISECOND > most).count();
    return Optional.of(new MessageFlow.Exceeded(most, beyond, times.size()));
  }

  private MessageFlow.Processing processing(SoftwareNode node) {
    List<Long> times =
        logs.stream().flatMap(log -> log.processing(node.getName()).stream()).toList();
    return new MessageFlow.Processing(node.getName(), statistics(times));
  }

  private MessageFlow.Topic topic(String name) {
    boolean isProvided = chain.bench().provided().containsKey(name);
    return new MessageFlow.Topic(
        name,
        published(name),
        isProvided ? OptionalLong.of(sum(run -> run.trace().dropped(name))) : OptionalLong.empty(),
        OptionalLong.of(sum(run -> run.lost().getOrDefault(name, 0L))));
  }

  /** Returns the number of published messages; unknown if no activation of a writer was logged. */
  private OptionalLong published(String topic) {
    long count = sum(run -> (long) run.log().publicationsOf(topic).size());
    boolean isKnown =
        chain.bench().provided().containsKey(topic)
            || chain.writers(topic).stream()
                .anyMatch(node -> logs.stream().anyMatch(log -> log.isActive(node)));
    return count > 0 || isKnown ? OptionalLong.of(count) : OptionalLong.empty();
  }

  private long sum(Function<ScenarioRun, Long> count) {
    return runs.stream().mapToLong(count::apply).sum();
  }

  private static Optional<Measurements.Statistics> statistics(Collection<Long> nanoseconds) {
    return Measurements.Statistics.of(
        nanoseconds.stream().mapToDouble(value -> value / MILLISECOND).toArray());
  }
}
