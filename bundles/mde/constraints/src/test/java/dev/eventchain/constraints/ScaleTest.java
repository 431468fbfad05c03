package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import java.time.Duration;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests large models, and rules that do not terminate. */
class ScaleTest {

  private final EPackage metamodel = new TestModels("machine").metamodel();

  private EObject machine(int states) {
    return TestModels.machine(metamodel, states);
  }

  private OclResult validate(String rules, EObject root, Duration limit) {
    OclRules parsed =
        OclRules.parse(List.of(SourceText.of("rules.ocl", rules)), List.of(metamodel));
    assertEquals(List.of(), parsed.diagnostics());
    return OclValidator.of(parsed)
        .withTimeLimit(limit)
        .validate(List.of(root), element -> SourceLocation.NONE);
  }

  @Test
  void longChainsDoNotOverflow() {
    OclResult result =
        validate(
            """
            context State
              def: rest() : Integer = if fallback = null then 0 else 1 + fallback.rest() endif
              inv Rest: name <> 's0' or rest() = 1499
              inv Closure: name <> 's0' or self->closure(next)->size() = 1499
            """,
            machine(1500),
            Duration.ofSeconds(60));
    assertEquals(List.of(), result.diagnostics());
    assertEquals(3000, result.evaluations());
  }

  @Test
  void aRuleThatTakesTooLongIsGivenUpAndTheOthersGoOn() {
    OclResult result =
        validate(
            """
            context Machine
              inv Slow: states->forAll(a, b | states->forAll(c, d | a <> b or c <> d or true))
              inv Fast: states->size() = 300
            """,
            machine(300),
            Duration.ofMillis(200));
    assertEquals(1, result.diagnostics().size());
    Diagnostic slow = result.diagnostics().get(0);
    assertEquals("ocl.limit", slow.id());
    assertEquals("Machine::Slow", slow.rule());
    assertEquals(
        "'Slow' was abandoned at Machine /: it takes more than 200 ms of processor time. It left 1"
            + " of 1 element unchecked.",
        slow.message());
    assertEquals(2, result.evaluations());
  }
}
