package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.values.Values;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Tests that all exceptions from the comparison with Eclipse OCL are real and documented. */
class StockDifferencesTest {

  private static final Path TABLE = Path.of("src", "test", "resources", "stock-differences.md");

  private final EPackage metamodel = new TestModels("everything").metamodel();
  private final EObject self = GeneratedModels.things(metamodel, 1).get(0);
  private final ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
  private final StockEvaluator stock = new StockEvaluator(language.environment());

  /** Returns the cells of each row. */
  private static List<String[]> rows() throws IOException {
    return Files.readAllLines(TABLE).stream()
        .filter(line -> line.contains("`"))
        .filter(line -> line.startsWith("| "))
        .map(line -> line.substring(2, line.length() - 2).split(" (?<!\\\\)\\| "))
        .toList();
  }

  @Test
  void everyDifferenceStandsInTheTable() throws IOException {
    assertEquals(
        new TreeSet<>(StockDifferences.NAMES),
        new TreeSet<>(rows().stream().map(cells -> cells[0]).toList()));
  }

  @TestFactory
  Stream<DynamicTest> everyRowIsADifferenceThatIsNoticed() throws IOException {
    return rows().stream().map(cells -> DynamicTest.dynamicTest(cells[0], () -> check(cells)));
  }

  private void check(String[] cells) {
    assertEquals(5, cells.length, "difference, expression, Eclipse OCL, here, why");
    List<Diagnostic> problems = new ArrayList<>();
    Expression expression =
        language
            .parse(SourceText.of("t", code(cells[1])).whole(), language.root(), problems)
            .orElseThrow(() -> new AssertionError(problems));
    assertEquals(code(cells[2]), text(stock.evaluate(expression.ast(), self)));
    assertTrue(stock.differences().contains(cells[0]), stock.differences()::toString);
    Evaluation run = Evaluations.over(List.of(self));
    assertEquals(code(cells[3]), text(expression.evaluate(run)));
    boolean byOrder = cells[4].contains("no order");
    assertNotEquals(byOrder, !cells[2].equals(cells[3]), "no difference");
  }

  private static String code(String cell) {
    return cell.substring(1, cell.length() - 1).replace("\\|", "|");
  }

  private static String text(Object value) {
    boolean invalid = value instanceof Invalid || value == Values.INVALID;
    return invalid ? "invalid" : String.valueOf(value);
  }
}
