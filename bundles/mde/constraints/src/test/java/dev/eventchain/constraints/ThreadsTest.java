package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.metamodel.Names;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests that several threads find the same as one, and that none is left running. */
class ThreadsTest {

  private static final int STATES = 6000;

  private final EPackage metamodel = new TestModels("machine").metamodel();
  private final EObject machine = TestModels.machine(metamodel, STATES);

  private OclRules rules(String text) {
    OclRules rules = OclRules.parse(List.of(SourceText.of("rules.ocl", text)), List.of(metamodel));
    assertEquals(List.of(), rules.diagnostics());
    return rules;
  }

  private static SourceLocation locate(EObject element) {
    return SourceLocation.of("model.xmi").withElement(Names.pathOf(element));
  }

  private OclResult validate(OclRules rules, int threads) {
    return OclValidator.of(rules)
        .withThreads(threads)
        .validate(List.of(machine), ThreadsTest::locate);
  }

  @Test
  void oneAndEightThreadsFindTheSame() {
    OclRules rules =
        rules(
            """
            context Machine
              inv Size: states->size() < 100
            context State
              def: rest() : Integer = if fallback = null then 0 else 1 + fallback.rest() endif
              def: number : Integer = name.substring(2, name.size()).toInteger()
              inv Violated: not name.matches('s.*7')
              inv Undefined: fallback.name.size() > 1
              inv Text: name.toInteger() > 0
              inv GivenUp: number < 1000 or rest() >= 0
              inv GivenUpAtOnce: rest() >= 0
              inv Deep: number < 4500 or rest() < 1490
              inv Fine: State.allInstances()->includes(self)
              inv Equal: Set{next, State.allInstances()->asSequence()->first()->asSet()}->size() > 1
            """);
    OclResult one = validate(rules, 1);
    assertEquals(one, validate(rules, 8));
    assertEquals(one, validate(rules, 3));
    assertEquals(
        List.of("1", "6000", "6000", "6000", "1001", "1", "6000", "6000", "6000"),
        one.checks().stream().map(each -> String.valueOf(each.evaluations())).toList());
    assertEquals(
        List.of("ocl.limit=2", "ocl.undefined=6001", "ocl.violated=611"),
        one.diagnostics().stream()
            .collect(Collectors.groupingBy(Diagnostic::id, Collectors.counting()))
            .entrySet()
            .stream()
            .map(Object::toString)
            .sorted()
            .toList());
  }

  @Test
  void theTimeLimitHoldsForAConstraintOnTheWholeModel() {
    OclRules rules =
        rules(
            """
            context State
              inv Slow: State.allInstances()->forAll(a, b | a <> b or a = b or a.name = self.name)
              inv Fast: name <> ''
            """);
    OclResult result =
        OclValidator.of(rules)
            .withThreads(4)
            .withTimeLimit(Duration.ofMillis(300))
            .validate(List.of(machine), ThreadsTest::locate);
    assertEquals(1, result.diagnostics().size());
    Diagnostic slow = result.diagnostics().get(0);
    assertEquals("ocl.limit State::Slow", slow.id() + " " + slow.rule());
    assertTrue(slow.message().contains("it takes more than 300 ms of processor time. It left "));
    assertEquals(STATES, result.checks().get(1).evaluations());
  }

  @Test
  void onlyFindingsAreLocatedOneAtATime() {
    AtomicInteger inside = new AtomicInteger();
    List<String> located = new ArrayList<>();
    OclResult result =
        OclValidator.of(
                rules("context State inv A: name.size() > 4 inv B: name.size() > 3 inv C: true"))
            .withThreads(8)
            .validate(
                List.of(machine),
                element -> {
                  assertEquals(1, inside.incrementAndGet());
                  located.add(Names.label(element));
                  inside.decrementAndGet();
                  return SourceLocation.NONE;
                });
    assertEquals(1000 + 100, located.size());
    assertEquals(1100, result.diagnostics().size());
  }

  @Test
  void anInterruptionEndsAllThreads() throws Exception {
    OclRules rules =
        rules(
            """
            context State
              inv Endless: Sequence{1, 2}->forAll(a | State.allInstances()->forAll(b, c | b <> c or a > 0))
              inv Located: false
            """);
    CountDownLatch begun = new CountDownLatch(1);
    AtomicReference<Throwable> ended = new AtomicReference<>();
    Thread validation =
        new Thread(
            () -> {
              OclValidator validator = OclValidator.of(rules).withThreads(4);
              begun.countDown();
              ended.set(
                  assertThrows(
                      IllegalStateException.class,
                      () -> validator.validate(List.of(machine), ThreadsTest::locate)));
            });
    validation.start();
    begun.await();
    while (workers().isEmpty()) {
      Thread.onSpinWait();
    }
    validation.interrupt();
    validation.join();
    assertEquals(List.of(), workers());
    assertEquals("interrupted while evaluating", ended.get().getMessage());
  }

  private static List<Thread> workers() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(each -> each.getName().startsWith("eventchain-ocl") && each.isAlive())
        .toList();
  }

  @Test
  void aFailureEndsTheValidationAndIsPassedOn() {
    IllegalArgumentException thrown =
        assertThrows(
            IllegalArgumentException.class,
            () ->
                OclValidator.of(rules("context State inv A: false inv B: false"))
                    .withThreads(4)
                    .validate(
                        List.of(machine),
                        element -> {
                          throw new IllegalArgumentException("no place");
                        }));
    assertEquals("no place", thrown.getMessage());
    assertEquals(List.of(), workers());
  }
}
