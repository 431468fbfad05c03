package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.values.Unlimited;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reasons of invalid values: the innermost invalid part, its place, and its kind. */
class ReasonsTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");
  private final ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));

  private Object evaluate(String text) {
    Scope scope = language.root().with("self", library.eClass());
    Evaluation run = Evaluations.over(List.of(library));
    run.bind("self", library);
    return Evaluated.value(language, SourceText.of("x", text), scope, run);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "invalid + 1                    | x:1:1  | OTHER | 'invalid' is written here",
        "invalid < 1                    | x:1:1  | OTHER | 'invalid' is written here",
        "* + 1                          | x:1:3  | OTHER | '+' has no result for *",
        "(*).max(3)                     | x:1:5  | OTHER | 'max' has no result for *",
        "null < 1                       | x:1:6  | NULL  | '<' is applied to null",
        "'x'.oclAsType(Integer)         | x:1:5  | OTHER | 'oclAsType' has no result for 'x'",
        "'ab'.substring(2, 9).size()    | x:1:6  | OTHER | 'substring' has no result for 'ab'",
        "Sequence{1}->at(3) + 1         | x:1:14 | OTHER"
            + " | 'at' has no result for a collection of 1 (index: 3, size: 1)",
        "Sequence{}->first() = 1        | x:1:13 | EMPTY"
            + " | 'first' has no result for an empty collection",
        "let c : Boolean = null in if c then 1 else 2 endif | x:1:27 | NULL"
            + " | the condition of an 'if' is null",
        "let c : Boolean = null in books->select(c)->isEmpty() | x:1:27 | NULL"
            + " | the body of 'select' is null for an element",
        "(let b : Book = null in b.title.size()) > 0 | x:1:27 | NULL | 'title' is called on null",
        "1 / (2 - 2) > 0                | x:1:3  | OTHER"
            + " | '/' divides 1 by zero or by nothing",
        "(1 / 0).oclIsUndefined() and null.oclAsType(Integer) > 0 | x:1:54 | NULL"
            + " | '>' is applied to null",
        "let x : Integer = 1.div(0) in x + 1 | x:1:21 | OTHER"
            + " | 'div' divides 1 by zero or by nothing",
        "let x : Integer = 1.div(0), y : Integer = x in 2 + y | x:1:21 | OTHER"
            + " | 'div' divides 1 by zero or by nothing",
        "\"Sequence{1, 2}->iterate(i; s : Integer = 0 | s + i.div(i - 1))\" | x:1:52 | OTHER"
            + " | 'div' divides 1 by zero or by nothing",
      })
  void reasonIsThatOfTheInnermostPart(String text, String place, String kind, String reason) {
    Invalid invalid = (Invalid) evaluate(text);
    assertEquals(
        place + " " + kind + " " + reason,
        invalid.location() + " " + invalid.kind() + " " + invalid.reason());
  }

  @Test
  void operationsOfDataTypesAreThoseOfTheTypesThatStandForThem() {
    assertEquals(2, evaluate("let s : ecore::EString = 'ab' in s.size()"));
  }

  @Test
  void unlimitedIsWrittenAsAStar() {
    assertEquals("*", evaluate("(*).toString()"));
    assertEquals(Unlimited.UNLIMITED, evaluate("*"));
  }
}
