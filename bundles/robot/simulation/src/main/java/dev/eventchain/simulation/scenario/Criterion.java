package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Limit;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * A requirement on a scenario.
 *
 * @param kind the kind of the requirement
 * @param limit the limit, in SI units; unused by kinds without one
 * @param tolerances tolerances for the sensors and the chain
 * @param location its location in the scenario
 * @param requirements ids of the requirements that it tests
 */
public record Criterion(
    CriterionKind kind,
    double limit,
    Tolerances tolerances,
    SourceLocation location,
    List<String> requirements)
    implements Expectation {

  /** Returns whether it asks for no impact, or for none that is faster than a speed. */
  public boolean limitsImpacts() {
    return kind == CriterionKind.NO_IMPACT || kind == CriterionKind.MAXIMAL_IMPACT_SPEED;
  }

  /** Copies the list. */
  public Criterion {
    requirements = List.copyOf(requirements);
  }

  /** Creates a criterion that names no requirement. */
  Criterion(CriterionKind kind, double limit, Tolerances tolerances, SourceLocation location) {
    this(kind, limit, tolerances, location, List.of());
  }

  /**
   * Tolerances of a comparison with the true time to collision.
   *
   * @param timeToCollision for the noise of the sensors, in s
   * @param reaction maximum delay of the command behind the true values, in s
   */
  record Tolerances(double timeToCollision, double reaction) {

    /** 0.1 s; and 250 ms of the chain after at most 50 ms until the next scan. */
    static final Tolerances USUAL = new Tolerances(0.1, 0.3);
  }

  /**
   * Returns whether it depends on topics; criteria of every scenario do not count for requirements.
   */
  @Override
  public boolean dependsOn(Set<String> topics, boolean commanding) {
    return commanding && !kind.always();
  }

  /**
   * Returns beyond every run if nothing may happen up to its end; otherwise standstill is enough.
   */
  @Override
  public long horizon() {
    return kind == CriterionKind.NEVER_BRAKES ? Long.MAX_VALUE : 0;
  }

  @Override
  public boolean isOfEveryScenario() {
    return kind.always();
  }

  @Override
  public Criterion testing(List<String> ids) {
    return new Criterion(kind, limit, tolerances, location, ids);
  }

  @Override
  public Outcome judge(Trace trace) {
    return switch (kind) {
      case NO_IMPACT -> ImpactRules.noImpact(trace);
      case STOPS -> ImpactRules.stops(trace);
      case MINIMAL_GAP -> ImpactRules.minimalGap(trace, limit);
      case MAXIMAL_IMPACT_SPEED -> ImpactRules.maximalImpactSpeed(trace, limit);
      case NEVER_BRAKES -> ImpactRules.neverBrakes(trace);
      case NO_BRAKE_AT_TTC -> BrakingRules.forbidden(trace, this, Trace.Command::brakes);
      case BRAKE_BELOW_TTC -> BrakingRules.demanded(trace, this, Trace.Command::brakes, 0.0);
      case NO_FULL_BRAKE_AT_TTC -> BrakingRules.forbidden(trace, this, Trace.Command::brakesFully);
      case FULL_BRAKE_BELOW_TTC ->
          BrakingRules.demanded(trace, this, Trace.Command::brakesFully, Trace.FULL);
      case BRAKE_NORMALIZED -> ImpactRules.brakeNormalized(trace);
      case COMMANDS_ARRIVE -> BrakingRules.commandsArrive(trace);
    };
  }

  @Override
  public boolean isViolated(Trace beginning) {
    return switch (kind) {
      // A vehicle that moves may stop, and a command may come.
      case STOPS, COMMANDS_ARRIVE -> false;
      default -> judge(beginning).failed();
    };
  }

  @Override
  public String text() {
    return switch (kind) {
      case NO_IMPACT -> "no impact";
      case STOPS -> "the vehicle stops";
      case MINIMAL_GAP -> String.format(Locale.ROOT, "the gap is never below %.2f m", limit);
      case MAXIMAL_IMPACT_SPEED ->
          String.format(Locale.ROOT, "any impact is at %.1f km/h or less", limit * 3.6);
      case NEVER_BRAKES -> "no braking at all";
      case NO_BRAKE_AT_TTC ->
          String.format(Locale.ROOT, "no braking while TTC is %.1f s or more", limit);
      case BRAKE_BELOW_TTC ->
          String.format(Locale.ROOT, "braking while TTC is below %.1f s", limit);
      case NO_FULL_BRAKE_AT_TTC ->
          String.format(Locale.ROOT, "no full braking while TTC is %.1f s or more", limit);
      case FULL_BRAKE_BELOW_TTC ->
          String.format(Locale.ROOT, "full braking while TTC is below %.1f s", limit);
      case BRAKE_NORMALIZED -> "brake commands are from 0 to 1";
      case COMMANDS_ARRIVE -> "control commands arrive at least once a second";
    };
  }

  @Override
  public List<Limit> limits() {
    if (kind.comparesTimeToCollision()) {
      return List.of(new Limit("ttc", limit));
    }
    return kind == CriterionKind.MINIMAL_GAP ? List.of(new Limit("gap", limit)) : List.of();
  }
}
