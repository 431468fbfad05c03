package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.Run;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests operations and properties that are added to the classes of a language. */
class DefinitionsTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");
  private final ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
  private final List<Diagnostic> problems = new ArrayList<>();

  private Expression parse(String text) {
    return language
        .parse(SourceText.of("", text).whole(), scope("Library"), problems)
        .orElseThrow(() -> new AssertionError(problems));
  }

  private Scope scope(String type) {
    return language.root().with("self", metamodel.getEClassifier(type));
  }

  private Evaluation run() {
    Evaluation run = Evaluations.over(List.of(library));
    run.bind("self", library);
    return run;
  }

  @Test
  void thoseOfASubclassTakeThePlaceOfThoseAbove() {
    TestDefinitions.define(
        language,
        metamodel.getEClassifier("AudioBook"),
        List.of("def: kind : String = 'audio'", "def: name(n : Integer) : String = 'recording'"));
    TestDefinitions.define(
        language,
        metamodel.getEClassifier("Book"),
        List.of("def: kind : String = 'book'", "def: name(n : Integer) : String = 'volume'"));
    Expression names = parse("books->collect(b | b.kind + ' ' + b.name(2))->asSet()");
    Set<String> expected = Set.of("audio recording", "book volume");
    assertEquals(expected, Set.copyOf((Collection<?>) names.evaluate(run())));
    Lowered traced = language.trace(names.ast());
    Object explained = traced.evaluate(traced.frame((Run) run()));
    assertEquals(expected, Set.copyOf((Collection<?>) explained));
  }

  @Test
  void recursiveIsWhatReachesOneThatCallsItself() {
    TestDefinitions.define(
        language,
        metamodel.getEClassifier("Library"),
        List.of(
            "def: down(n : Integer) : Integer = if n > 0 then down(n - 1) else 0 endif",
            "def: even(n : Integer) : Boolean = n = 0 or odd(n - 1)",
            "def: odd(n : Integer) : Boolean = n <> 0 and even(n - 1)",
            "def: four : Integer = 4",
            "def: parity : Boolean = even(four)"));
    List.of("down(3) = 0", "odd(3)", "books->exists(b | self.even(4))", "parity")
        .forEach(text -> assertTrue(parse(text).isRecursive(), text));
    List.of("four = 4", "four + four = 8", "self->closure(oclAsSet())->isEmpty()")
        .forEach(text -> assertFalse(parse(text).isRecursive(), text));
  }

  @Test
  void whatUsesOneWithAnErrorIsNotUsable() {
    Definitions definitions = new Definitions(language, problems);
    Scope scope = scope("Library");
    definitions.addAll(
        List.of(
            TestDefinitions.definition("def: user() : Integer = wrong() + 1", scope),
            TestDefinitions.definition("def: wrong() : Integer = 'text'", scope),
            TestDefinitions.definition("def: right() : Integer = books->size()", scope)));
    assertEquals(
        List.of("'wrong' is declared as Integer, but its value is of type String."),
        problems.stream().map(Diagnostic::message).toList());
    assertFalse(definitions.isUsable(parse("user()")));
    assertTrue(definitions.isUsable(parse("right()")));
  }

  @Test
  void parsingTwoThousandLeavesNoMoreBehindThanParsingTen() {
    assertEquals(rootsAfter(10), rootsAfter(2000));
  }

  private int rootsAfter(int expressions) {
    ExpressionLanguage fresh = ExpressionLanguage.of(List.of(metamodel));
    List<Diagnostic> found = new ArrayList<>();
    Definitions definitions = new Definitions(fresh, found);
    Scope book = scope("Book");
    String above = "def: d0(n : Integer) : Boolean = n > 0 and pages > n";
    definitions.addAll(List.of(TestDefinitions.definition(above, book)));
    for (int i = 0; i < expressions; i++) {
      String text =
          String.format(Locale.ROOT, "let k : Integer = %d in self.pages > k implies d0(k)", i);
      assertTrue(fresh.parse(SourceText.of("", text).whole(), book, found).isPresent());
      text = String.format(Locale.ROOT, "self.pagse > %d", i);
      assertFalse(fresh.parse(SourceText.of("", text).whole(), book, found).isPresent());
    }
    assertEquals(expressions, found.size());
    return fresh.environment().roots();
  }

  @Test
  void selfMayHaveAnotherName() {
    Scope scope = scope("Library").withAlias("all", "Library");
    Expression size =
        language
            .parse(SourceText.of("", "all.books = books").whole(), scope, problems)
            .orElseThrow(() -> new AssertionError(problems));
    assertEquals(true, size.evaluate(run()));
  }
}
