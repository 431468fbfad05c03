package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.metamodel.Names;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that no part of a document and no finding is dropped silently. */
class SilentPassesTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  private OclRules parse(String... texts) {
    List<SourceText> documents =
        Stream.of(texts).map(text -> SourceText.of("rules.ocl", text)).toList();
    return OclRules.parse(documents, List.of(metamodel));
  }

  private List<Diagnostic> validate(OclRules rules) {
    return OclValidator.validate(
            rules,
            List.of(library),
            element -> SourceLocation.of("library.xmi").withElement(Names.pathOf(element)))
        .diagnostics();
  }

  @ParameterizedTest
  @ValueSource(strings = {"\r", "\n", "\r\n"})
  void lineCommentEndsWithItsLineWhateverEndsThat(String end) {
    String text =
        String.join(
            end,
            "-- @severity info",
            "",
            "context Library",
            "-- @severity warning",
            "-- @message wrong",
            "inv Wrong: true -- and so on",
            "  and false",
            "");
    OclRules rules = parse(text);
    assertEquals(List.of(), rules.diagnostics());
    assertEquals(6, rules.constraints().get(0).location().line());
    List<Diagnostic> found = validate(rules);
    assertEquals(1, found.size());
    assertEquals("wrong", found.get(0).message());
    assertEquals(Severity.WARNING, found.get(0).severity());
  }

  @Test
  void commentWithoutEndIsAnError() {
    OclRules rules =
        parse("context Library inv First: true\n/* a remark\ncontext Library inv Second: false");
    assertEquals(1, rules.constraints().size());
    Diagnostic problem = rules.diagnostics().get(0);
    assertEquals("ocl.syntax", problem.id());
    assertEquals(Severity.ERROR, problem.severity());
    assertEquals(2, problem.location().line());
    assertEquals(List.of(), parse("context Library inv A: /**/ true /***/").diagnostics());
    assertEquals(1, parse("context Library inv A: true /*/").diagnostics().size());
  }

  @Test
  void failedEvaluationIsAnErrorHoweverBadTheViolationWouldBe() {
    List<Diagnostic> found =
        validate(parse("-- @severity info\ncontext Library inv A: Sequence{}->first() = 1"));
    assertEquals("ocl.undefined", found.get(0).id());
    assertEquals(Severity.ERROR, found.get(0).severity());
  }

  @Test
  void emptyDocumentBesideOthersIsAnError() {
    OclRules rules = parse("context Library inv A: true", "-- context Library inv B: false\n");
    assertEquals("ocl.document.empty", rules.diagnostics().get(0).id());
    assertTrue(Diagnostic.anyError(rules.diagnostics()));
  }

  @ParameterizedTest
  @CsvFileSource(
      resources = "/messages.csv",
      numLinesToSkip = 1,
      delimiter = '|',
      quoteCharacter = '`')
  void mistakeIsNamedInWordsThatHelp(String expression, String message, String hint) {
    OclRules rules = parse("context Library inv A: " + expression.replace("¦", "|"));
    Diagnostic found = rules.diagnostics().get(0);
    assertEquals(message, found.message());
    assertEquals(hint.replace("´", "`"), found.hint());
  }

  @ParameterizedTest
  @ValueSource(strings = {"f(n) : Integer = 3", "f(n : Integer, m) : Integer = 3"})
  void untypedParameterIsAnErrorOfItsOwn(String definition) {
    OclRules rules = parse("context Library def: " + definition + "\ncontext Library inv A: true");
    assertEquals("A parameter needs a type.", rules.diagnostics().get(0).message());
    assertEquals(1, rules.diagnostics().size());
    assertEquals(
        List.of(),
        parse("context Library def: f(n : Set(Integer)) : Bag(Integer) = Bag{}\ninv A: true")
            .diagnostics());
  }
}
