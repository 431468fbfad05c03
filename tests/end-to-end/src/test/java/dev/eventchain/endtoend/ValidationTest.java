package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.check.ProjectValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that editors and the command line report the same findings about a project. */
class ValidationTest {

  @TempDir Path folder;

  @ParameterizedTest(name = "{index}: {0} {3}")
  @CsvSource(
      delimiter = '|',
      value = {
        "model/chain.xmi|demo_msgs/msg/BrakeRequest\" fieldName=\"active|demo_msgs/msg/BrakeRequest\" fieldName=\"on|contract.field.unknown",
        "model/chain.xmi|nextstep=\"//@software.1\"|nextstep=\"//@software.0\"|ocl.violated",
        "model/chain.xmi|nextstep=\"//@software.1\"|nextstep=\"//@software.7\"|xmi.reference.unresolved",
        "model/chain.xmi|id=\"RAD-4\"|id=\"RAD-5\"|project.requirement.unknown",
        "model/chain.xmi|first=\"//@software.0\"||ocl.violated",
        "software-base/msg/demo_msgs/msg/Threat.msg|float32 closing_speed|flot32 closing_speed|message.",
        "requirements.md|- RAD-2|- RAD-1|modeler.requirements.duplicate",
        "eventchain.yaml|name: radar_aeb|name: Radar|project.configuration",
      })
  void aBrokenProjectIsBrokenForBoth(String file, String text, String by, String expected)
      throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace(file, text, by == null ? "" : by);
    assertTrue(agreed(copy.path(), true).contains(expected), expected);
  }

  @Test
  void aTopicThatOnlyTheBenchStillHasIsFoundThereByTheProgramAlone() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace("software-base/signals.json", "/cluster/collision_warning", "/cluster/warning");
    ProjectFolder opened = new ProjectFolder(copy.path());
    List<Diagnostic> found =
        ProjectValidation.validate(opened, opened.defaultOutput(), Duration.ofSeconds(30))
            .diagnostics();
    assertEquals(List.of("contract.consumer.missing"), found.stream().map(Diagnostic::id).toList());
    new Program()
        .run("validate", copy.path())
        .expect(1)
        .says("contract.consumer.missing")
        .says("signals.json says nothing about /cluster/collision_warning");
  }

  @Test
  void aChainThatARunHasMadeIsSoundForBoth() throws IOException {
    Path project = Program.exampleIn(folder);
    new Program().run("run", project, "--to", "constrain").expect(0);
    assertEquals("[ ]", agreed(project, false));
  }

  /** Returns the findings of both, which are the same, as are the checks. */
  private static String agreed(Path project, boolean broken) throws IOException {
    ProjectFolder opened = new ProjectFolder(project);
    Validation validation =
        ProjectValidation.validate(opened, opened.defaultOutput(), Duration.ofSeconds(30));
    Program.Ended ended = new Program().run("validate", project, "--format", "json");
    JsonNode said = new ObjectMapper().readTree(ended.out());
    List<Diagnostic> found = validation.diagnostics();
    Report report = new Report("", ended.code(), validation.coverage(), found, List.of());
    JsonNode told = new ObjectMapper().readTree(DiagnosticFormat.JSON.render(report));
    for (String part : List.of("summary", "files", "checks", "findings")) {
      assertEquals(said.get(part).toPrettyString(), told.get(part).toPrettyString(), part);
    }
    assertEquals(broken, Diagnostic.anyError(found), found.toString());
    return told.get("findings").toPrettyString();
  }
}
