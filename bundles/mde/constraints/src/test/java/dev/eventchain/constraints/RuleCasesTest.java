package dev.eventchain.constraints;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.fixtures.TestModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs the cases {@code cases/METAMODEL/CASE}: rules ({@code *.ocl}), models ({@code *.xmi}),
 * perhaps more metamodels ({@code *.ecore}), and the expected findings {@code expected.txt}. A
 * missing expectation is written, and the test fails.
 */
class RuleCasesTest {

  private static final Path CASES = Path.of("src", "test", "resources", "cases");

  static Stream<String> cases() throws IOException {
    return ExpectedFile.cases(CASES);
  }

  @ParameterizedTest
  @MethodSource("cases")
  void everyCaseFindsWhatItExpects(String name) throws IOException {
    Path folder = CASES.resolve(name);
    String metamodel = name.substring(0, name.indexOf('/'));
    ExpectedFile.check(folder.resolve("expected.txt"), run(metamodel, folder));
  }

  private static String run(String metamodelName, Path folder) throws IOException {
    TestModels models = new TestModels(folder, TestModels.shared(metamodelName));
    List<EPackage> packages = new ArrayList<>();
    packages.add(models.metamodel());
    for (Path file : list(folder, ".ecore")) {
      packages.add(models.metamodel(file));
    }
    List<SourceText> documents = new ArrayList<>();
    for (Path file : list(folder, ".ocl")) {
      documents.add(SourceText.of(file.getFileName().toString(), Files.readString(file)));
    }
    OclRules rules = OclRules.parse(documents, packages);
    List<EObject> roots = new ArrayList<>();
    for (Path file : list(folder, ".xmi")) {
      roots.add(models.load(file.getFileName().toString()));
    }
    if (roots.isEmpty()) {
      return String.join(", ", rules.constraintNames())
          + "\n\n"
          + DiagnosticFormat.TEXT.render(rules.diagnostics());
    }
    OclResult result = OclValidator.validate(rules, roots, RuleCasesTest::locate);
    return String.format(
            Locale.ROOT,
            "constraints %d, elements %d, evaluations %d%n%n",
            result.constraints(),
            result.elements(),
            result.evaluations())
        + DiagnosticFormat.TEXT.render(result.diagnostics());
  }

  private static SourceLocation locate(EObject element) {
    return SourceLocation.of(element.eResource().getURI().lastSegment())
        .withElement(element.eResource().getURIFragment(element));
  }

  private static List<Path> list(Path folder, String suffix) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(suffix)).sorted().toList();
    }
  }
}
