package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests time limits with simulated clocks, so that the speed of the machine does not matter. */
class TimeLimitTest {

  private static final int STATES = 200;
  private static final String SLOW =
      "State.allInstances()->forAll(a, b | a <> b or a = b or a = self)";

  private final EPackage metamodel = new TestModels("machine").metamodel();
  private final EObject machine = TestModels.machine(metamodel, STATES);

  /** Clocks that advance with each reading. */
  private static final class Clock implements TimeBudget.Clock {
    private final long wallStep;
    private final long processorStep;
    private final AtomicLong wall = new AtomicLong();
    private final AtomicLong processor = new AtomicLong();

    Clock(Duration wallStep, Duration processorStep) {
      this.wallStep = wallStep.toNanos();
      this.processorStep = processorStep.toNanos();
    }

    @Override
    public long wall() {
      return wall.addAndGet(wallStep);
    }

    @Override
    public long processor() {
      return processor.addAndGet(processorStep);
    }
  }

  private OclResult validate(String constraints, Duration limit, TimeBudget.Clock clock) {
    OclRules rules =
        OclRules.parse(List.of(SourceText.of("rules.ocl", constraints)), List.of(metamodel));
    assertEquals(List.of(), rules.diagnostics());
    return OclValidator.of(rules)
        .withTimeLimit(limit)
        .withClock(clock)
        .validate(List.of(machine), element -> SourceLocation.NONE);
  }

  @Test
  void aBusyMachineTurnsNoGoodConstraintIntoOneThatTakesTooLong() {
    String constraint = "context State inv Good: " + SLOW;
    Clock clock = new Clock(Duration.ofMillis(100), Duration.ofMillis(1));
    Duration limit = Duration.ofMinutes(5);
    OclResult result = validate(constraint, limit, clock);
    assertTrue(clock.wall() > limit.multipliedBy(2).toNanos());
    assertEquals(List.of(), result.diagnostics());
    assertEquals(STATES, result.evaluations());
  }

  @Test
  void whatWaitsWithoutEndIsGivenUp() {
    String constraint = "context State inv Waiting: " + SLOW;
    OclResult result =
        validate(
            constraint,
            Duration.ofMillis(500),
            new Clock(Duration.ofMillis(1000), Duration.ofMillis(0)));
    assertEquals(1, result.diagnostics().size());
    Diagnostic found = result.diagnostics().get(0);
    assertEquals("ocl.limit State::Waiting", found.id() + " " + found.rule());
    assertEquals(
        "'Waiting' was abandoned at State 's5': it takes more than 600 s. It left 195 of 200"
            + " elements unchecked.",
        found.message());
  }

  @Test
  void shortEvaluationsAddUp() {
    String constraint =
        "context State inv Quadratic: State.allInstances()->forAll(a | a.name.size() > 0 and self <> null)";
    OclResult result =
        validate(
            constraint,
            Duration.ofMillis(300),
            new Clock(Duration.ofMillis(20), Duration.ofMillis(10)));
    assertEquals(1, result.diagnostics().size());
    Diagnostic found = result.diagnostics().get(0);
    assertEquals(Severity.ERROR, found.severity());
    assertEquals("rules.ocl:1:15", found.location().toString());
    long checked = result.evaluations() - 1;
    assertTrue(checked > 1 && checked < STATES - 1, () -> checked + " of " + STATES);
    assertEquals(
        String.format(
                Locale.ROOT,
                "'Quadratic' was abandoned at State 's%d': it takes more than 300 ms of processor time. It",
                checked)
            + String.format(Locale.ROOT, " left %d of 200 elements unchecked.", STATES - checked),
        found.message());
  }

  @Test
  void theWholeValidationHasALimitToo() {
    StringBuilder constraints = new StringBuilder("context State\n");
    for (int i = 1; i <= 6; i++) {
      constraints.append(String.format(Locale.ROOT, "inv Slow%d: %s\n", i, SLOW));
    }
    constraints.append("inv Fine: true\n");
    OclResult result =
        validate(
            constraints.toString(),
            Duration.ofMillis(300),
            new Clock(Duration.ofMillis(20), Duration.ofMillis(10)));
    List<String> messages =
        result.diagnostics().stream()
            .map(found -> found.message().replaceFirst(".* at (State '\\w*'): ", "$1: "))
            .toList();
    String alone =
        "State 's0': it takes more than 300 ms of processor time. It left 200 of 200 elements"
            + " unchecked.";
    String together =
        "State 's0': all constraints together take more than 1200 ms of processor time. It left"
            + " 200 of 200 elements unchecked.";
    // The fourth has time of its own left, but the others overran the common limit.
    assertEquals(List.of(alone, alone, alone, together, together, together, together), messages);
    assertEquals(
        List.of(1L, 1L, 1L, 1L, 0L, 0L, 0L),
        result.checks().stream().map(OclResult.Check::evaluations).toList());
  }
}
