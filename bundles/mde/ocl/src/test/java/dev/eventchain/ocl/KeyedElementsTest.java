package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * Tests that loops with lookup by key, and values that are kept for all elements, are the same as
 * those over all elements.
 */
class KeyedElementsTest {

  private static final int THINGS = 40;

  private final EPackage metamodel = new TestModels("everything").metamodel();
  private final EClass type = (EClass) metamodel.getEClassifier("Thing");
  private final List<EObject> things = things();

  private List<EObject> things() {
    List<Object> colours =
        ((EEnum) metamodel.getEClassifier("Colour"))
            .getELiterals().stream().map(each -> (Object) each.getInstance()).toList();
    List<String> names = Arrays.asList("a", "b", "", null, "abz");
    List<EObject> made = new ArrayList<>();
    for (int i = 0; i < THINGS; i++) {
      EObject thing = EcoreUtil.create(type);
      made.add(thing);
      set(thing, "name", i < 5 ? names.get(i) : "n" + i / 2);
      set(thing, "whole", i % 7);
      set(thing, "real", i % 3 * 0.5);
      set(thing, "flag", i % 2 == 0);
      set(thing, "colour", colours.get(i % colours.size()));
      if (i > 0) {
        set(thing, "next", made.get(i / 3));
        add(made.get(i % 2 == 0 ? 0 : i / 2), "parts", thing);
      }
    }
    new ResourceImpl().getContents().add(made.get(0));
    return made;
  }

  private void set(EObject thing, String feature, Object value) {
    thing.eSet(type.getEStructuralFeature(feature), value);
  }

  @SuppressWarnings("unchecked") // what the metamodel declares
  private void add(EObject thing, String feature, Object value) {
    ((Collection<Object>) thing.eGet(type.getEStructuralFeature(feature))).add(value);
  }

  @TestFactory
  Stream<DynamicTest> valuesAreThoseOfEclipseOcl() throws IOException {
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
    TestDefinitions.define(language, type, LoweringTest.DEFINITIONS);
    return Files.readAllLines(Path.of("src", "test", "resources", "keyed.txt")).stream()
        .map(text -> DynamicTest.dynamicTest(text, () -> compare(language, text)));
  }

  private void compare(ExpressionLanguage language, String text) {
    Expression expression = parse(language, text);
    StockEvaluator stock = new StockEvaluator(language.environment());
    Evaluation remembering = Evaluations.over(things);
    Evaluation forgetting = Evaluations.over(things).withChangingModel();
    for (EObject self : things) {
      Object expected = LoweringTest.normal(evaluate(expression, self, forgetting), true);
      Object found = LoweringTest.normal(evaluate(expression, self, remembering), true);
      assertEquals(expected, found);
      Object original = stock.evaluate(expression.ast(), self);
      if (stock.differences().isEmpty()) {
        Object unordered = evaluate(expression, self, remembering);
        assertEquals(LoweringTest.normal(original, false), LoweringTest.normal(unordered, false));
      }
    }
  }

  private Expression parse(ExpressionLanguage language, String text) {
    List<Diagnostic> problems = new ArrayList<>();
    return language
        .parse(SourceText.of("", text).whole(), language.root().with("self", type), problems)
        .orElseThrow(() -> new AssertionError(problems.toString()));
  }

  private static Object evaluate(Expression expression, EObject self, Evaluation run) {
    run.bind("self", self);
    try {
      return expression.evaluate(run);
    } finally {
      run.unbind("self");
    }
  }

  /** An operation that counts its calls. */
  private record Counting(AtomicInteger calls, boolean isRepeatable)
      implements OperationLibrary, OperationLibrary.Implementation {
    @Override
    public Optional<Operation> lookup(
        TypeSystem language, EClassifier source, String name, List<EClassifier> types) {
      return name.equals("code")
          ? Optional.of(new Operation(name, language.type("Integer"), this))
          : Optional.empty();
    }

    @Override
    public Object call(Object source, List<Object> arguments, Evaluation run) {
      calls.incrementAndGet();
      return System.identityHashCode(source);
    }
  }

  private int calls(String body, boolean repeatable, boolean changing) {
    Counting counting = new Counting(new AtomicInteger(), repeatable);
    Dialect dialect =
        new Dialect() {
          @Override
          public List<OperationLibrary> libraries() {
            return List.of(counting);
          }
        };
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel), dialect);
    Expression expression = parse(language, "Thing.allInstances()->" + body);
    Evaluation run = Evaluations.over(things);
    if (changing) {
      run.withChangingModel();
    }
    for (EObject self : things) {
      evaluate(expression, self, run);
    }
    return counting.calls().get();
  }

  @Test
  void aKeyIsAskedForOnceAndNotForEachPair() {
    String body = "select(x | x.whole > 100 or x.code() = self.code())";
    assertTrue(calls(body, true, false) >= THINGS * THINGS);
    body = "select(x | x.code() = self.code())";
    // All for the first element, then once for the index, then only for its matches.
    assertTrue(calls(body, true, false) < 8 * THINGS);
    body = "forAll(x | x.whole > 100 or x.code() <> self.code())";
    assertTrue(calls(body, true, false) < 8 * THINGS);
  }

  @Test
  void whatIsTheSameForAllElementsIsComputedOnce() {
    assertEquals(THINGS, calls("isUnique(x | x.code())", true, false));
    assertEquals(THINGS, calls("collect(x | x.code() + 1)->sum() + self.whole", true, false));
    String each = "collect(x | x.code())->includes(self.whole)"; // templates may get each call
    assertEquals(THINGS * THINGS, calls(each, true, false));
  }

  @Test
  void whatIsInvalidForAllElementsIsComputedOnceAndExplainedForEach() {
    // Once to evaluate, and once more to explain.
    String body = "collect(x | x.code())->asSequence()->at(0)";
    assertEquals(2 * THINGS, calls(body + " + self.whole", true, false));
    assertTrue(calls(body + " + self.whole", true, true) >= 2 * THINGS * THINGS);
    Expression expression =
        parse(
            ExpressionLanguage.of(List.of(metamodel)),
            "Thing.allInstances()->" + body.replace("code()", "whole"));
    Evaluation run = Evaluations.over(things);
    for (EObject self : things) {
      Invalid invalid = assertInstanceOf(Invalid.class, evaluate(expression, self, run));
      assertEquals(
          "'at' has no result for a collection of 40 (index: 0, size: 40)", invalid.reason());
    }
  }

  @Test
  void whatHasEffectsIsAskedEachTime() {
    String body = "select(x | x.code() = self.code())";
    assertTrue(calls(body, false, false) >= THINGS * THINGS);
    assertEquals(THINGS * THINGS, calls("isUnique(x | x.code())", false, false));
  }

  @Test
  void nothingIsRememberedOfAModelThatChanges() {
    String body = "select(x | x.code() = self.code())";
    assertTrue(calls(body, true, true) >= THINGS * THINGS);
    assertEquals(THINGS * THINGS, calls("isUnique(x | x.code())", true, true));
  }
}
