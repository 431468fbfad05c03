package dev.eventchain.pipeline.simulate;

import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclConstraint.Verdict;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.ocl.Expression.Navigation;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Decides whether the result of a constraint depends on measured values. A constraint that holds
 * for all values, such as a {@code forAll} over an empty collection of latencies, tests nothing.
 */
final class MeasuredValues {

  private static final EventchainPackage METAMODEL = EventchainPackage.eINSTANCE;

  /** Classes of the elements that a simulation adds to a chain. */
  private static final Set<EClass> MEASURED =
      Set.of(
          METAMODEL.getChainMeasurement(),
          METAMODEL.getLatencyMeasurement(),
          METAMODEL.getLatencyPart(),
          METAMODEL.getMeasurement(),
          METAMODEL.getNodeMeasurement(),
          METAMODEL.getStatistics());

  /** Values that are tried for each number on its own. */
  private static final List<Double> EXTREMES = List.of(-1e300, -1.0, 0.0, 1e300);

  /** A measured number or Boolean of the model. */
  private record Slot(EObject owner, EAttribute attribute) {}

  private final EventChain chain;
  private final List<EObject> elements = new ArrayList<>();

  /**
   * Creates the values of a measured model.
   *
   * @param measured the measured model; not modified
   */
  MeasuredValues(EventChain measured) {
    chain = EcoreUtil.copy(measured);
    elements.add(chain);
    for (TreeIterator<EObject> all = chain.eAllContents(); all.hasNext(); ) {
      elements.add(all.next());
    }
  }

  /**
   * Returns whether other measured values can violate a constraint that holds; true if it reads
   * none.
   *
   * @param constraint a constraint that holds for all elements of the model
   * @param budget the time limit of the search; on timeout, the result is false
   */
  boolean decide(OclConstraint constraint, TimeBudget budget) {
    Set<EStructuralFeature> read = new LinkedHashSet<>();
    constraint.navigations().stream().map(Navigation::feature).forEach(read::add);
    read.removeIf(feature -> !isMeasuredValue(feature));
    if (read.isEmpty() || !(constraint.context() instanceof EClass type)) {
      return true;
    }
    List<Slot> slots = slots(read);
    List<EObject> subjects = elements.stream().filter(type::isInstance).toList();
    for (double value : sweep()) {
      if (fails(constraint, subjects, slots, value, budget)) {
        return true;
      }
    }
    for (Slot slot : slots) {
      for (double value : EXTREMES) {
        if (fails(constraint, subjects, List.of(slot), value, budget)) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns whether a feature is a measured value; names and units are not. */
  private static boolean isMeasuredValue(EStructuralFeature feature) {
    if (!(feature instanceof EAttribute attribute)
        || !MEASURED.contains(attribute.getEContainingClass())) {
      return false;
    }
    Class<?> type = attribute.getEAttributeType().getInstanceClass();
    return type == double.class || type == int.class || type == boolean.class;
  }

  private List<Slot> slots(Set<EStructuralFeature> read) {
    List<Slot> slots = new ArrayList<>();
    for (EObject element : elements) {
      for (EAttribute attribute : element.eClass().getEAllAttributes()) {
        if (read.contains(attribute) && (!attribute.isUnsettable() || element.eIsSet(attribute))) {
          slots.add(new Slot(element, attribute));
        }
      }
    }
    return slots;
  }

  /**
   * Returns zero, and 1, 2 and 5 with both signs in all magnitudes of times, speeds and distances.
   */
  private static List<Double> sweep() {
    List<Double> values = new ArrayList<>(EXTREMES);
    for (double magnitude = 1e-6; magnitude < 1e10; magnitude *= 10) {
      for (double digit : new double[] {1, 2, 5}) {
        values.add(digit * magnitude);
        values.add(-digit * magnitude);
      }
    }
    return values;
  }

  private static boolean fails(
      OclConstraint constraint,
      List<EObject> subjects,
      List<Slot> slots,
      double value,
      TimeBudget budget) {
    Map<Slot, Object> before = new LinkedHashMap<>();
    for (Slot slot : slots) {
      before.put(slot, slot.owner().eGet(slot.attribute()));
      slot.owner().eSet(slot.attribute(), valueOf(slot, value));
    }
    try {
      for (EObject subject : subjects) {
        if (constraint.evaluate(subject, budget) != Verdict.TRUE) {
          return !budget.isSpent();
        }
      }
      return false;
    } finally {
      before.forEach((slot, old) -> slot.owner().eSet(slot.attribute(), old));
    }
  }

  private static Object valueOf(Slot slot, double value) {
    Class<?> type = slot.attribute().getEAttributeType().getInstanceClass();
    if (type == boolean.class) {
      return value > 0;
    }
    return type == int.class ? (Object) (int) value : (Object) value;
  }
}
