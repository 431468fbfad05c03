package dev.eventchain.pipeline.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.RosDistribution;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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
    assertEquals(RosDistribution.HUMBLE, configuration.distribution());
    assertEquals("replay", configuration.llm());
    assertEquals("ros2-python", configuration.template());
    assertEquals(List.of("person"), configuration.models("design"));
    assertEquals(Map.of(), configuration.packageFacts());
  }

  @Test
  void strengthIsMeasuredUnlessTheProjectDoesNotWantIt() throws IOException {
    StrengthSettings usual = open("name: aeb\n").configuration().strength();
    assertEquals(StrengthSettings.DEFAULT, usual);
    assertEquals(StrengthExtent.SAMPLE, usual.extent());
    assertEquals(600, usual.budget());
    assertEquals(usual, open("name: aeb\nstrength: on\n").configuration().strength());
    for (StrengthExtent extent : StrengthExtent.values()) {
      String yaml = "name: aeb\nstrength: " + extent.word() + "\n";
      assertEquals(extent, open(yaml).configuration().strength().extent());
    }
    StrengthSettings stricter =
        open("name: aeb\nstrength: {minimum_percent: 60, requirements: {AEB-2: 40}}\n")
            .configuration()
            .strength();
    assertEquals(StrengthExtent.SAMPLE, stricter.extent());
    assertEquals(60, stricter.minimumOf("AEB-1"));
    assertEquals(40, stricter.minimumOf("AEB-2"));
  }

  @Test
  void theBudgetOfStrengthIsForSamples() throws IOException {
    StrengthSettings some =
        open("name: aeb\nstrength: {budget_s: 90}\n").configuration().strength();
    assertEquals(90, some.budget(StrengthExtent.SAMPLE).seconds());
    StrengthSettings all =
        open("name: aeb\nstrength: {extent: whole, budget_s: 90}\n").configuration().strength();
    assertEquals(StrengthExtent.WHOLE, all.extent());
    assertEquals(Double.POSITIVE_INFINITY, all.budget(all.extent()).seconds());
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
        "''|1:1|empty",
        "# nothing yet|1:1|empty",
        "[]|1:1|a mapping, not a list",
        "just a text|1:1|a mapping, not a string",
        "title: X|1:1|'name' is missing",
        "name: ../../x|1:7|'../../x'",
        "name: Aeb|1:7|'Aeb'",
        "name: 12|1:7|a string, not a number 12",
        "name: aeb; nam: x|2:1|no key 'nam'",
        "name: aeb; name: b|2:1|'name' is duplicated",
        "name: aeb; title: 5|2:8|a string, not a number 5",
        "name: aeb; title: true|2:8|a string, not a Boolean",
        "name: aeb; title: \"a\\0b\"|2:8|control character U+0000",
        "name: aeb; frequency: fast|2:12|a number, not a string \"fast\"",
        "name: aeb; frequency: '20'|2:12|a number, not a string \"20\"",
        "name: aeb; frequency: .nan|2:12|a number",
        "name: aeb; frequency: 020|2:12|a number, not a string \"020\"",
        "name: aeb; frequency: 1:30|2:12|a number",
        "name: aeb; frequency: 1e999|2:12|at most 10000",
        "name: aeb; frequency: -1|2:12|above 0 and at most 10000, not -1",
        "name: aeb; frequency: 0|2:12|above 0",
        "name: aeb; frequency: yes|2:12|a number",
        "name: aeb; ros_distro: kilted|2:13|The messages of ROS 2 'kilted' are not known",
        "name: aeb; ros_distro: Jazzy|2:13|ROS 2 'Jazzy'",
        "name: aeb; ros_distro: [jazzy]|2:13|a string",
        "name: aeb; ros_distro:|2:12|there is nothing here",
        "name: aeb; repairs: 1000|2:10|from 0 to 20, not 1000",
        "name: aeb; repairs: 2.5|2:10|a whole number, not a number 2.5",
        "name: aeb; repairs: '2'|2:10|a whole number",
        "name: aeb; repairs:|2:9|there is nothing here",
        "name: aeb; models: {dessign: x}|2:10|no key 'dessign'",
        "name: aeb; models: [1]|2:9|a mapping",
        "name: aeb; models: {design: }|2:17|there is nothing here",
        "name: aeb; models: {design: ''}|2:18|'design' is empty",
        "name: aeb; models: &m {design: *m}|2:21|Aliases are not read",
        "name: aeb; strength:|2:10|there is nothing here",
        "name: aeb; strength: 50|2:11|a mapping",
        "name: aeb; strength: half|2:11|a mapping",
        "name: aeb; strength: {extent: off}|2:20|'whole' or 'sample', not 'off'",
        "name: aeb; strength: {budget_s: 0}|2:22|above zero, not 0",
        "name: aeb; strength: {minimum: 50}|2:12|no key 'minimum'",
        "name: aeb; strength: {minimum_percent: 101}|2:29|from 0 to 100, not 101",
        "name: aeb; strength: {requirements: {A: -1}}|2:30|from 0 to 100, not -1",
        "name: aeb; package: MIT|2:10|a mapping",
        "name: aeb; package: {licence: MIT}|2:11|no key 'licence'",
        "name: aeb; ---; name: b|2:1|A second document",
        "name: [|2:1|not valid YAML",
      })
  void whatIsNotUnderstoodIsSaidWithItsPlace(String yaml, String place, String message) {
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> open(yaml.replace("; ", "\n") + "\n"));
    assertEquals(DiagnosticException.Reason.INPUT, e.reason());
    Diagnostic found = e.diagnostics().get(0);
    assertEquals("project.configuration", found.id());
    assertTrue(found.location().toString().endsWith(":" + place), found.toString());
    assertTrue(found.message().contains(message), found.message());
    assertEquals(1, e.diagnostics().size(), e.diagnostics().toString());
    assertFalse(found.message().matches("(?s).*(java\\.|Exception|dev\\.).*"), found.message());
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
