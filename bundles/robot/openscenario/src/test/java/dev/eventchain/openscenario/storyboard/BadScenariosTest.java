package dev.eventchain.openscenario.storyboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Tests what is found in the scenarios of {@code storyboard}, each of which differs from the good
 * one in one thing. {@code findings.txt} has what is expected.
 */
class BadScenariosTest {

  private static final Path FOLDER = Path.of("src", "test", "resources", "storyboard");

  @Test
  void eachHasItsFindings() throws IOException {
    String actual;
    try (Stream<Path> files = Files.list(FOLDER)) {
      actual =
          files
              .filter(file -> file.toString().endsWith(".xosc"))
              .sorted()
              .map(BadScenariosTest::findings)
              .collect(Collectors.joining("\n"));
    }
    Path expected = FOLDER.resolve("findings.txt");
    if (!Files.exists(expected)) {
      Files.writeString(expected, actual);
    }
    assertEquals(Files.readString(expected), actual);
    assertTrue(actual.contains("good.xosc\n\n"), actual);
  }

  private static String findings(Path file) {
    return file.getFileName()
        + "\n"
        + found(file).stream().map(BadScenariosTest::text).collect(Collectors.joining());
  }

  private static List<Diagnostic> found(Path file) {
    String name = file.getFileName().toString();
    try {
      String text = Files.readString(file);
      return Scenarios.run(Scenarios.tree(SourceText.of(name, text))).findings();
    } catch (DiagnosticException e) {
      return e.diagnostics();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static String text(Diagnostic finding) {
    return "  "
        + finding.severity()
        + " "
        + finding.id()
        + " "
        + finding.location()
        + "\n    "
        + finding.message()
        + "\n    "
        + finding.hint()
        + "\n";
  }
}
