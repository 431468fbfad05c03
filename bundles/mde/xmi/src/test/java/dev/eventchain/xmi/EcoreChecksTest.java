package dev.eventchain.xmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.common.util.Diagnostic;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.Diagnostician;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that models hold all statements of their files and conform to their metamodels. */
class EcoreChecksTest {

  private static final Path CASES = Path.of("src/test/resources/ecore");

  static List<String> cases() throws IOException {
    try (Stream<Path> folders = Files.list(CASES)) {
      return folders.map(path -> path.getFileName().toString()).sorted().toList();
    }
  }

  static List<String> goodCases() throws IOException {
    return cases().stream().filter(name -> name.startsWith("good-")).toList();
  }

  private static List<LoadedModel> load(Path folder) {
    XmiStore store = new XmiStore(folder);
    store.loadMetamodel(folder.resolve("metamodel.ecore"));
    return XmiStore.withReferred(store.loadAll(List.of(folder.resolve("model.xmi"))));
  }

  private static String outcome(Path folder) {
    try {
      EcoreChecks checks = EcoreChecks.of(load(folder));
      String evaluated =
          checks.coverage().checks().stream()
              .filter(check -> check.evaluations() > 0)
              .map(check -> check.id() + " " + check.evaluations() + "\n")
              .collect(Collectors.joining());
      return DiagnosticFormat.TEXT.render(checks.diagnostics()).replace(folder + "/", "")
          + evaluated;
    } catch (DiagnosticException e) {
      return DiagnosticFormat.TEXT.render(e.diagnostics()).replace(folder + "/", "");
    }
  }

  /** Runs one case per folder; {@code expected.txt} holds the findings and the number of checks. */
  @ParameterizedTest
  @MethodSource("cases")
  void whatAFileSaysIsInTheModelAndWhatTheMetamodelDemandsToo(String name) throws IOException {
    Path folder = CASES.resolve(name);
    ExpectedFile.check(folder.resolve("expected.txt"), outcome(folder));
  }

  /** The pattern does not terminate in time on any machine. */
  @Test
  void aPatternThatTakesTooLongIsGivenUpAndNothingElse() throws IOException {
    Path folder = Path.of("src/test/resources/patterns");
    EcoreChecks checks = EcoreChecks.of(load(folder), Duration.ofMillis(50));
    String found = DiagnosticFormat.TEXT.render(checks.diagnostics()).replace(folder + "/", "");
    ExpectedFile.check(folder.resolve("expected.txt"), found);
    long values =
        checks.coverage().checks().stream()
            .filter(check -> check.id().equals("ecore.value"))
            .findFirst()
            .orElseThrow()
            .evaluations();
    assertEquals(3, values);
  }

  @Test
  void aPatternThatIsNestedTooDeeplyIsABrokenLimit(@TempDir Path folder) throws IOException {
    Path patterns = Path.of("src/test/resources/patterns");
    String nested = "(".repeat(100_000) + "a" + ")".repeat(100_000);
    String metamodel = Files.readString(patterns.resolve("metamodel.ecore"));
    Files.writeString(
        folder.resolve("metamodel.ecore"), metamodel.replace("(a?){60}a{60}", nested));
    Files.copy(patterns.resolve("model.xmi"), folder.resolve("model.xmi"));
    List<dev.eventchain.diagnostics.Diagnostic> found = EcoreChecks.of(load(folder)).diagnostics();
    assertEquals(4, found.size());
    assertTrue(
        found.stream().anyMatch(each -> each.message().contains("limit of its type is broken")));
  }

  @ParameterizedTest
  @MethodSource("goodCases")
  void whatIsFineIsFineForEmfToo(String name) {
    List<LoadedModel> models = load(CASES.resolve(name));
    assertEquals(List.of(), EcoreChecks.of(models).diagnostics());
    assertEquals(Coverage.Kind.METAMODEL, EcoreChecks.of(models).coverage().checks().get(0).kind());
    for (EObject root : models.get(0).roots()) {
      Diagnostic said = new Diagnostician().validate(root);
      assertEquals(List.of(), said.getChildren(), name);
    }
  }
}
