package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.Values;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.util.Bag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests collections of another kind than their static type says, as queries of templates give them,
 * against Eclipse OCL's evaluator: each operation has its value, except for the order of sets and
 * bags.
 */
class OtherKindsTest {

  private final EPackage metamodel = new TestModels("everything").metamodel();
  private final EObject self = GeneratedModels.things(metamodel, 1).get(0);
  private final ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
  private final StockEvaluator stock = new StockEvaluator(language.environment());

  private static final List<String> OF_ANY =
      """
      x
      x->size()
      x->isEmpty()
      x->notEmpty()
      x->includes(1)
      x->excludes(1)
      x->includesAll(Set{1, 2})
      x->excludesAll(Sequence{7, 8})
      x->count(1)
      x->sum()
      x->max()
      x->min()
      x->asSet()
      x->asOrderedSet()->sortedBy(i | i)
      x->asBag()
      x->asSequence()->sortedBy(i | i)
      x->including(9)
      x->including(1)
      x->excluding(1)
      x->flatten()
      x->exists(i | i = 1)
      x->forAll(i | i < 9)
      x->select(i | i > 1)
      x->reject(i | i > 1)
      x->collect(i | i + 1)
      x->collectNested(i | Sequence{i})
      x->any(i | i = 2)
      x->one(i | i = 2)
      x->isUnique(i | i)
      x->sortedBy(i | -i)
      x->iterate(i; s : Integer = 0 | s + i)
      x->closure(i | if i < 5 then i + 1 else i endif)
      x->product(Set{1})->size()
      x = x
      x <> x
      Sequence{x}->size()
      let y : Collection(Integer) = x in y->size()
      if x->isEmpty() then x else x->including(5) endif
      x.oclIsUndefined()
      x->asSequence()->including(1)->size()
      x->asSet()->including(1)->size()
      x->asBag()->including(1)->size()
      """
          .lines()
          .toList();

  private static final List<String> OF_LISTS =
      """
      x->first()
      x->last()
      x->at(2)
      x->indexOf(1)
      x->append(1)
      x->prepend(9)
      x->insertAt(2, 9)
      """
          .lines()
          .toList();

  private static final List<String> OF_SETS =
      """
      x->union(Set{1, 9})
      x->union(Bag{1, 9})
      x->intersection(Set{1, 9})
      x->intersection(Bag{1, 9})
      x - Set{1}
      x->symmetricDifference(Set{1, 9})
      """
          .lines()
          .toList();

  /**
   * Operations that are invalid in Eclipse OCL where the source is no set, and have a value here.
   */
  private static final Set<String> SETS_ONLY =
      Set.of("x - Set{1}", "x->symmetricDifference(Set{1, 9})");

  @ParameterizedTest
  @ValueSource(strings = {"Sequence", "OrderedSet", "Set", "Bag"})
  void operationsHaveTheValuesOfEclipseOcl(String declared) {
    List<String> texts = new ArrayList<>(OF_ANY);
    boolean lists = declared.equals("Sequence") || declared.equals("OrderedSet");
    if (lists) {
      texts.addAll(OF_LISTS);
    }
    switch (declared) {
      case "Sequence" -> texts.addAll(List.of("x->subSequence(2, 3)", "x->union(Sequence{1, 9})"));
      case "OrderedSet" -> texts.add("x->subOrderedSet(2, 3)");
      case "Set" -> texts.addAll(OF_SETS);
      default -> texts.addAll(OF_SETS.subList(0, 4));
    }
    Map<String, String> differences = new TreeMap<>();
    for (String text : texts) {
      for (CollectionKind kind : CollectionKind.values()) {
        if (kind != CollectionKind.COLLECTION_LITERAL) {
          compare(declared, text, kind, differences);
        }
      }
    }
    assertEquals(new TreeMap<>(), differences);
  }

  private void compare(
      String declared, String text, CollectionKind kind, Map<String, String> differences) {
    Object value = CollectionOperations.create(kind, List.of(3, 1, 1, 2));
    EClassifier type = language.type(declared + "(Integer)");
    List<Diagnostic> problems = new ArrayList<>();
    Scope scope = language.root().with("self", self.eClass()).with("x", type);
    Expression expression =
        language
            .parse(SourceText.of("", text).whole(), scope, problems)
            .orElseThrow(() -> new AssertionError(text + problems));
    if (SETS_ONLY.contains(text) && !(value instanceof Set<?>)) {
      return;
    }
    String expected = text(stock.evaluate(expression.ast(), self, Map.of("x", value)));
    Evaluation run = Evaluations.over(List.of(self));
    run.bind("self", self);
    run.bind("x", value);
    String actual = text(expression.evaluate(run));
    if (!expected.equals(actual)) {
      differences.put(text + " of " + kind, expected + " but " + actual);
    }
  }

  private static String text(Object value) {
    if (value instanceof Invalid || value == Values.INVALID) {
      return "invalid";
    } else if (value instanceof Bag<?> bag) {
      return "Bag" + bag.stream().map(OtherKindsTest::text).sorted().toList();
    } else if (value instanceof LinkedHashSet<?> set) {
      return "OrderedSet" + set.stream().map(OtherKindsTest::text).toList();
    } else if (value instanceof Set<?> set) {
      return "Set" + set.stream().map(OtherKindsTest::text).sorted().toList();
    } else if (value instanceof Collection<?> elements) {
      return "Sequence" + elements.stream().map(OtherKindsTest::text).toList();
    }
    return String.valueOf(value);
  }
}
