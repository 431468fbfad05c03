package dev.eventchain.pipeline.mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.sandbox.ComponentRules;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Optional;
import java.util.Queue;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Tests that the end of a mutant's process counts only if it comes again, and with the defect. */
class TestFailureTest {

  private static final TestFailure CRASH = failure("The process ended by signal 11.", true);
  private static final TestFailure KILLED = failure("The process ended by signal 9.", true);
  private static final TestFailure WRONG = failure("The result is 1 instead of 2.", false);

  private static TestFailure failure(String message, boolean ended) {
    Diagnostic finding = Diagnostic.of(ComponentRules.ENDED, message, SourceLocation.NONE);
    return new TestFailure("Braking", finding, ended);
  }

  /** Runs of a test, in which it fails as given; null if it passes. */
  private static Supplier<Optional<TestFailure>> runs(TestFailure... failures) {
    Queue<Optional<TestFailure>> left = new ArrayDeque<>();
    Arrays.stream(failures).map(Optional::ofNullable).forEach(left::add);
    return left::remove;
  }

  @Test
  void anEndThatComesAgainIsOfTheDefect() {
    assertTrue(CRASH.comesAgain(2, runs(null, null), runs(CRASH, CRASH)));
  }

  @Test
  void anEndThatComesOnceOrInAnotherWayProvesNothing() {
    assertFalse(CRASH.comesAgain(2, runs(null, null), runs(CRASH, (TestFailure) null)));
    assertFalse(CRASH.comesAgain(2, runs(null, null), runs(KILLED)));
  }

  /** The machine may have no memory left for the component as it is, either. */
  @Test
  void anEndWithoutTheDefectProvesNothing() {
    assertFalse(CRASH.comesAgain(2, runs(KILLED), runs(CRASH, CRASH)));
    assertFalse(CRASH.comesAgain(2, runs(null, CRASH), runs(CRASH, CRASH)));
  }

  @Test
  void aFailureWithoutTheDefectThatIsNoEndIsRefused() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class, () -> CRASH.comesAgain(2, runs(WRONG), runs(CRASH, CRASH)));
    Diagnostic finding = refused.diagnostics().get(0);
    assertEquals("mutation.unproved", finding.id());
    assertTrue(finding.message().endsWith(WRONG.finding().message()), finding.message());
  }
}
