package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.Run;
import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Values;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.ShrinkingMode;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.ocl.util.Bag;
import org.eclipse.ocl.util.Tuple;

/**
 * Tests that lowered and traced expressions have the values of Eclipse OCL, in the same order.
 * Takes about 25 s.
 *
 * <p>Not compared with Eclipse OCL: expressions whose value depends on the order of a set or a bag,
 * and those with one of the {@link StockDifferences}.
 */
class LoweringTest {

  static final List<String> DEFINITIONS =
      List.of(
          "def: load : Real = if whole > 2 then real else partial / 2 endif",
          "def: sameName(other : Thing) : Boolean = name = other.name",
          """
          def: depth(n : Integer) : Integer =
            if n <= 0 or n > 20 or next = null then n else 1 + next.depth(n - 1) endif\
          """,
          "def: even() : Integer = if parts->isEmpty() then 0 else 2 + parts->last().odd() endif",
          "def: odd() : Integer = if parts->isEmpty() then 1 else parts->first().even() endif");

  private static final int MODELS = 50;

  /** The number of constructs in the grammar. */
  private static final int CONSTRUCTS = 183;

  private final EPackage metamodel = new TestModels("everything").metamodel();
  private final ExpressionLanguage language = language();
  private final Scope scope = language.root().with("self", metamodel.getEClassifier("Thing"));
  private final StockEvaluator stock = new StockEvaluator(language.environment());

  private ExpressionLanguage language() {
    ExpressionLanguage result = ExpressionLanguage.of(List.of(metamodel));
    TestDefinitions.define(result, metamodel.getEClassifier("Thing"), DEFINITIONS);
    return result;
  }

  @Provide
  Arbitrary<List<Integer>> choices() {
    return Arbitraries.integers()
        .between(0, 5039)
        .withDistribution(RandomDistribution.uniform())
        .list()
        .ofMaxSize(50)
        .withSizeDistribution(RandomDistribution.uniform());
  }

  @Property(seed = "20240611", shrinking = ShrinkingMode.FULL)
  void loweredExpressionsHaveTheValuesOfEclipseOcl(
      @ForAll("choices") List<Integer> choices, @ForAll Random random) {
    OclGenerator generator = new OclGenerator(choices);
    Expression expression = parse(generator.expression());
    List<EObject> things = GeneratedModels.things(metamodel, random.nextInt(MODELS));
    EObject self = things.get(random.nextInt(things.size()));
    Object expected = evaluate(expression, self);
    Evaluation run = Evaluations.over(List.of(self));
    run.bind("self", self);
    assertEquals(
        normal(expected, true), normal(expression.evaluate(run), true), () -> text(expression));
    if (!generator.doesOrderMatter()) {
      Object original = stock.evaluate(expression.ast(), self);
      if (stock.differences().isEmpty()) {
        assertEquals(normal(original, false), normal(expected, false), () -> text(expression));
      }
    }
  }

  private Expression parse(String text) {
    List<Diagnostic> problems = new ArrayList<>();
    return language
        .parse(SourceText.of("generated.ocl", text).whole(), scope, problems)
        .orElseThrow(() -> new AssertionError(text + "\n" + problems));
  }

  private static String text(Expression expression) {
    return expression.ast().toString();
  }

  private Object evaluate(Expression expression, EObject self) {
    Run run = (Run) Evaluations.over(List.of(self));
    run.begin();
    run.bind("self", self);
    Lowered traced = language.trace(expression.ast());
    return traced.evaluate(traced.frame(run));
  }

  /** Returns a value that is equal only for the same values in OCL, including type and order. */
  static Object normal(Object value, boolean ordered) {
    if (value instanceof Invalid || value == Values.INVALID) {
      return "invalid";
    } else if (value instanceof Tuple<?, ?> tuple) {
      return tuple.toString();
    } else if (value instanceof Collection<?> elements) {
      List<Object> texts = new ArrayList<>();
      elements.forEach(each -> texts.add(String.valueOf(normal(each, ordered))));
      boolean sort = !ordered && !(value instanceof List) && !(value instanceof LinkedHashSet);
      if (sort) {
        texts.sort(null);
      }
      return kind(elements) + texts;
    }
    if (value == null) {
      return null;
    }
    String type = Numbers.isInteger(value) ? "Integer" : value.getClass().getSimpleName();
    return type + " " + value;
  }

  private static String kind(Collection<?> elements) {
    if (elements instanceof Bag) {
      return "Bag";
    } else if (elements instanceof LinkedHashSet) {
      return "OrderedSet";
    }
    return elements instanceof Set ? "Set" : "Sequence";
  }

  @Example
  void everyConstructIsGeneratedAndMostValuesAreDefined() {
    Random random = new Random(1);
    Map<String, Integer> used = new TreeMap<>();
    int defined = 0;
    int comparable = 0;
    Map<String, Integer> differences = new TreeMap<>();
    int count = 2000;
    for (int i = 0; i < count; i++) {
      OclGenerator generator = new OclGenerator(random.ints(40, 0, 5040).boxed().toList());
      Expression expression = parse(generator.expression());
      EObject self = GeneratedModels.things(metamodel, i % MODELS).get(0);
      Object value = evaluate(expression, self);
      defined += value == null || value == Values.INVALID ? 0 : 1;
      stock.evaluate(expression.ast(), self);
      stock.differences().forEach(each -> differences.merge(each, 1, Integer::sum));
      comparable += generator.doesOrderMatter() || !stock.differences().isEmpty() ? 0 : 1;
      generator.used().forEach((name, times) -> used.merge(name, times, Integer::sum));
    }
    assertEquals(CONSTRUCTS, used.size(), used::toString);
    assertTrue(used.values().stream().allMatch(times -> times >= 5), used::toString);
    assertTrue(defined > count / 3, defined + " values are defined");
    assertTrue(comparable > count / 3, comparable + " values are comparable, " + differences);
    assertTrue(
        differences.values().stream().allMatch(each -> each < count / 10), differences::toString);
  }
}
