package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ProjectTest {

  @TempDir Path folder;

  @Test
  void aNameIsEnough() throws IOException {
    Configuration configuration = open("name: lane_keeping\n").configuration();
    assertEquals("lane_keeping", configuration.title());
    assertEquals(20, configuration.frequency());
    assertEquals("replay", configuration.llm());
    assertEquals("ros2-python", configuration.template());
    assertEquals("person", configuration.model(Stage.DESIGN));
    assertEquals(Map.of(), configuration.packageFacts());
  }

  @Test
  void whatThePackageSaysOfItselfIsForTheTemplates() throws IOException {
    String yaml = "name: aeb\npackage: {license: EPL-2.0, maintainer: Åsa, email: a@b.example}\n";
    assertEquals(
        Map.of(
            "package.license", "EPL-2.0",
            "package.maintainer", "Åsa",
            "package.email", "a@b.example"),
        open(yaml).configuration().packageFacts());
    assertEquals(
        Map.of("package.license", "MIT"),
        open("name: aeb\npackage:\n  license: MIT\n  email:\n").configuration().packageFacts());
  }

  @ParameterizedTest(name = "{index}: {0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "''|0|empty",
        "title: X|0|'name' is missing",
        "name: ../../x|1|'../../x'",
        "name: Aeb|1|'Aeb'",
        "name: aeb; nam: x|2|no setting 'nam'",
        "name: aeb; name: b|2|Duplicate",
        "name: aeb; frequency: fast|2|a number in Hz",
        "name: aeb; frequency: .nan|2|frequency",
        "name: aeb; frequency: -1|2|frequency",
        "name: aeb; repairs: 1000|2|repairs",
        "name: aeb; models: {dessign: x}|2|no task 'dessign'",
        "name: aeb; models: [1]|2|a mapping",
        "name: aeb; package: MIT|2|a mapping with texts",
        "name: aeb; package: {licence: MIT}|2|no setting 'licence'",
      })
  void whatIsNotUnderstoodIsSaidWithItsPlace(String yaml, int line, String message) {
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> open(yaml.replace("; ", "\n") + "\n"));
    assertEquals(DiagnosticException.Reason.INPUT, e.reason());
    Diagnostic found = e.diagnostics().get(0);
    assertEquals("project.configuration", found.id());
    assertEquals(line, found.location().line(), found.toString());
    String expected = message == null ? "" : message;
    assertTrue(found.message().contains(expected), found.message());
  }

  @Test
  void aFolderWithoutConfigurationIsNoProject() {
    DiagnosticException e = assertThrows(DiagnosticException.class, () -> Project.open(folder));
    assertEquals("project.missing", e.diagnostics().get(0).id());
    assertThrows(DiagnosticException.class, () -> Project.open(folder.resolve("none")));
  }

  private Project open(String yaml) throws IOException {
    Files.writeString(folder.resolve("eventchain.yaml"), yaml);
    return Project.open(folder);
  }
}
