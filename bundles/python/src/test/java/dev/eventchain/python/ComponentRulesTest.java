package dev.eventchain.python;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ComponentRulesTest {

  private static final Path FIXTURES = Path.of("src/test/resources/components");
  private static final ComponentSignature SIGNATURE =
      new ComponentSignature("TTC", List.of("distance", "speed"), List.of("ttc"));

  private final ComponentRules rules = new ComponentRules(TestEnvironment.PYTHON);

  @TempDir Path folder;

  @Test
  void findingsAreThoseOfEachFile() {
    List<Diagnostic> found =
        rules.check(
            List.of(
                candidate(FIXTURES.resolve("component.import.forbidden/bad_middleware.py")),
                candidate(FIXTURES.resolve("component.import.forbidden/good.py")),
                candidate(FIXTURES.resolve("component.class.missing/bad_renamed.py"))));
    assertEquals(
        List.of(
            "component.class.missing bad_renamed.py:1:1",
            "component.import.forbidden bad_middleware.py:1:1",
            "component.import.forbidden bad_middleware.py:2:1"),
        found.stream().map(ComponentRulesTest::shortly).toList());
  }

  @Test
  void nothingOfTheFileRuns() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("component.py"),
            "class TTC:\n    x = 1 / 0\n    def execute(self, distance, speed):\n        return {}\n");
    assertEquals(List.of(), rules.check(List.of(candidate(file))));
  }

  @Test
  void nothingToCheckIsNothingWrong() {
    assertEquals(List.of(), rules.check(List.of()));
  }

  @Test
  void missingFileIsNamed() {
    List<ComponentRules.Candidate> missing = List.of(candidate(folder.resolve("missing.py")));
    var failure = assertThrows(DiagnosticException.class, () -> rules.check(missing));
    assertEquals("file.missing", failure.diagnostics().get(0).id());
  }

  private static ComponentRules.Candidate candidate(Path file) {
    return new ComponentRules.Candidate(file, SIGNATURE);
  }

  private static String shortly(Diagnostic finding) {
    String place = finding.location().toString();
    return finding.id() + " " + place.substring(place.lastIndexOf('/') + 1);
  }
}
