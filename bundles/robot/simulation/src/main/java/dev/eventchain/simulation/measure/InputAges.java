package dev.eventchain.simulation.measure;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.LongUnaryOperator;

/**
 * Checks whether inputs were too old when a component was due. Generated nodes do not execute then,
 * so the scenario says nothing about the component.
 */
public final class InputAges {

  private static final double MILLISECOND = 1e6;

  /** The oldest sample with which a component was due, over all scenarios. */
  private record Worst(String scenario, long time, double age, long times) {

    Worst with(Worst other) {
      Worst older = other.age > age ? other : this;
      return new Worst(older.scenario, older.time, older.age, times + other.times);
    }
  }

  /**
   * A sample beyond its maximum age.
   *
   * @param node the node that lacked a newer input, or a newer command to write
   * @param time the time since when it was too old, or when the component was due, in ns
   * @param command true if it is a command that the vehicle still followed
   * @param words description for users
   */
  public record TooOld(String node, String topic, long time, boolean command, String words) {}

  private final SimulatedChain chain;
  private final List<ScenarioRun> runs;

  private InputAges(SimulatedChain chain, List<ScenarioRun> runs) {
    this.chain = chain;
    this.runs = runs;
  }

  /**
   * Returns a warning for each component and topic with a sample beyond its maximum age, with the
   * oldest one.
   */
  public static List<Diagnostic> in(List<ScenarioRun> runs, SimulatedChain chain) {
    InputAges ages = new InputAges(chain, runs);
    List<Diagnostic> found = new ArrayList<>();
    chain.nodes().forEach(node -> ages.check(node, found));
    chain.commands().forEach(topic -> ages.checkCommands(topic, found));
    return found;
  }

  /**
   * Returns all samples beyond their maximum age in a run, by nodes and topics, each in the order
   * of time.
   *
   * @param clock the nodes' clock at a time, both in ns
   */
  public static List<TooOld> tooOld(
      ScenarioRun run, SimulatedChain chain, LongUnaryOperator clock) {
    List<TooOld> found = new ArrayList<>();
    for (SoftwareNode node : chain.nodes()) {
      limits(node, chain)
          .forEach(
              (topic, limit) ->
                  tooOld(run, node, topic, limit, clock)
                      .forEach(it -> found.add(input(node, topic, limit, it))));
    }
    for (String topic : chain.commands()) {
      double limit = chain.lifetime(topic) / MILLISECOND;
      if (limit > 0) {
        silences(run, topic, limit)
            .forEach(it -> found.add(command(chain.writer(topic), topic, limit, it)));
      }
    }
    return found;
  }

  private static TooOld input(SoftwareNode node, String topic, double limit, Worst worst) {
    String instead =
        node.getOutput().stream().allMatch(output -> output.getSafeValue() != null)
            ? "published its safe values"
            : "did not execute";
    String words =
        String.format(
            Locale.ROOT,
            "'%s' %s, as %s was %.0f ms old by its clock, and %.0f ms are allowed",
            node.getName(),
            instead,
            topic,
            worst.age(),
            limit);
    return new TooOld(node.getName(), topic, worst.time(), false, words);
  }

  private static TooOld command(String writer, String topic, double limit, Worst worst) {
    long since = worst.time() - Math.round((worst.age() - limit) * MILLISECOND);
    String words =
        String.format(
            Locale.ROOT,
            "no command came on %s for more than the usual %.0f ms, and the vehicle followed the"
                + " last one",
            topic,
            limit);
    return new TooOld(writer, topic, since, true, words);
  }

  private void check(SoftwareNode node, List<Diagnostic> found) {
    limits(node, chain)
        .forEach(
            (topic, limit) ->
                runs.stream()
                    .flatMap(run -> tooOld(run, node, topic, limit, time -> time).stream())
                    .reduce(Worst::with)
                    .ifPresent(
                        worst -> {
                          boolean rare = 2L * worst.times() < activations(node);
                          found.add(finding(node, topic, limit, worst, rare));
                        }));
  }

  /** Returns the maximum ages of a component's inputs, in ms, for the topics that have a limit. */
  static Map<String, Double> limits(SoftwareNode node, SimulatedChain chain) {
    Map<String, Double> limits = new LinkedHashMap<>();
    for (Data input : node.getInput()) {
      TopicIndex.nameOf(input, node)
          .ifPresent(
              topic -> {
                double limit =
                    input.isSetMaximumAge() ? input.getMaximumAge() : chain.usualAge(topic);
                if (limit > 0) {
                  limits.merge(topic, limit, Math::min);
                }
              });
    }
    return limits;
  }

  /** Returns how often a component was due in all scenarios. */
  private long activations(SoftwareNode node) {
    return runs.stream()
        .mapToLong(run -> run.log().nodes().getOrDefault(node.getName(), List.of()).size())
        .sum();
  }

  /**
   * Returns whether the model states a maximum age of the input, and the substitute for each
   * output: the component is designed for a silent topic.
   */
  private static boolean isPlannedFor(SoftwareNode node, String topic) {
    return node.getOutput().stream().allMatch(output -> output.getSafeValue() != null)
        && node.getInput().stream()
            .filter(input -> TopicIndex.nameOf(input, node).filter(topic::equals).isPresent())
            .allMatch(Data::isSetMaximumAge);
  }

  /** Checks the commands; the vehicle follows the last command, whatever its age. */
  private void checkCommands(String topic, List<Diagnostic> found) {
    double limit = chain.lifetime(topic) / MILLISECOND;
    if (limit > 0) {
      runs.stream()
          .flatMap(run -> silences(run, topic, limit).stream())
          .reduce(Worst::with)
          .ifPresent(worst -> found.add(finding(chain.writer(topic), topic, limit, worst)));
    }
  }

  private static List<Worst> silences(ScenarioRun run, String topic, double limit) {
    List<Long> times = new ArrayList<>(run.log().publicationsOf(topic).values());
    List<Worst> found = new ArrayList<>();
    for (int i = 0; i < times.size(); i++) {
      long until = i + 1 < times.size() ? times.get(i + 1) : run.trace().end().time();
      double age = (until - times.get(i)) / MILLISECOND;
      if (age > limit) {
        found.add(new Worst(run.scenario().name(), until, age, 1));
      }
    }
    return found;
  }

  private static Diagnostic finding(String writer, String topic, double limit, Worst worst) {
    return Diagnostic.of(
            MeasureRules.INPUT_TOO_OLD,
            String.format(
                Locale.ROOT,
                "Scenario %s: the last command on %s was %.0f ms old after %.2f s, and the vehicle"
                    + " still followed it; %.0f ms are usual. In all scenarios, this happened %d"
                    + " times.",
                worst.scenario(),
                topic,
                worst.age(),
                World.seconds(worst.time()),
                limit,
                worst.times()),
            SourceLocation.NONE.withElement(writer))
        .withHint("Find out why the component fell silent; another vehicle may release the brake.");
  }

  /**
   * Returns the samples beyond their maximum age; negative ages, after a clock jump, count as too
   * old.
   */
  private static List<Worst> tooOld(
      ScenarioRun run, SoftwareNode node, String topic, double limit, LongUnaryOperator clock) {
    List<Worst> found = new ArrayList<>();
    for (Activation activation : run.log().nodes().getOrDefault(node.getName(), List.of())) {
      for (SampleId read : activation.reads()) {
        if (read.topic().equals(topic)) {
          long then = run.log().time(read);
          long jumped = clock.applyAsLong(activation.start()) - clock.applyAsLong(then);
          double age = jumped / MILLISECOND;
          boolean backwards = age < 0 && jumped != activation.start() - then;
          if (age > limit || backwards) {
            found.add(new Worst(run.scenario().name(), activation.start(), age, 1));
          }
        }
      }
    }
    return found;
  }

  private static Diagnostic finding(
      SoftwareNode node, String topic, double limit, Worst worst, boolean rare) {
    SourceLocation place = SourceLocation.NONE.withElement(node.getName());
    String text =
        String.format(
            Locale.ROOT,
            "Scenario %s: %s was %.0f ms old when '%s' was due after %.2f s; at most %.0f ms are"
                + " allowed. In all scenarios, this happened %d times.",
            worst.scenario(),
            topic,
            worst.age(),
            node.getName(),
            World.seconds(worst.time()),
            limit,
            worst.times());
    if (rare && isPlannedFor(node, topic)) {
      return Diagnostic.of(MeasureRules.INPUT_TOO_OLD, text, place)
          .withSeverity(Severity.INFO)
          .withHint("The safe values of the model were published instead.");
    }
    return Diagnostic.of(MeasureRules.INPUT_TOO_OLD, text, place)
        .withHint(
            "Write the topic more often, allow a greater maximumAge, or state safe values for what"
                + " the component writes.");
  }
}
