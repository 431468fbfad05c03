package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.ocl.types.AnyType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests expressions that a dialect accepts and standard OCL refuses. */
class DialectTest {

  /** An operation for strings and numbers that also accepts less specific static types. */
  private static final OperationLibrary SHOUT =
      new OperationLibrary() {
        @Override
        public Optional<Operation> lookup(
            TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
          return Optional.empty();
        }

        @Override
        public Optional<Operation> lookupLoosely(
            TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
          return name.equals("size") || name.equals("shout")
              ? Optional.of(
                  new Operation(
                      name, language.type("String"), (value, arguments, run) -> value + "!"))
              : Optional.empty();
        }
      };

  private static final Dialect LOOSE =
      new Dialect() {
        @Override
        public List<OperationLibrary> libraries() {
          return List.of(SHOUT);
        }

        @Override
        public boolean takesAnyElement() {
          return true;
        }

        @Override
        public Optional<EClassifier> assumed(EClassifier type) {
          return type instanceof AnyType<?>
              ? Optional.of(EcorePackage.Literals.EOBJECT)
              : Optional.empty();
        }

        @Override
        public boolean meansAnyType(String name) {
          return name.equals("Whatever");
        }
      };

  /** A dialect whose only operation violates its result type. */
  private static final Dialect LYING =
      new Dialect() {
        @Override
        public List<OperationLibrary> libraries() {
          return List.of(
              (language, source, name, arguments) ->
                  name.equals("lie")
                      ? Optional.of(
                          new OperationLibrary.Operation(
                              name, language.type("Boolean"), (value, given, run) -> "a text"))
                      : Optional.empty());
        }
      };

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Set{1}->including('a')->size() | 2",
        "Sequence{1}->append('a')->last() | a",
        "Sequence{1}->union(Sequence{'a'})->size() | 2",
        "Sequence{1} = 1 | false",
        "1 <> Sequence{1} | true",
        "self.oclAsType(OclAny).eClass().name | Library",
        "'a'.shout() | a!",
        "'abc'.size() | 3",
      })
  void loosePassesWhatStandardRefuses(String text, String expected) {
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel), LOOSE);
    assertEquals(expected, String.valueOf(value(language, text)));
    boolean standard = text.equals("'abc'.size()");
    assertEquals(standard, errors(ExpressionLanguage.of(List.of(metamodel)), text).isEmpty(), text);
  }

  @Test
  void declarationsMayLeaveTheTypeOpenButExpressionsMayNot() {
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel), LOOSE);
    assertEquals(language.sequenceOf(language.any()), language.type("Sequence(Whatever)"));
    assertEquals(1, errors(language, "self.oclIsKindOf(Whatever)").size());
  }

  @Test
  void logicAsksForTruthValues() {
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel), LYING);
    for (String text :
        List.of("lie() and true", "true and lie()", "lie() or false", "true implies lie()")) {
      assertTrue(value(language, text) instanceof Invalid, text);
    }
    assertEquals(true, value(language, "lie() or true"));
  }

  @Test
  void whatIsNoModelElementHasNoClass() {
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel), LOOSE);
    assertTrue(value(language, "1.oclAsType(OclAny).eClass()") instanceof Invalid);
  }

  private Object value(ExpressionLanguage language, String text) {
    Evaluation run = Evaluations.over(List.of(library));
    run.bind("self", library);
    return Evaluated.value(language, SourceText.of("test", text), scope(language), run);
  }

  private List<Diagnostic> errors(ExpressionLanguage language, String text) {
    List<Diagnostic> problems = new ArrayList<>();
    language.parse(SourceText.of("test", text).whole(), scope(language), problems);
    return problems.stream().filter(each -> Diagnostic.anyError(List.of(each))).toList();
  }

  private Scope scope(ExpressionLanguage language) {
    return language.root().with("self", language.type("Library"));
  }
}
