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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that expressions that grow or run without end are abandoned before memory runs out. */
class LimitsTest {

  private static final String DEFINITIONS =
      """
      context Machine
        def: longer(s : String) : String = self.longer(s.concat(s))
        def: more(s : Sequence(Integer)) : Sequence(Integer) = self.more(s->union(s))
        def: endless(n : Integer) : Integer = self.again(n + 1)
        def: again(n : Integer) : Integer = self.endless(n)
        inv A: %s
        inv Fine: true
      """;

  private final EPackage metamodel = new TestModels("machine").metamodel();
  private final EObject machine = TestModels.machine(metamodel, 2500);

  private Diagnostic find(String condition, Duration limit) {
    OclRules rules =
        OclRules.parse(
            List.of(SourceText.of("rules.ocl", DEFINITIONS.formatted(condition))),
            List.of(metamodel));
    assertEquals(List.of(), rules.diagnostics());
    OclResult result =
        OclValidator.of(rules)
            .withTimeLimit(limit)
            .validate(List.of(machine), element -> SourceLocation.NONE);
    assertEquals(2, result.evaluations());
    assertEquals(1, result.diagnostics().size(), () -> result.diagnostics().toString());
    return result.diagnostics().get(0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '#',
      value = {
        "Sequence{1..2147483647}->size() > 0 # collection of more than 4000000 elements",
        "Sequence{1..2147483647, 3}->size() > 0 # collection of more than 4000000 elements",
        "Set{-2147483647..2147483647}->size() > 0 # collection of more than 4000000 elements",
        "OrderedSet{1..2147483647}->sum() > 0 # collection of more than 4000000 elements",
        "Bag{1..2147483647}->sum() > 0 # collection of more than 4000000 elements",
        "State.allInstances()->collect(x | State.allInstances())->size() > 3"
            + " # collection of more than 4000000 elements",
        "Sequence{1..30}->iterate(i; s : String = 'aa' | s.substituteAll('a', 'aa')).size() > 0"
            + " # string of more than 16000000 characters",
        "Sequence{1..4000}->collectNested(i | Sequence{1..4000})->flatten()->size() > 0"
            + " # collection of more than 4000000 elements",
        "Sequence{1..40}->iterate(i; s : Sequence(Integer) = Sequence{1} | s->union(s))->size() > 3"
            + " # collection of more than 4000000 elements",
        "Sequence{1..3000}->product(Sequence{1..3000})->size() > 3"
            + " # collection of more than 4000000 elements",
        "Sequence{1}->closure(i | i + 1)->size() > 3 # collection of more than 4000000 elements",
        "self.more(Sequence{1})->size() > 3 # collection of more than 4000000 elements",
        "Sequence{1..40}->iterate(i; s : String = 'x' | s.concat(s)).size() > 3"
            + " # string of more than 16000000 characters",
        "Sequence{1..40}->iterate(i; s : String = 'x' | s + s).size() > 3"
            + " # string of more than 16000000 characters",
        "self.longer('x').size() > 3 # string of more than 16000000 characters",
        "self.endless(1) > 3 # it recurses endlessly"
      })
  void growthIsLimited(String condition, String reason) {
    Diagnostic found = find(condition, Duration.ofMinutes(2));
    assertEquals("ocl.limit Machine::A", found.id() + " " + found.rule());
    assertEquals(
        true,
        found.message().contains(reason.strip()),
        () -> "not as expected: " + found.message());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaab'.matches('(.*a){25}')",
        "'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaab'.replaceAll('(.*a){25}c', 'x') = 'x'",
        "states->forAll(a, b | states->forAll(c, d | a <> b or c <> d or true))",
        "states->iterate(a; n : Integer = 0 | n + states->select(b | states->exists(c | c = b and"
            + " c.name = a.name))->size()) < 0"
      })
  void timeIsLimited(String condition) {
    Diagnostic found = find(condition, Duration.ofMillis(300));
    assertEquals("ocl.limit Machine::A", found.id() + " " + found.rule());
  }

  @Test
  void theValuesOfAMessageAreShort() {
    Diagnostic found =
        find(
            "let s : String = Sequence{1..20}->iterate(i; s : String = 'xy' | s.concat(s)) in"
                + " s.size() < 3 or s = 'x' or states->isEmpty()",
            Duration.ofMinutes(1));
    assertEquals("ocl.violated", found.id());
    assertEquals(
        "Machine / violates 'A': s.size() is 2097152, s is '"
            + "xy".repeat(38)
            + "x...' and states is {State 's0', State 's1', State 's2', State 's3', State 's4',"
            + " State 's5', 2494 more}.",
        found.message());
  }
}
