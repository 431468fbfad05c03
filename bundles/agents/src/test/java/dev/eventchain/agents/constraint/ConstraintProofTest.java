package dev.eventchain.agents.constraint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.constraints.ConstraintProof;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** A proof terminates for any generated constraint. */
class ConstraintProofTest {

  @Test
  void aConstraintThatTakesTooLongIsNotProved() {
    String text =
        """
        context EventChain
          inv Slow: Sequence{1..5000}->forAll(a, b |
            Sequence{1..5000}->forAll(c, d | a + b + c + d > 0 or name <> 'x'))
        """;
    OclConstraint constraint =
        OclRules.parse(
                List.of(SourceText.of("slow.ocl", text)), List.of(EventchainPackage.eINSTANCE))
            .constraints()
            .get(0);
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    chain.setName("a");
    assertEquals(
        Optional.of(
            new ConstraintProof.Objection(
                false,
                false,
                List.of(),
                "No model was found in the time available for which 'Slow' holds")),
        ConstraintProof.objection(
            constraint, List.of(chain), TimeBudget.of(Duration.ofMillis(100))));
  }
}
