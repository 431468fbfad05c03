package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests expressions on a small library of books, with and without own operations. */
class ExpressionLanguageTest {

  private record Extended(List<OperationLibrary> libraries) implements Dialect {}

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  private final OperationLibrary extras =
      new OperationLibrary() {
        @Override
        public Optional<Operation> lookup(
            TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
          if (name.equals("filter") && language.elementType(source).isPresent()) {
            EClassifier wanted = language.referredType(argumentTypes.get(0)).orElseThrow();
            return Optional.of(
                new Operation(
                    name,
                    language.collectionLike(source, wanted),
                    (value, arguments, run) ->
                        ((Collection<?>) value)
                            .stream().filter(each -> language.isInstance(each, wanted)).toList()));
          } else if (name.equals("eAllContents") && argumentTypes.size() == 1) {
            EClassifier wanted = language.referredType(argumentTypes.get(0)).orElseThrow();
            return Optional.of(
                new Operation(
                    name,
                    language.sequenceOf(wanted),
                    (value, arguments, run) -> contents((EObject) value, arguments.get(0))));
          } else if (name.equals("twice") && source == null) {
            return Optional.of(
                new Operation(
                    name,
                    language.type("String"),
                    (value, arguments, run) -> "" + arguments.get(0) + arguments.get(0)));
          } else if (name.equals("tags")) {
            return Optional.of(
                new Operation(
                    name,
                    language.type("Set(String)"),
                    (value, arguments, run) -> new LinkedHashSet<>(List.of("b", "a", "c"))));
          } else if (name.equals("fail")) {
            return Optional.of(
                new Operation(
                    name,
                    language.type("String"),
                    (value, arguments, run) ->
                        new Invalid("no such shelf", null, Invalid.Kind.OTHER)));
          }
          return Optional.empty();
        }
      };
  private final ExpressionLanguage language =
      ExpressionLanguage.of(List.of(metamodel), new Extended(List.of(extras)));

  private static List<Object> contents(EObject object, Object type) {
    List<Object> found = new ArrayList<>();
    TreeIterator<EObject> all = object.eAllContents();
    all.forEachRemaining(
        each -> {
          if (((EClass) type).isInstance(each)) {
            found.add(each);
          }
        });
    return found;
  }

  private Object evaluate(String text) {
    Scope scope =
        language
            .root()
            .with("self", library.eClass())
            .with("i", language.type("Integer"))
            .with("word", language.type("String"));
    Evaluation run = Evaluations.over(List.of(library));
    run.bind("self", library);
    run.bind("i", 3);
    run.bind("word", "it's");
    return Evaluated.value(language, SourceText.of("test.ocl", text), scope, run);
  }

  private List<Diagnostic> problems(String text, int start) {
    List<Diagnostic> problems = new ArrayList<>();
    Scope scope = language.root().with("self", library.eClass());
    assertTrue(
        language
            .parse(SourceText.of("test.ocl", text).range(start, text.length()), scope, problems)
            .isEmpty());
    return problems;
  }

  @Test
  void variablesHaveTheValuesTheyAreBoundTo() {
    assertEquals("it's3", evaluate("word.concat(i.toString())"));
    assertEquals("Town", evaluate("self.name"));
    assertEquals("Town", evaluate("name"));
  }

  @Test
  void nullIsNotInvalid() {
    assertNull(evaluate("self.books->first().subtitle"));
    Invalid invalid =
        assertInstanceOf(
            Invalid.class, evaluate("\n  self.books->select(pages > 9000)->first().title"));
    assertEquals("'first' has no result for an empty collection", invalid.reason());
    assertEquals("test.ocl:2:37", invalid.location().toString());
  }

  @Test
  void operationsOfEObjectAreThere() {
    assertEquals(library, evaluate("self.books->first().eContainer()"));
    assertEquals("Library", evaluate("self.eClass().name"));
    assertEquals(6, evaluate("self.eContents()->size()"));
  }

  @Test
  void aLibraryComputesResultTypesFromTypeLiterals() {
    assertEquals(
        List.of("Refactoring"), evaluate("self.books->asSequence()->filter(AudioBook).title"));
    assertEquals(2, evaluate("self.eAllContents(Book)->select(pages > 300)->size()"));
    assertEquals(12.0, evaluate("self.books->filter(AudioBook)->any(true).minutes / 30"));
  }

  @Test
  void aCallWithoutSourceIsAFunction() {
    assertEquals("xx", evaluate("twice('x')"));
    assertEquals(List.of("TownTown"), evaluate("self.name->asSequence()->collect(n | twice(n))"));
  }

  @Test
  void aReasonGivenByALibraryIsKept() {
    Invalid invalid = assertInstanceOf(Invalid.class, evaluate("self.fail().size()"));
    assertTrue(invalid.reason().contains("no such shelf"), invalid.reason());
  }

  @Test
  void setsKeepTheOrderOfInsertion() {
    assertEquals(
        List.of("q", "z", "a", "m", "b"),
        evaluate("Set{'q','z','a'}->union(Set{'m','a','b'})->asSequence()"));
    assertEquals(
        List.of("q", "a"),
        evaluate("Set{'q','z','a'}->select(c | c <> 'z')->asBag()->asSet()->asSequence()"));
    assertEquals(List.of("b", "a", "c"), evaluate("self.tags()->asSequence()"));
    assertEquals(
        List.of("z", "q"),
        evaluate("Sequence{'z','q','z'}->asSet()->intersection(Set{'q','z','x'})->asSequence()"));
    assertEquals(
        List.of("zz", "qq"), evaluate("Set{'z','q'}->collect(c | c.concat(c))->asSequence()"));
    assertEquals(true, evaluate("Set{1,2} = Set{2,1} and Bag{1,2,1} = Bag{2,1,1}"));
    assertEquals(true, evaluate("OrderedSet{1,2} <> OrderedSet{2,1}"));
  }

  @Test
  void extentsCoverTheModel() {
    assertEquals(
        List.of("Refactoring"), evaluate("AudioBook.allInstances()->collect(title)->asSequence()"));
    assertEquals(4, evaluate("Book.allInstances()->size()"));
  }

  @Test
  void allErrorsOfAnExpressionStandAtTheirPlacesInTheText() {
    List<Diagnostic> problems = problems("[template]\n  [self.naem + self.boks", 14);
    assertEquals(
        List.of("test.ocl:2:9 Did you mean `name`?", "test.ocl:2:21 Did you mean `books`?"),
        problems.stream().map(each -> each.location() + " " + each.hint()).toList());
    assertEquals("test.ocl:1:1", problems("+", 0).get(0).location().toString());
    assertEquals("test.ocl:1:1", problems("  ", 0).get(0).location().toString());
  }

  @Test
  void anExpressionWithoutSelfSeesOnlyItsVariables() {
    List<Diagnostic> problems = new ArrayList<>();
    Scope scope = language.root().with("b", language.type("Book"));
    String good = "b.title.concat(twice('x'))";
    Expression expression =
        language
            .parse(SourceText.of("t", good).whole(), scope, problems)
            .orElseThrow(() -> new AssertionError(problems));
    Evaluation run = Evaluations.over(List.of(library));
    run.bind("b", library.eContents().get(0));
    assertEquals("Dunexx", expression.evaluate(run));
    assertTrue(language.parse(SourceText.of("t", "self.title").whole(), scope, problems).isEmpty());
    assertTrue(language.parse(SourceText.of("t", "title").whole(), scope, problems).isEmpty());
    assertEquals(2, problems.size());
  }

  @Test
  void nestingThatIsTooDeepIsAnError() {
    List<Diagnostic> problems = problems("not ".repeat(50_000) + "true", 0);
    assertEquals(
        List.of("The expression is nested too deeply."),
        problems.stream().map(Diagnostic::message).toList());
  }

  @Test
  void typesAreParsed() {
    assertEquals("Sequence(Book)", language.type("Sequence(Book)").getName());
    assertEquals("Member", language.type("people::Member -- of a library").getName());
    List<Diagnostic> problems = new ArrayList<>();
    assertTrue(language.type(SourceText.of("t", "x : Boook").range(4, 9), problems).isEmpty());
    assertEquals("t:1:5", problems.get(0).location().toString());
    assertTrue(
        language.conforms(language.type("AudioBook"), language.type("Book"))
            && !language.conforms(language.type("Book"), language.type("AudioBook")));
  }
}
