package dev.eventchain.pipeline.simulate;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.FaultVerdict.Detection;
import dev.eventchain.simulation.verdict.FaultVerdict.Vehicle;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/** The results of faults for the report and {@code verdict.json}. */
final class FaultReport {

  private static final double KMH = 3.6;

  /** Largest distance in metres of the same position. */
  private static final double SAME_PLACE = 1e-3;

  private FaultReport() {}

  /** Returns one object per fault. */
  static ArrayNode of(SimulationResult result) {
    ArrayNode all = JsonNodeFactory.instance.arrayNode();
    result.faults().forEach(fault -> add(all.addObject(), fault));
    return all;
  }

  private static void add(ObjectNode json, FaultVerdict fault) {
    json.put("name", fault.name()).put("scenario", fault.scenario());
    json.put("injected", fault.injected()).put("effect", fault.effect());
    json.put("effective", fault.effective()).put("judged", fault.judged());
    json.put("tested", fault.tested()).put("passed", fault.passed());
    json.put("detected", fault.detected()).put("text", text(fault));
    vehicle(json.putObject("vehicle"), fault.vehicle());
    vehicle(json.putObject("without"), fault.without());
    json.putObject("deviation")
        .put("distance", rounded(fault.deviation().distance()))
        .put("time", rounded(fault.deviation().time()));
    criteria(json.putArray("criteria"), fault.own());
    criteria(json.putArray("expected"), fault.expected());
    ArrayNode detections = json.putArray("detections");
    for (Detection each : fault.detections()) {
      ObjectNode one =
          detections.addObject().put("by", each.means().name().toLowerCase(Locale.ROOT));
      one.put("id", each.id()).put("element", each.element()).put("text", each.words());
      number(one, "time", each.time());
    }
    fault.ended().map(Diagnostic::message).ifPresent(why -> json.put("ended", why));
    json.put("line", fault.location().line());
  }

  private static void vehicle(ObjectNode json, Vehicle vehicle) {
    json.put("did", did(vehicle));
    number(json, "impact_speed", vehicle.impactSpeed());
    if (!vehicle.impact().isEmpty()) {
      json.put("impact", vehicle.impact());
    }
    number(json, "stopped", vehicle.stopped());
    number(json, "minimal_gap", vehicle.minimalGap());
    json.put("speed", rounded(vehicle.speed())).put("end", rounded(vehicle.end()));
  }

  private static void criteria(ArrayNode json, List<CriterionResult> criteria) {
    for (CriterionResult each : criteria) {
      ObjectNode one = json.addObject().put("text", each.text());
      one.put("tested", each.tested()).put("passed", each.passed());
      one.put("measured", each.measured());
    }
  }

  private static void number(ObjectNode json, String name, OptionalDouble value) {
    value.ifPresent(it -> json.put(name, rounded(it)));
  }

  private static double rounded(double value) {
    return Math.round(value * 1e4) / 1e4;
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
