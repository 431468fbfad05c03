package dev.eventchain.jsonmodels;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs one case per folder; {@code expected.txt} holds the findings, or without errors the model,
 * too.
 */
class InstanceCasesTest {

  private static final Path CASES = Path.of("src/test/resources/cases");

  static Stream<String> cases() throws IOException {
    return ExpectedFile.cases(CASES);
  }

  @ParameterizedTest
  @MethodSource("cases")
  void saysWhatIsExpected(String name) throws IOException {
    Path folder = CASES.resolve(name);
    ExpectedFile.check(folder.resolve("expected.txt"), outcome(folder));
  }

  private static String outcome(Path folder) {
    try {
      InstanceModeler modeler = new InstanceModeler(TestMetamodels.library());
      Modeled<List<EObject>> made = modeler.model(SourceText.read(folder.resolve("instance.json")));
      String found = render(made.diagnostics(), folder);
      return Diagnostic.anyError(made.diagnostics())
          ? found
          : found + new String(XmiStore.toBytes(made.root()), StandardCharsets.UTF_8);
    } catch (DiagnosticException e) {
      assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      return render(e.diagnostics(), folder);
    }
  }

  private static String render(List<Diagnostic> diagnostics, Path folder) {
    return DiagnosticFormat.TEXT.render(diagnostics).replace(folder + "/", "");
  }
}
