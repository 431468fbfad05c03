package dev.eventchain.description;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Test cases, one per folder; {@code expected.txt} holds the findings and, without errors, the
 * model.
 */
class ChainCasesTest {

  private static final Path CASES = Path.of("src/test/resources/cases");

  static final List<WrittenRequirement> REQUIREMENTS =
      List.of(
          new WrittenRequirement(
              "R-1", "The system shall compute the time to collision.", SourceLocation.NONE),
          new WrittenRequirement("R-2", "The system shall brake.", SourceLocation.NONE));

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
      Modeled<EventChain> made = read(folder);
      String found = render(made.diagnostics(), folder);
      return Diagnostic.anyError(made.diagnostics())
          ? found
          : found + new String(XmiStore.toBytes(made.root()), StandardCharsets.UTF_8);
    } catch (DiagnosticException e) {
      assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      return render(e.diagnostics(), folder);
    }
  }

  static Modeled<EventChain> read(Path folder) {
    return EventChainReader.read(
        SourceText.read(folder.resolve("chain.json")), "aeb", REQUIREMENTS, OptionalDouble.empty());
  }

  private static String render(List<Diagnostic> diagnostics, Path folder) {
    return DiagnosticFormat.TEXT.render(diagnostics).replace(folder + "/", "");
  }
}
