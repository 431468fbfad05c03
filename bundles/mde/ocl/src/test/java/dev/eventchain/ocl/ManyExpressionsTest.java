package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests many expressions, threads and elements. */
class ManyExpressionsTest {

  private final EPackage metamodel = new TestModels("machine").metamodel();

  private EObject machine(int states) {
    return TestModels.machine(metamodel, states);
  }

  @Test
  void parsingLeavesNothingBehindThatLaterParsesSearch() {
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
    Scope scope = language.root().with("self", metamodel.getEClassifier("State"));
    int afterFew = 0;
    for (int i = 0; i < 500; i++) {
      String text =
          "let a : Integer = " + i + " in self.next->select(s | s.name <> 'x')->size() > a";
      List<Diagnostic> problems = new ArrayList<>();
      assertTrue(
          language.parse(SourceText.of("", text).whole(), scope, problems).isPresent(),
          problems::toString);
      language.parse(SourceText.of("", "self.x + ").whole(), scope, problems);
      language.type("Sequence(State)");
      if (i == 10) {
        afterFew = language.environment().roots();
      }
    }
    assertEquals(afterFew, language.environment().roots());
  }

  @Test
  void threadsShareExpressionsAndExtents() throws Exception {
    EObject machine = machine(50);
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
    Scope scope =
        language
            .root()
            .with("self", metamodel.getEClassifier("State"))
            .with("n", language.type("Integer"));
    String text =
        "let m : Integer = n in State.allInstances()->select(s | s.name <> self.name)->collect(s |"
            + " s.name.concat(m.toString()))->asSet()->asSequence()->first()";
    Expression expression =
        language.parse(SourceText.of("", text).whole(), scope, new ArrayList<>()).orElseThrow();
    Evaluation shared = Evaluations.over(List.of(machine));
    List<Callable<Object>> tasks = new ArrayList<>();
    for (int i = 0; i < 400; i++) {
      int number = i;
      tasks.add(
          () -> {
            Evaluation run = shared.fork();
            run.bind("self", TestModels.listOf(machine, "states").get(number % 2));
            run.bind("n", number);
            return expression.evaluate(run);
          });
    }
    ExecutorService threads = Executors.newFixedThreadPool(8);
    try {
      List<Future<Object>> results = threads.invokeAll(tasks);
      for (int i = 0; i < results.size(); i++) {
        assertEquals((i % 2 == 0 ? "s1" : "s0") + i, results.get(i).get());
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void setsOfObjectsAreWalkedInTheOrderOfTheModelWhateverTheirHashCodes() {
    EObject machine = machine(50);
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
    Scope scope = language.root().with("self", machine.eClass());
    String text =
        "states->asSet()->select(s | s.name <> 's7')->union(states->asSet())->asSequence().name";
    Evaluation run = Evaluations.over(List.of(machine));
    run.bind("self", machine);
    Object names =
        language
            .parse(SourceText.of("", text).whole(), scope, new ArrayList<>())
            .orElseThrow()
            .evaluate(run);
    List<String> expected = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      if (i != 7) {
        expected.add("s" + i);
      }
    }
    expected.add("s7");
    assertEquals(expected, names);
  }
}
