package dev.eventchain.contracts.latency;

import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.math.BigDecimal;
import java.util.Optional;
import java.util.OptionalLong;

/** Times that a component states, in ns where nothing else is said. */
final class NodeTimes {

  private static final double SECOND = 1e9;
  private static final double MILLISECOND = 1e6;

  /** Times that are longer, some days, are as good as unknown, and sums of shorter ones exact. */
  private static final double LONGEST = 1e15;

  private NodeTimes() {}

  /** Returns whether the timer of a generated node activates it. */
  static boolean isComponent(SoftwareNode node) {
    return node.getImplementation() == ComponentImplementation.COMPONENT;
  }

  /** Returns the period by the stated frequency, rounded up. */
  static OptionalLong period(SoftwareNode node) {
    double period = SECOND / node.getFrequency();
    return node.isSetFrequency() && period > 0 && period < LONGEST
        ? OptionalLong.of((long) Math.ceil(period))
        : OptionalLong.empty();
  }

  /** Returns the period of a component, rounded down: how often it may keep others waiting. */
  static OptionalLong shortestPeriod(SoftwareNode node) {
    long period = (long) (SECOND / node.getFrequency());
    return isComponent(node) && period(node).isPresent() && period > 0
        ? OptionalLong.of(period)
        : OptionalLong.empty();
  }

  /** Returns the worst-case execution time, rounded up; empty unless it is stated and above 0. */
  static OptionalLong execution(SoftwareNode node) {
    double time = node.getWorstCaseExecutionTime() * MILLISECOND;
    return node.isSetWorstCaseExecutionTime() && time > 0 && time < LONGEST
        ? OptionalLong.of((long) Math.ceil(time))
        : OptionalLong.empty();
  }

  /** Returns whether an execution may take longer than the period. */
  static boolean isOverloaded(SoftwareNode node) {
    OptionalLong period = period(node);
    return period.isPresent()
        && node.getWorstCaseExecutionTime() * MILLISECOND > period.getAsLong();
  }

  /** Returns the part of a processor's time that a component takes at most, without rounding. */
  static Optional<BigDecimal> utilisation(SoftwareNode node) {
    double frequency = node.getFrequency();
    double execution = node.getWorstCaseExecutionTime();
    return isComponent(node)
            && isAboveZero(node.isSetFrequency(), frequency)
            && isAboveZero(node.isSetWorstCaseExecutionTime(), execution)
        ? Optional.of(
            BigDecimal.valueOf(execution).multiply(BigDecimal.valueOf(frequency)).movePointLeft(3))
        : Optional.empty();
  }

  private static boolean isAboveZero(boolean set, double number) {
    return set && number > 0 && Double.isFinite(number);
  }
}
