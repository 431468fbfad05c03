package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.metamodel.Names;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Tests that the examples of OMG OCL 2.4, section 7, have the values that the standard gives, or
 * are reported as unsupported or unchecked.
 */
class StandardExamplesTest {

  private static final Path FOLDER = Path.of("src", "test", "resources", "standard-examples");

  private final TestModels models = new TestModels(FOLDER, FOLDER);
  private final EPackage metamodel = models.metamodel();
  private final EObject town = models.load("town.xmi");

  /** An example: its title, the document, and the expected findings. */
  private record Example(String title, String document, List<String> expected) {

    static Example of(String text) {
      List<String> lines = text.lines().toList();
      List<String> document = new ArrayList<>();
      List<String> expected = new ArrayList<>();
      for (String line : lines.subList(1, lines.size())) {
        (line.startsWith("->") ? expected : document).add(line);
      }
      assertFalse(expected.isEmpty(), () -> lines.get(0) + ": nothing says what is found");
      List<String> found = expected.stream().map(line -> line.substring(2).strip()).toList();
      boolean nothing = found.equals(List.of(""));
      return new Example(lines.get(0), String.join("\n", document), nothing ? List.of() : found);
    }
  }

  @TestFactory
  Stream<DynamicTest> examplesOfTheStandardAreUnderstoodOrRefusedByName() throws IOException {
    String[] texts = Files.readString(FOLDER.resolve("examples.txt")).split("(?m)^## ");
    return Stream.of(texts)
        .skip(1)
        .map(Example::of)
        .map(example -> DynamicTest.dynamicTest(example.title(), () -> check(example)));
  }

  private void check(Example example) {
    OclRules rules =
        OclRules.parse(
            List.of(SourceText.of("example.ocl", example.document())), List.of(metamodel));
    List<String> found =
        OclValidator.validate(
                rules,
                List.of(town),
                element -> SourceLocation.of("town.xmi").withElement(Names.pathOf(element)))
            .diagnostics()
            .stream()
            .map(StandardExamplesTest::text)
            .sorted()
            .toList();
    assertEquals(example.expected(), found);
  }

  /** Returns a finding about an element or the document, with its place. */
  private static String text(Diagnostic found) {
    String what =
        switch (found.id()) {
          case "ocl.violated" -> "violates " + found.rule();
          case "ocl.undefined" -> "has no value for " + found.rule();
          default -> found.id() + " " + found.message();
        };
    SourceLocation place = found.location();
    return place.element().isEmpty()
        ? what + (place.line() > 0 ? " (" + place.line() + ":" + place.column() + ")" : "")
        : place.element().replaceFirst(".*\\[(.*)\\]$", "$1") + " " + what;
  }
}
