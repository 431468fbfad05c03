package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.SimulatedFault;
import dev.eventchain.pipeline.results.SimulatedFault.Deviation;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.FaultVerdict.Detection;
import dev.eventchain.simulation.verdict.FaultVerdict.Vehicle;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The results of faults for the report and {@code verdict.json}. */
final class FaultReport {

  private static final double KMH = 3.6;

  /** Largest distance in metres of the same position. */
  private static final double SAME_PLACE = 1e-3;

  private FaultReport() {}

  /** Returns the result of each fault. */
  static List<SimulatedFault> of(SimulationResult result) {
    return result.faults().stream().map(FaultReport::of).toList();
  }

  private static SimulatedFault of(FaultVerdict fault) {
    return new SimulatedFault(
        fault.name(),
        fault.scenario(),
        fault.injected(),
        fault.effect(),
        fault.effective(),
        fault.judged(),
        fault.tested(),
        fault.passed(),
        fault.detected(),
        text(fault),
        vehicle(fault.vehicle()),
        vehicle(fault.without()),
        new Deviation(
            Rounding.rounded(fault.deviation().distance()),
            Rounding.rounded(fault.deviation().time())),
        criteria(fault.own()),
        criteria(fault.expected()),
        fault.detections().stream().map(FaultReport::detection).toList(),
        fault.ended().map(Diagnostic::message),
        fault.location().line());
  }

  private static SimulatedFault.Detection detection(Detection each) {
    return new SimulatedFault.Detection(
        each.means().name().toLowerCase(Locale.ROOT),
        each.id(),
        each.element(),
        each.words(),
        Rounding.rounded(each.time()));
  }

  private static SimulatedFault.Vehicle vehicle(Vehicle vehicle) {
    return new SimulatedFault.Vehicle(
        did(vehicle),
        Rounding.rounded(vehicle.impactSpeed()),
        Optional.of(vehicle.impact()).filter(impact -> !impact.isEmpty()),
        Rounding.rounded(vehicle.stopped()),
        Rounding.rounded(vehicle.minimalGap()),
        Rounding.rounded(vehicle.speed()),
        Rounding.rounded(vehicle.end()));
  }

  private static List<Criterion> criteria(List<CriterionResult> criteria) {
    return criteria.stream()
        .map(
            each ->
                new Criterion(
                    each.text(),
                    each.tested(),
                    each.passed(),
                    each.measured(),
                    Optional.empty(),
                    List.of(),
                    List.of(),
                    Optional.empty(),
                    Optional.empty()))
        .toList();
  }

  /** Returns a short description of a vehicle's behaviour. */
  private static String did(Vehicle vehicle) {
    if (vehicle.impactSpeed().isPresent()) {
      return format(
          "impact at %.1f km/h after %.2f s",
          vehicle.impactSpeed().getAsDouble() * KMH, vehicle.end());
    }
    String motion =
        vehicle.stopped().isPresent()
            ? format("stopped after %.2f s", vehicle.stopped().getAsDouble())
            : format("%.1f km/h at the end, after %.2f s", vehicle.speed() * KMH, vehicle.end());
    return vehicle.minimalGap().isPresent()
        ? motion + format(", smallest gap %.2f m", vehicle.minimalGap().getAsDouble())
        : motion;
  }

  /** Returns the result of a fault, in a sentence. */
  private static String text(FaultVerdict fault) {
    if (!fault.effective()) {
      return fault.scenario() + ": no effect, " + fault.effect();
    }
    String did = did(fault.vehicle());
    String without = did(fault.without());
    String moved =
        fault.ended().isPresent()
            ? "the run was ended: " + fault.ended().get().message()
            : fault.deviation().distance() < SAME_PLACE && did.equals(without)
                ? "the vehicle moved as without it"
                : did + " (without: " + without + ")";
    return fault.scenario() + ": " + moved + "; " + detected(fault) + expectation(fault);
  }

  private static String detected(FaultVerdict fault) {
    return fault.detections().stream()
        .findFirst()
        .map(FaultReport::detected)
        .orElse("not detected");
  }

  private static String detected(Detection first) {
    String by =
        switch (first.means()) {
          case SOFTWARE -> "by the software";
          case CHECK -> "by a check of the simulation only";
          case FAILURE -> "by a failure";
        };
    String when =
        first.time().isPresent() ? format(" after %.2f s", first.time().getAsDouble()) : "";
    return "detected " + by + when + ": " + first.words();
  }

  private static String expectation(FaultVerdict fault) {
    if (!fault.judged()) {
      return "; not judged";
    }
    return fault.expected().stream()
        .filter(each -> !each.passed())
        .findFirst()
        .map(
            each ->
                "; %s: %s (%s)"
                    .formatted(
                        each.tested() ? "not met" : "not tested", each.text(), each.measured()))
        .orElse("");
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
