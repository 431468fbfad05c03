package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The mutants of each file {@code mutants/NAME.py}, named after an operator, are those in {@code
 * NAME.expected} beside it: what the operator changes, and what it leaves alone.
 */
class ComponentMutatorTest {

  private static final Path FIXTURES = Path.of("src/test/resources/mutants");
  private static final String NONE = "untouched";
  private static final String BROKEN = "unparsable";

  static Stream<Path> components() throws IOException {
    try (Stream<Path> files = Files.list(FIXTURES)) {
      return files
          .filter(file -> file.toString().endsWith(".py") && !name(file).equals(BROKEN))
          .sorted()
          .toList()
          .stream();
    }
  }

  private static String name(Path file) {
    return file.getFileName().toString().replace(".py", "");
  }

  private static List<ComponentMutant> mutants(SourceText source, String operator) {
    ComponentMutator mutator = new ComponentMutator(TestEnvironment.PYTHON);
    if (operator.equals("node")) {
      return mutator.ofNode(source, "Example");
    }
    if (operator.equals("module")) {
      return mutator.ofModule(source, List.of("from a import Filter", "import a\na.limit(3)\n"));
    }
    return mutator.mutants(
        source,
        "Example",
        swaps(operator),
        operator.equals("latch")
            ? List.of(
                new ComponentMutator.Output("active", true),
                new ComponentMutator.Output("ranges", false))
            : List.of());
  }

  private static List<ComponentMutator.Pair> swaps(String operator) {
    if (operator.equals("swap")) {
      return List.of(new ComponentMutator.Pair("left", "right", false));
    }
    return operator.startsWith("swap-")
        ? List.of(
            new ComponentMutator.Pair("front_door", "rear_door", true),
            new ComponentMutator.Pair("rear_door", "left_door", true),
            new ComponentMutator.Pair("driver_seat", "middle_seat", false),
            new ComponentMutator.Pair("left_gap", "right_gap", false),
            new ComponentMutator.Pair("left_speed", "right_speed", false))
        : List.of();
  }

  @ParameterizedTest
  @MethodSource("components")
  void mutantsAreAsExpected(Path component) throws IOException {
    SourceText source = SourceText.read(component);
    List<ComponentMutant> mutants = mutants(source, name(component));
    String listed =
        mutants.stream()
            .map(each -> each.line() + ":" + each.column() + " " + each.id() + "\n")
            .collect(Collectors.joining());
    if (name(component).equals(NONE)) {
      assertEquals("", listed);
    } else {
      ExpectedFile.check(ExpectedFile.beside(component), listed);
    }
    Set<String> texts = new HashSet<>(List.of(source.text()));
    Set<String> ids = new HashSet<>();
    for (ComponentMutant mutant : mutants) {
      assertTrue(ids.add(mutant.id()), mutant.id());
      assertTrue(texts.add(mutant.in(source.text())), mutant.id());
    }
  }

  /** An import of everything names everything; a file that cannot be parsed imports nothing. */
  @Test
  void mutantsOfAModuleAreThoseOfWhatImportersName() {
    ComponentMutator mutator = new ComponentMutator(TestEnvironment.PYTHON);
    SourceText module = SourceText.of("a.py", "def f(x):\n    return x < 2\n");
    assertTrue(mutator.ofModule(module, List.of("import a", "a.f(")).isEmpty());
    assertFalse(mutator.ofModule(module, List.of("from a import *")).isEmpty());
    assertFalse(mutator.ofModule(module, List.of("from a import f as g")).isEmpty());
  }

  @Test
  void idsStayWhereTheRestChanges() {
    String text = "LIMIT = 2.5\n\n\nclass Example:\n    def execute(self, a):\n        return {}\n";
    String later = "# a comment\nimport math\nOTHER = 1.0\n" + text;
    List<ComponentMutant> before = mutants(SourceText.of("a.py", text), "");
    List<ComponentMutant> after = mutants(SourceText.of("a.py", later), "");
    assertEquals("constant in module, LIMIT = 2.5 -> LIMIT = 2.525", before.get(0).id());
    assertEquals(4, before.size());
    assertTrue(after.stream().map(ComponentMutant::id).toList().containsAll(ids(before)));
    assertNotEquals(before.get(0).line(), after.get(after.size() - 1).line());
  }

  private static List<String> ids(List<ComponentMutant> mutants) {
    return mutants.stream().map(ComponentMutant::id).toList();
  }

  @Test
  void whatReadsTheSameIsNumbered() {
    String text = "class Example:\n    def execute(self, a):\n        return a < 1, a < 1\n";
    List<String> ids = ids(mutants(SourceText.of("a.py", text), ""));
    assertTrue(ids.contains("comparison in execute, a < 1 -> a <= 1"), ids::toString);
    assertTrue(ids.contains("comparison in execute, a < 1 -> a <= 1 (2)"), ids::toString);
  }

  @Test
  void aFileThatIsNotPythonHasNoMutants() {
    SourceText source = SourceText.read(FIXTURES.resolve(BROKEN + ".py"));
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> mutants(source, ""));
    assertTrue(refused.diagnostics().get(0).is(ComponentRules.SYNTAX));
  }

  @Test
  void nothingOfTheComponentIsRun() {
    String text = "raise SystemExit(1 + 1)\nwhile True:\n    open('ran', 'w')\n";
    assertTrue(ids(mutants(SourceText.of("a.py", text), "")).stream().noneMatch(String::isEmpty));
  }
}
