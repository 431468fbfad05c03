package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
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
 * Tests each id of this bundle and of expressions: {@code rules/ID/good.ocl} does not give it and
 * {@code bad.ocl} does, on the model {@code rules/model.xmi}, together with {@code
 * rules/ID/other.ocl} if there is one. The expected findings are next to each. A missing
 * expectation is written, and the test fails.
 */
class RuleFixturesTest {

  private static final Path FIXTURES = Path.of("src", "test", "resources", "rules");

  @TestFactory
  Stream<DynamicTest> everyIdHasAGoodAndABadCase() throws IOException {
    List<DynamicTest> tests = new ArrayList<>();
    try (Stream<Path> own = Files.list(Path.of("rules"));
        Stream<Path> ofExpressions = Files.list(Path.of("..", "ocl", "rules"))) {
      for (Path page : Stream.concat(own, ofExpressions).sorted().toList()) {
        String id = page.getFileName().toString().replaceFirst("\\.md$", "");
        for (String kind : List.of("good", "bad")) {
          tests.add(DynamicTest.dynamicTest(id + " " + kind, () -> check(id, kind)));
        }
      }
    }
    return tests.stream();
  }

  private static void check(String id, String kind) throws IOException {
    List<Diagnostic> diagnostics = validate(FIXTURES.resolve(id).resolve(kind + ".ocl"));
    String found = DiagnosticFormat.TEXT.render(diagnostics);
    ExpectedFile.check(FIXTURES.resolve(id).resolve(kind + ".expected"), found);
    assertEquals(
        kind.equals("bad"), diagnostics.stream().anyMatch(each -> each.id().equals(id)), found);
  }

  private static List<Diagnostic> validate(Path rules) throws IOException {
    Path own = rules.resolveSibling("metamodel.ecore");
    TestModels models =
        Files.exists(own)
            ? new TestModels(own.getParent(), own.getParent())
            : new TestModels(FIXTURES, TestModels.shared("library"));
    EPackage metamodel = models.metamodel();
    EObject model = models.load("model.xmi");
    List<SourceText> documents = new ArrayList<>();
    for (Path file : List.of(rules, rules.resolveSibling("other.ocl"))) {
      if (Files.exists(file)) {
        documents.add(SourceText.of(file.getFileName().toString(), Files.readString(file)));
      }
    }
    return OclValidator.validate(
            OclRules.parse(documents, List.of(metamodel)),
            List.of(model),
            element -> SourceLocation.of("model.xmi").withElement(Names.pathOf(element)))
        .diagnostics();
  }
}
