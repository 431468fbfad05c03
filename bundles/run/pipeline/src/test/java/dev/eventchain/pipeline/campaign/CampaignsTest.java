package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests campaigns whose project is changed meanwhile. */
class CampaignsTest {

  @TempDir Path folder;

  /** Whatever is changed: the bench after a case, or the campaign itself before the first. */
  @Test
  void resultsOfTwoStatesAreDropped() throws IOException {
    Path example = Path.of("../../../examples/radar-aeb").toAbsolutePath().normalize();
    Path copy = Projects.withoutStrength(Projects.copy(example, folder.resolve("radar-aeb")));
    Path file =
        Files.writeString(
            folder.resolve("two.yaml"),
            "scenario: stopped-vehicle-50\nfactors: {v: {path: ego.speed_kmh, values: [50]}}\n");
    Project project = Project.open(copy);
    Path output = project.defaultOutput();
    RunOptions settings = RunOptions.of(output).in(output, Stage.DESIGN, Stage.GENERATE);
    CampaignOptions options =
        new CampaignOptions(
            file,
            Optional.empty(),
            false,
            Shard.ALL,
            OptionalInt.empty(),
            List.of(),
            Optional.empty(),
            Optional.empty());
    for (Progress changing :
        List.of(changing(file, ""), changing(copy.resolve("bench.yaml"), "case "))) {
      DiagnosticException refused =
          assertThrows(
              DiagnosticException.class, () -> Campaigns.run(project, settings, options, changing));
      assertEquals("campaign.inputs.changed", refused.diagnostics().get(0).id());
    }
    assertFalse(Files.exists(output.resolve("campaigns/two/cases.json")));
    assertFalse(Files.exists(output.resolve("campaigns/two/parts/000001.json")));
  }

  /** Returns a progress that changes a file at each step that begins with a text. */
  private static Progress changing(Path file, String start) {
    return new Progress() {
      @Override
      public void started(Stage stage) {
        step(stage, "");
      }

      @Override
      public void step(Stage stage, String message) {
        if (message.startsWith(start)) {
          try {
            Files.writeString(file, "# Changed.\n", StandardOpenOption.APPEND);
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        }
      }

      @Override
      public void ended(Stage stage, Status status, Duration duration, String details) {}
    };
  }
}
