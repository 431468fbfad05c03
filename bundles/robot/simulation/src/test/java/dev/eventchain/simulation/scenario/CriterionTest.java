package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.States;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.function.LongFunction;
import java.util.function.LongToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests criteria on hand-written traces: TTC falls from 3 s at the start by 1 s each second. */
class CriterionTest {

  private static final long MILLISECOND = 1_000_000L;
  private static final double SPEED = 10;

  private static Trace approach(LongToDoubleFunction pedalAtMillisecond) {
    return trace(
        time -> States.of(time, SPEED, 30 - time / 1e8, 3 - time / 1e9, 0), pedalAtMillisecond);
  }

  private static Trace trace(LongFunction<Trace.State> state, LongToDoubleFunction pedal) {
    Trace trace = new Trace();
    for (long time = 0; time <= 2_800 * MILLISECOND; time += World.TRACE_STEP) {
      trace.state(state.apply(time));
      if (time % (50 * MILLISECOND) == 0) {
        trace.command(time, VehicleCommand.brake(pedal.applyAsDouble(time / MILLISECOND)));
      }
    }
    return trace;
  }

  private static boolean holds(CriterionKind kind, double limit, Trace trace) {
    return new Criterion(kind, limit, Criterion.Tolerances.USUAL, SourceLocation.NONE)
        .judge(trace)
        .passed();
  }

  @ParameterizedTest
  @CsvSource({"700,false", "850,false", "950,true", "1100,true", "5000,true"})
  void noBrakeBeforeTheLimitButForTheTolerance(long brakesFrom, boolean expected) {
    Trace trace = approach(millisecond -> millisecond >= brakesFrom ? 0.5 : 0);
    assertEquals(expected, holds(CriterionKind.NO_BRAKE_AT_TTC, 2, trace));
  }

  @ParameterizedTest
  @CsvSource({"900,true", "1350,true", "1450,false", "5000,false"})
  void brakeAfterTheLimitWithinTheReactionTime(long brakesFrom, boolean expected) {
    Trace trace = approach(millisecond -> millisecond >= brakesFrom ? 0.5 : 0);
    assertEquals(expected, holds(CriterionKind.BRAKE_BELOW_TTC, 2, trace));
  }

  @ParameterizedTest
  @CsvSource({"2300,0.5,true", "2300,1.0,true", "5000,0.5,false"})
  void fullBrakeMeansFull(long fullFrom, double partial, boolean expected) {
    Trace trace = approach(millisecond -> millisecond >= fullFrom ? 1 : partial);
    assertEquals(expected, holds(CriterionKind.FULL_BRAKE_BELOW_TTC, 1, trace));
  }

  @ParameterizedTest
  @CsvSource({"1500,false", "2000,true"})
  void noFullBrakeBeforeTheLimit(long fullFrom, boolean expected) {
    Trace trace = approach(millisecond -> millisecond >= fullFrom ? 1 : 0.5);
    assertEquals(expected, holds(CriterionKind.NO_FULL_BRAKE_AT_TTC, 1, trace));
  }

  @Test
  void brakeMayBeHeldForTheReactionTimeAfterTheDangerIsOver() {
    LongFunction<Trace.State> over =
        time -> States.of(time, SPEED, 20, time < 1_000 * MILLISECOND ? 1.5 : 9, 4.5);
    Trace soon = trace(over, millisecond -> millisecond < 1_250 ? 0.5 : 0);
    Trace late = trace(over, millisecond -> millisecond < 1_450 ? 0.5 : 0);
    assertEquals(true, holds(CriterionKind.NO_BRAKE_AT_TTC, 2, soon));
    assertEquals(false, holds(CriterionKind.NO_BRAKE_AT_TTC, 2, late));
  }

  @Test
  void brakingOrNotAtWalkingSpeedIsNotJudged() {
    LongFunction<Trace.State> standing = time -> States.of(time, 1, 0.5, 0.5, 0);
    assertEquals(false, tested(CriterionKind.BRAKE_BELOW_TTC, 2, trace(standing, time -> 0)));
    assertEquals(false, tested(CriterionKind.NO_BRAKE_AT_TTC, 0.1, trace(standing, time -> 1)));
  }

  /** A criterion whose premise never came true neither holds nor fails. */
  @ParameterizedTest
  @CsvSource({
    "NO_IMPACT, 0, false, true",
    "MINIMAL_GAP, 1, false, true",
    "MAXIMAL_IMPACT_SPEED, 1, false, true",
    "STOPS, 0, true, true",
    "NEVER_BRAKES, 0, true, true",
    "NO_BRAKE_AT_TTC, 2, true, true",
    "BRAKE_BELOW_TTC, 2, false, true",
    "BRAKE_BELOW_TTC, 0.1, false, false",
    "FULL_BRAKE_BELOW_TTC, 1, false, true",
    "NO_FULL_BRAKE_AT_TTC, 2.9, true, true",
    "NO_FULL_BRAKE_AT_TTC, 4, true, false"
  })
  void whatNeverCameUpIsNotTested(
      CriterionKind kind, double limit, boolean onEmptyRoad, boolean onApproach) {
    double nothing = Double.POSITIVE_INFINITY;
    Trace empty = trace(time -> States.of(time, SPEED, nothing, nothing, 0), time -> 0);
    assertEquals(onEmptyRoad, tested(kind, limit, empty));
    assertEquals(onApproach, tested(kind, limit, approach(time -> 0)));
  }

  @Test
  void withoutCommandsNothingIsSaidOfBraking() {
    Trace silent = new Trace();
    silent.state(States.of(0, 0, 20, 9, 0));
    for (CriterionKind kind :
        List.of(
            CriterionKind.NEVER_BRAKES,
            CriterionKind.BRAKE_NORMALIZED,
            CriterionKind.NO_BRAKE_AT_TTC,
            CriterionKind.STOPS)) {
      assertEquals(false, tested(kind, 1, silent), kind.toString());
    }
  }

  /** A vehicle that still moves may stop, and one that still drives may hit something. */
  @ParameterizedTest
  @CsvSource({
    "NEVER_BRAKES, 0, 700, true",
    "NEVER_BRAKES, 0, 5000, false",
    "NO_BRAKE_AT_TTC, 2, 700, true",
    "BRAKE_BELOW_TTC, 2, 5000, true",
    "BRAKE_BELOW_TTC, 2, 900, false",
    "MINIMAL_GAP, 5, 5000, true",
    "MINIMAL_GAP, 1, 5000, false",
    "NO_IMPACT, 0, 5000, false",
    "STOPS, 0, 5000, false",
  })
  void aBeginningViolatesWhatNothingCanMakeUpFor(
      CriterionKind kind, double limit, long brakesFrom, boolean expected) {
    Trace beginning = approach(millisecond -> millisecond >= brakesFrom ? 0.5 : 0);
    assertEquals(
        expected,
        new Criterion(kind, limit, Criterion.Tolerances.USUAL, SourceLocation.NONE)
            .isViolated(beginning));
  }

  @Test
  void aFirstCommandMayStillCome() {
    Trace silent = new Trace();
    silent.state(States.of(0, SPEED, 20, 9, 0));
    Criterion arrive =
        new Criterion(
            CriterionKind.COMMANDS_ARRIVE, 0, Criterion.Tolerances.USUAL, SourceLocation.NONE);
    assertEquals(true, arrive.judge(silent).failed());
    assertEquals(false, arrive.isViolated(silent));
  }

  private static boolean tested(CriterionKind kind, double limit, Trace trace) {
    return new Criterion(kind, limit, Criterion.Tolerances.USUAL, SourceLocation.NONE)
        .judge(trace)
        .tested();
  }

  @ParameterizedTest
  @CsvSource({"0.0,true", "1.0,true", "-0.1,false", "1.01,false", "NaN,false"})
  void brakeCommandsAreFromZeroToOne(double pedal, boolean expected) {
    assertEquals(expected, holds(CriterionKind.BRAKE_NORMALIZED, 0, approach(time -> pedal)));
  }

  @Test
  void silenceOfMoreThanASecondIsNoSuccess() {
    Trace silent = new Trace();
    Trace late = new Trace();
    Trace steady = new Trace();
    for (long time = 0; time <= 3_000 * MILLISECOND; time += World.TRACE_STEP) {
      for (Trace trace : new Trace[] {silent, late, steady}) {
        trace.state(States.of(time, SPEED, 20, 9, 0));
      }
    }
    late.command(500 * MILLISECOND, VehicleCommand.brake(0));
    for (long second = 0; second <= 3; second++) {
      steady.command(second * 900 * MILLISECOND, VehicleCommand.brake(0));
    }
    assertEquals(false, holds(CriterionKind.COMMANDS_ARRIVE, 0, silent));
    assertEquals(false, holds(CriterionKind.COMMANDS_ARRIVE, 0, late));
    assertEquals(true, holds(CriterionKind.COMMANDS_ARRIVE, 0, steady));
  }

  @Test
  void impactAndStopAreToldApart() {
    World hit = new World(EgoVehicle.withSpeed(10), java.util.List.of(Actor.passengerCar(5, 0, 0)));
    hit.advanceTo(1_000 * MILLISECOND);
    assertEquals(false, holds(CriterionKind.NO_IMPACT, 0, hit.trace()));
    assertEquals(false, holds(CriterionKind.STOPS, 0, hit.trace()));
    assertEquals(false, holds(CriterionKind.MINIMAL_GAP, 0.5, hit.trace()));
    assertEquals(false, holds(CriterionKind.MAXIMAL_IMPACT_SPEED, 9.9, hit.trace()));
    assertEquals(true, holds(CriterionKind.MAXIMAL_IMPACT_SPEED, 10.1, hit.trace()));

    World stopped =
        new World(EgoVehicle.withSpeed(10), java.util.List.of(Actor.passengerCar(50, 0, 0)));
    assertEquals(false, holds(CriterionKind.STOPS, 0, stopped.trace()));
    stopped.command(0, VehicleCommand.brake(1));
    stopped.advanceTo(5_000 * MILLISECOND);
    assertEquals(true, holds(CriterionKind.NO_IMPACT, 0, stopped.trace()));
    assertEquals(true, holds(CriterionKind.STOPS, 0, stopped.trace()));
    assertEquals(true, holds(CriterionKind.MINIMAL_GAP, 0.5, stopped.trace()));
    assertEquals(false, holds(CriterionKind.NEVER_BRAKES, 0, stopped.trace()));
  }
}
