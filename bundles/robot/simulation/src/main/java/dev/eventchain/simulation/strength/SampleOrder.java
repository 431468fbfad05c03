package dev.eventchain.simulation.strength;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.verdict.Strength;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Function;

/**
 * The order in which faults are tried, so that its beginning is a sample of all: first those of a
 * component that does nothing, then one of each component in turn, of its outputs in turn, and of
 * the kinds of change in turn.
 */
final class SampleOrder {

  private final Map<Object, Integer> components = new HashMap<>();
  private final Map<Object, Integer> outputs = new HashMap<>();
  private final Map<Object, Integer> changes = new HashMap<>();

  private SampleOrder() {}

  /** Returns faults in this order; equal ones stay in theirs. */
  static <T> List<T> of(List<T> items, Function<T, OutputFault> faults) {
    List<T> left = new ArrayList<>(items);
    List<T> ordered = new ArrayList<>();
    items.stream().filter(each -> faults.apply(each).isOmission()).forEach(ordered::add);
    left.removeAll(ordered);
    SampleOrder taken = new SampleOrder();
    while (!left.isEmpty()) {
      T next = left.stream().min(Comparator.comparing(faults, taken.rarest())).orElseThrow();
      left.remove(next);
      taken.add(faults.apply(next));
      ordered.add(next);
    }
    return ordered;
  }

  /**
   * Returns the first faults that may count for requirements with a bound, so many that none of
   * them is compared with it on a few, in the same order.
   *
   * @param ordered the faults that were not tried, in their order
   * @param requirements what counts for each bound so far
   */
  static <T> List<T> missing(
      List<T> ordered,
      List<Strength.Requirement> requirements,
      BiPredicate<Strength.Requirement, T> counts) {
    Set<T> chosen = new HashSet<>();
    for (Strength.Requirement requirement : requirements) {
      List<T> own = ordered.stream().filter(each -> counts.test(requirement, each)).toList();
      long shared = own.stream().filter(chosen::contains).count();
      own.stream()
          .filter(each -> !chosen.contains(each))
          .limit(Math.max(0, requirement.missing() - shared))
          .toList()
          .forEach(chosen::add);
    }
    return ordered.stream().filter(chosen::contains).toList();
  }

  /** Returns the order of those that are next: what has been taken least often comes first. */
  private Comparator<OutputFault> rarest() {
    return Comparator.comparing((OutputFault each) -> count(components, each.node()))
        .thenComparing(each -> count(outputs, output(each)))
        .thenComparing(each -> count(changes, each.change()));
  }

  private void add(OutputFault fault) {
    components.merge(fault.node(), 1, Integer::sum);
    outputs.merge(output(fault), 1, Integer::sum);
    changes.merge(fault.change(), 1, Integer::sum);
  }

  private static int count(Map<Object, Integer> taken, Object key) {
    return taken.getOrDefault(key, 0);
  }

  /** Returns the output of a fault; the whole message is one beside its fields. */
  private static List<String> output(OutputFault fault) {
    return List.of(fault.node(), fault.topic(), fault.field());
  }
}
