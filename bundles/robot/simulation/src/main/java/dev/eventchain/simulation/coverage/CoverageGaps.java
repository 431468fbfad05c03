package dev.eventchain.simulation.coverage;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.coverage.SignalCoverage.Gap;
import dev.eventchain.simulation.coverage.SignalCoverage.Kind;
import dev.eventchain.simulation.coverage.SignalCoverage.Missing;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Gaps in what the scenarios have shown of the signals of a chain. Left out are signals of which
 * nobody would expect more: outputs that neither a component nor a formula reads, what a sensor
 * says of itself, and signals of components that no requirement is about.
 */
final class CoverageGaps {

  /** The most names of values that a gap lists. */
  private static final int NAMED = 5;

  private final SimulatedChain chain;
  private final List<SignalCoverage> signals;
  private final Set<String> read;
  private final Sides sides;

  CoverageGaps(SimulatedChain chain, Collection<Scenario> scenarios, List<SignalCoverage> signals) {
    this.chain = chain;
    this.signals = signals;
    this.sides = new Sides(signals);
    this.read =
        scenarios.stream()
            .flatMap(each -> each.signals().stream())
            .map(Signal::name)
            .collect(Collectors.toSet());
  }

  /** Returns the signals with their gaps. */
  List<SignalCoverage> marked() {
    return signals.stream().map(each -> each.withGaps(gaps(each))).toList();
  }

  private List<Gap> gaps(SignalCoverage signal) {
    List<Gap> gaps = new ArrayList<>();
    if (isOfRequirements(signal) && (signal.isInput() || isUsedOnEitherSide(signal))) {
      value(signal).ifPresent(gaps::add);
      again(signal).ifPresent(gaps::add);
      element(signal).ifPresent(gaps::add);
      side(signal).ifPresent(gaps::add);
    }
    return gaps;
  }

  private boolean isOfRequirements(SignalCoverage signal) {
    return chain.nodes().stream()
        .filter(node -> !node.getSatisfies().isEmpty())
        .anyMatch(
            node ->
                chain.topicsReadBy(node).contains(signal.topic())
                    || chain.topicsWrittenBy(node).contains(signal.topic()));
  }

  private boolean isUsedOnEitherSide(SignalCoverage signal) {
    return isUsed(signal) || sides.of(signal).stream().anyMatch(this::isUsed);
  }

  private boolean isUsed(SignalCoverage output) {
    return read.contains(output.name())
        || isDriving(output)
        || chain.nodes().stream().anyMatch(node -> reads(node, output));
  }

  private boolean isDriving(SignalCoverage output) {
    Bench.Consumed taken = chain.bench().consumed().get(output.topic());
    return taken != null
        && taken.fields().stream()
            .anyMatch(each -> each.actuator().isPresent() && each.path().equals(output.path()));
  }

  private static boolean reads(SoftwareNode node, SignalCoverage output) {
    String path = output.path().replace("[]", "");
    return node.getInput().stream()
        .filter(each -> TopicIndex.nameOf(each, node).filter(output.topic()::equals).isPresent())
        .anyMatch(
            each -> each.getFieldName() != null && RosNames.overlap(each.getFieldName(), path));
  }

  private Optional<Gap> value(SignalCoverage signal) {
    if (signal.kind() == Kind.TRUTH || signal.kind() == Kind.NAMED) {
      return signal.missing().isEmpty() || (signal.isInput() && isOfSensor(signal))
          ? Optional.empty()
          : Optional.of(new Gap(Missing.VALUE, named(signal)));
    }
    return signal.kind() == Kind.NUMBER && signal.least() == signal.most() && isComputed(signal)
        ? Optional.of(
            new Gap(Missing.VALUE, "anything but " + Figures.of(signal.least(), signal.unit())))
        : Optional.empty();
  }

  private static String named(SignalCoverage signal) {
    List<String> missing = signal.missing();
    String first = String.join(", ", missing.subList(0, Math.min(NAMED, missing.size())));
    return missing.size() > NAMED ? first + " and " + (missing.size() - NAMED) + " more" : first;
  }

  /** Returns whether a sensor says it of itself, such as the order of bytes in a point cloud. */
  private boolean isOfSensor(SignalCoverage input) {
    Bench.Provided provided = chain.bench().provided().get(input.topic());
    return provided == null
        || ((provided.lidar() || provided.scanner().isPresent())
            && field(provided, input).isEmpty());
  }

  private static Optional<Bench.Field> field(Bench.Provided provided, SignalCoverage input) {
    return provided.fields().stream().filter(it -> it.path().equals(input.path())).findFirst();
  }

  /** Returns whether the bench computes an input from the world, so that it may change. */
  private boolean isComputed(SignalCoverage signal) {
    Bench.Provided provided = chain.bench().provided().get(signal.topic());
    if (!signal.isInput() || provided == null) {
      return false;
    }
    return signal.isOfElements()
        ? provided.objects().filter(it -> it.varies(column(signal))).isPresent()
        : field(provided, signal).filter(it -> it.source() instanceof Bench.Quantity).isPresent();
  }

  /** Returns the path of the elements of a list as the bench has it. */
  private static String column(SignalCoverage elements) {
    String path = elements.path();
    return path.endsWith("[]") ? path.substring(0, path.length() - 2) : path;
  }

  private Optional<Gap> again(SignalCoverage signal) {
    boolean ends =
        switch (signal.kind()) {
          case TRUTH, NAMED -> signal.seen().size() > 1;
          case NUMBER -> signal.episodes() > 0 && isTaken(signal);
          case LIST -> false;
        };
    boolean expected =
        !signal.isInput() || sides.of(signal).stream().anyMatch(each -> each.episodes() > 1);
    return ends && expected && signal.episodes() <= 1 && !signal.isOfElements()
        ? Optional.of(new Gap(Missing.AGAIN, "a second time"))
        : Optional.empty();
  }

  private boolean isTaken(SignalCoverage signal) {
    return !signal.isInput() && chain.bench().consumed().containsKey(signal.topic());
  }

  private Optional<Gap> element(SignalCoverage signal) {
    if (signal.kind() != Kind.LIST || signal.most() > 1) {
      return Optional.empty();
    }
    Bench.Provided provided = chain.bench().provided().get(signal.topic());
    boolean grows =
        signal.isInput()
            ? provided != null && provided.objects().isPresent()
            : signal.least() < signal.most();
    return grows
        ? Optional.of(
            new Gap(Missing.ELEMENT, signal.most() < 1 ? "an element" : "a second element"))
        : Optional.empty();
  }

  private Optional<Gap> side(SignalCoverage signal) {
    if (signal.kind() != Kind.NUMBER) {
      return Optional.empty();
    }
    return Stream.of(
            sides.less(signal),
            isComputed(signal) || isTaken(signal) ? Sides.sign(signal) : Optional.<String>empty())
        .flatMap(Optional::stream)
        .findFirst()
        .map(words -> new Gap(Missing.SIDE, words));
  }
}
