package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.impl.EPackageRegistryImpl;
import org.eclipse.ocl.ParserException;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.ecore.OCL;
import org.eclipse.ocl.options.ParsingOptions;
import org.eclipse.ocl.util.Bag;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Tests that evaluation has the values of Eclipse OCL's own, except for the order of sets and bags
 * and known differences.
 */
class StockComparisonTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");
  private final ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
  private final OCL stock = stock();

  private OCL stock() {
    EPackage.Registry registry = new EPackageRegistryImpl();
    registry.put(metamodel.getNsURI(), metamodel);
    OCL ocl = OCL.newInstance(new EcoreEnvironmentFactory(registry));
    ParsingOptions.setOption(
        ocl.getEnvironment(),
        ParsingOptions.implicitRootClass(ocl.getEnvironment()),
        EcorePackage.Literals.EOBJECT);
    return ocl;
  }

  /** Expressions with other values in Eclipse OCL, and their values in the standard. */
  private static final Map<String, Object> DIFFERENCES =
      Map.of(
          "Set{1, 1.0}->size()",
          1,
          "Sequence{1, 2}->exists(x | if x = 1 then null else true endif)",
          true);

  @TestFactory
  Stream<DynamicTest> valuesAreThoseOfEclipseOcl() throws IOException {
    return Files.readAllLines(Path.of("src", "test", "resources", "expressions.txt")).stream()
        .map(text -> DynamicTest.dynamicTest(text, () -> compare(text)));
  }

  private void compare(String text) throws ParserException {
    OCL.Helper helper = stock.createOCLHelper();
    helper.setContext(library.eClass());
    String qualified = text.replace("Member.all", "people::Member.all");
    Object expected = stock.evaluate(library, helper.createQuery(qualified));
    if (DIFFERENCES.containsKey(text)) {
      assertNotEquals(DIFFERENCES.get(text), normal(expected));
      expected = DIFFERENCES.get(text);
    }
    assertEquals(normal(expected), normal(ours(text)));
  }

  private Object ours(String text) {
    List<Diagnostic> problems = new ArrayList<>();
    Scope scope = language.root().with("self", library.eClass());
    Optional<Expression> expression =
        language.parse(SourceText.of("", text).whole(), scope, problems);
    assertTrue(expression.isPresent(), problems::toString);
    Evaluation run = Evaluations.over(List.of(library));
    run.bind("self", library);
    return expression.get().evaluate(run);
  }

  /** Returns a value that is equal for equal values in OCL, with the kind of a collection. */
  private Object normal(Object value) {
    if (value instanceof Invalid || stock.isInvalid(value)) {
      return "invalid";
    } else if (value instanceof org.eclipse.ocl.util.Tuple<?, ?> tuple) {
      return tuple.toString();
    } else if (value instanceof Bag<?> bag) {
      return "Bag" + bag.stream().map(each -> String.valueOf(normal(each))).sorted().toList();
    } else if (value instanceof LinkedHashSet<?> set) {
      return "OrderedSet" + set.stream().map(this::normal).toList();
    } else if (value instanceof Set<?> set) {
      return "Set" + set.stream().map(each -> String.valueOf(normal(each))).sorted().toList();
    } else if (value instanceof Collection<?> elements) {
      return new ArrayList<>(elements.stream().map(this::normal).toList());
    }
    return value;
  }
}
