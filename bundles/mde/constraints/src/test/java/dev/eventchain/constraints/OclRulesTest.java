package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.constraints.OclConstraint.Verdict;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests the accessors of rules and their constraints. */
class OclRulesTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  private OclRules rules(String text) {
    OclRules rules = OclRules.parse(List.of(SourceText.of("rules.ocl", text)), List.of(metamodel));
    assertEquals(List.of(), rules.diagnostics());
    return rules;
  }

  @Test
  void aConstraintNamesTheFeaturesItReadsAlsoByWayOfDefinitions() {
    OclConstraint constraint =
        rules(
                """
                context Library
                  def: long() : Set(Book) = books->select(pages > 500)->asSet()
                  inv A: self.long()->forAll(b | b.borrower <> null) or name = 'x'
                """)
            .constraints()
            .get(0);
    assertEquals(
        List.of("Library.books", "Book.pages", "Book.borrower", "Library.name"),
        constraint.navigations().stream()
            .map(each -> each.type().getName() + "." + each.feature().getName())
            .toList());
  }

  @Test
  void aConstraintIsTrueFalseOrUndefinedForAnElement() {
    OclRules rules =
        rules(
            """
            context Book
              -- @severity warning
              -- @hint Think again.
              inv A: sequel.pages < pages
            """);
    OclConstraint constraint = rules.constraint("Book::A").orElseThrow();
    List<EObject> books = library.eContents();
    TimeBudget budget = TimeBudget.of(Duration.ofMinutes(1));
    assertEquals(Verdict.TRUE, constraint.evaluate(books.get(0), budget));
    assertEquals(Verdict.UNDEFINED, constraint.evaluate(books.get(1), budget));
    books.get(0).eSet(books.get(0).eClass().getEStructuralFeature("pages"), 1);
    assertEquals(Verdict.FALSE, constraint.evaluate(books.get(0), budget));
    assertEquals(Severity.WARNING, constraint.severity());
    assertEquals("Think again.", constraint.hint());
    assertEquals("rules.ocl:4:3", constraint.location().toString());
  }

  @Test
  void aByteOrderMarkAndWindowsLineEndsDoNotMatter() {
    OclRules rules =
        rules(
            "\uFEFF-- @severity info\r\ncontext Book\r\n  inv A: pages >= 0\r\n  inv B: true\r\n");
    assertEquals(List.of("Book::A", "Book::B"), rules.constraintNames());
    assertEquals(Severity.INFO, rules.constraints().get(0).severity());
    assertEquals("rules.ocl:4:3", rules.constraints().get(1).location().toString());
  }

  @Test
  void noRulesAndNoDocumentsAreNoPass() {
    for (List<SourceText> documents :
        List.of(List.<SourceText>of(), List.of(SourceText.of("empty.ocl", "")))) {
      OclResult result =
          OclValidator.validate(
              OclRules.parse(documents, List.of(metamodel)),
              List.of(library),
              element -> dev.eventchain.diagnostics.SourceLocation.NONE);
      assertEquals("ocl.nothing-evaluated", result.diagnostics().get(0).id());
      assertEquals(0, result.evaluations());
    }
  }

  @Test
  void rulesThatNoElementIsAboutAreNoPass() {
    EObject member = library.eContents().get(5);
    OclResult result =
        OclValidator.validate(
            rules("context Book inv A: true"),
            List.of(member),
            element -> dev.eventchain.diagnostics.SourceLocation.NONE);
    assertEquals("ocl.nothing-evaluated", result.diagnostics().get(0).id());
    assertEquals(
        "Nothing was checked: none of 1 constraint applies to the class of any of 1 element.",
        result.diagnostics().get(0).message());
  }

  @Test
  void aResultTellsHowOftenEachConstraintWasEvaluatedAlsoIfNever() {
    OclResult result =
        OclValidator.validate(
            rules(
                "context Book inv A: true context AudioBook inv B: true context Library inv C:"
                    + " true"),
            library.eContents().subList(0, 2),
            element -> dev.eventchain.diagnostics.SourceLocation.NONE);
    assertEquals(
        List.of("Book::A 2", "AudioBook::B 0", "Library::C 0"),
        result.checks().stream()
            .map(each -> each.constraint() + " " + each.evaluations())
            .toList());
    assertEquals(2, result.evaluations());
    assertEquals(3, result.constraints());
  }

  @Test
  void aConstraintKnowsTheIdsThatItsCommentNames() {
    OclRules rules =
        rules(
            """
            -- R-1: about the whole context
            context Book
              inv A: pages > 0 -- R-2 is behind it
              -- R-2, and R-30
              inv B: pages > 1
              /* R-3

                 goes on */
              inv C: pages > 2
              -- @message R-2 is told
              --   also R-3
              inv D: pages > 3
              -- R-2: far away

              inv E: pages > 4
            context Library
              inv F: true
            -- R-3: nothing follows
            """);
    assertEquals(
        List.of("A [R-1]", "B [R-2]", "C [R-3]", "D [R-1]", "E [R-1]", "F []"),
        rules.constraints().stream()
            .map(each -> each.name() + " " + each.named(List.of("R-1", "R-2", "R-3")))
            .toList());
  }

  @Test
  void theSameInvariantInAnotherDocumentAddsTheIdsThatItsCommentNamesThere() {
    String invariant = "context Book inv A: pages > 0";
    OclRules rules =
        OclRules.parse(
            List.of(
                SourceText.of("one.ocl", invariant),
                SourceText.of("two.ocl", "-- R-2, R-1.1, R-1/2, a/R-1 and P.R-1\n" + invariant)),
            List.of(metamodel));
    assertEquals(List.of(), rules.diagnostics());
    assertEquals(Set.of("R-2"), rules.constraints().get(0).named(List.of("R-1", "R-2")));
  }
}
