package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.Run;
import dev.eventchain.ocl.values.Values;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Tests that values are those of OMG OCL 2.4, with numbers of all Java types in models. */
class StandardValuesTest {

  private static final Path VALUES = Path.of("src", "test", "resources", "standard-values.txt");
  private static final Path DIFFERENCES = Path.of("differences.md");

  private final TestModels models = new TestModels("numbers");
  private final EPackage metamodel = models.metamodel();
  private final EObject numbers = models.load("numbers.xmi");
  private final ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
  private final Scope scope = language.root().with("self", numbers.eClass());

  @TestFactory
  Stream<DynamicTest> valuesAreThoseOfTheStandard() throws IOException {
    return Files.readAllLines(VALUES).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .flatMap(
            line -> {
              String[] parts = line.split(" \\| ", 2);
              int end = parts[1].lastIndexOf(" | ");
              String value = parts[1].substring(end + 3).strip();
              return expanded(parts[1].substring(0, end).strip())
                  .map(text -> DynamicTest.dynamicTest(text, () -> check(value, text)));
            });
  }

  /** Returns one text for each attribute of a placeholder. */
  private Stream<String> expanded(String text) {
    if (text.contains("$i")) {
      return attributes("16").map(name -> text.replace("$i", name));
    }
    return text.contains("$r")
        ? attributes("2.5").map(name -> text.replace("$r", name))
        : Stream.of(text);
  }

  private Stream<String> attributes(String value) {
    return numbers.eClass().getEAllStructuralFeatures().stream()
        .filter(feature -> value.equals(String.valueOf(numbers.eGet(feature))))
        .map(EStructuralFeature::getName);
  }

  @Test
  void thereIsAnAttributeOfEachNumberType() {
    assertEquals(14, attributes("16").count());
    assertEquals(8, attributes("2.5").count());
  }

  private void check(String expected, String text) {
    Expression expression = parse(text);
    assertEquals(expected, text(expression.evaluate(run())));
    // The traced evaluation must have the same value.
    Lowered traced = language.trace(expression.ast());
    assertEquals(expected, text(traced.evaluate(traced.frame((Run) run()))));
  }

  private Evaluation run() {
    Evaluation run = Evaluations.over(List.of(numbers));
    run.bind("self", numbers);
    return run;
  }

  private Expression parse(String text) {
    List<Diagnostic> problems = new ArrayList<>();
    return language
        .parse(SourceText.of("t", text).whole(), scope, problems)
        .orElseThrow(() -> new AssertionError(problems));
  }

  private static String text(Object value) {
    if (value instanceof Invalid || value == Values.INVALID) {
      return "invalid";
    } else if (value instanceof String text) {
      return "'" + text + "'";
    }
    return value instanceof BigDecimal number ? number.toPlainString() : String.valueOf(value);
  }

  @TestFactory
  Stream<DynamicTest> everyDifferenceToTheStandardIsAsTheTableSays() throws IOException {
    List<String> rows =
        Files.readAllLines(DIFFERENCES).stream().filter(line -> line.startsWith("| `")).toList();
    assertFalse(rows.isEmpty());
    return rows.stream()
        .map(row -> row.split(" (?<!\\\\)\\| |^\\| | \\|$"))
        .map(cells -> DynamicTest.dynamicTest(cells[1], () -> checkRow(cells)));
  }

  private void checkRow(String[] cells) {
    assertEquals(5, cells.length, "expression, standard, here, why");
    assertTrue(cells[2].matches("`.*` \\([0-9.]+\\)"), cells[2]);
    String standard = code(cells[2].substring(0, cells[2].lastIndexOf(' ')));
    String here = code(cells[3]);
    assertNotEquals(standard, here, "no difference");
    assertTrue(cells[4].length() > 20, "a reason");
    check(here, code(cells[1]));
  }

  private static String code(String cell) {
    assertTrue(cell.startsWith("`") && cell.endsWith("`"), cell);
    return cell.substring(1, cell.length() - 1).replace("\\|", "|");
  }

  @Test
  void valuesThatAProgramGivesAreNumbersOfOcl() {
    EClassifier integer = language.type("Integer");
    Scope withNumber = scope.with("n", integer);
    List<Diagnostic> problems = new ArrayList<>();
    String text = "Set{16}->includes(n) and n = 16 and n.oclIsTypeOf(Integer)";
    Expression expression =
        language.parse(SourceText.of("t", text).whole(), withNumber, problems).orElseThrow();
    for (Object number : List.of(16L, (short) 16, (byte) 16, java.math.BigInteger.valueOf(16))) {
      Evaluation run = run();
      run.bind("n", number);
      assertEquals(true, expression.evaluate(run), number.getClass().getName());
      run.rebind(1, 17);
      run.rebind(1, number);
      assertEquals(true, expression.evaluate(run), number.getClass().getName());
    }
  }

  @Test
  void anIntegerThatGrowsWithoutEndIsStopped() {
    String text = "Sequence{1..64}->iterate(i; n : Integer = 10 | n * n)";
    Invalid invalid = (Invalid) parse(text).evaluate(run());
    assertEquals("it makes a number of more than 100000 bits", invalid.reason());
  }
}
