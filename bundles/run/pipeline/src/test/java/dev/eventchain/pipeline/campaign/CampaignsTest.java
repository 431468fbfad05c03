package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.pipeline.campaign.plan.Shard;
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
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests campaigns whose project is changed meanwhile. */
class CampaignsTest {

  @TempDir Path folder;

  private Path copy;
  private Path file;
  private Project project;
  private Path output;
  private RunOptions settings;
  private CampaignOptions options;

  @BeforeEach
  void copyTheExample() throws IOException {
    Path example = Path.of("../../../examples/radar-aeb").toAbsolutePath().normalize();
    copy = Projects.withoutStrength(Projects.copy(example, folder.resolve("radar-aeb")));
    file =
        Files.writeString(
            folder.resolve("two.yaml"),
            "scenario: stopped-vehicle-50\nfactors: {v: {path: ego.speed_kmh, values: [50]}}\n");
    project = Project.open(copy);
    output = project.defaultOutput();
    settings = RunOptions.of(output).in(output, Stage.DESIGN, Stage.GENERATE);
    options =
        new CampaignOptions(
            file,
            Optional.empty(),
            false,
            Shard.ALL,
            OptionalInt.empty(),
            List.of(),
            Optional.empty(),
            Optional.empty());
  }

  /** Whatever is changed: the bench after a case, or the campaign itself before the first. */
  @Test
  void resultsOfTwoStatesAreDropped() throws IOException {
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

  /** Results kept by then would else be taken for cases of the files as they are again. */
  @Test
  void anInterruptedCampaignKeepsNoCaseAfterAnEditThatIsTakenBack() throws IOException {
    Path bench = copy.resolve("bench.yaml");
    String before = Files.readString(bench);
    Path kept = output.resolve("campaigns/two/parts/000001.json");
    for (boolean edits : new boolean[] {true, false}) {
      Progress progress = edits ? changing(bench, "case ") : changing(folder.resolve("x"), "case ");
      assertThrows(
          IllegalStateException.class,
          () -> Campaigns.run(project, settings, options, interrupted(progress)));
      assertEquals(!edits, Files.exists(kept));
      Files.writeString(bench, before);
    }
  }

  private static Progress interrupted(Progress first) {
    return new Progress() {
      @Override
      public void started(Stage stage) {}

      @Override
      public void step(Stage stage, String message) {
        first.step(stage, message);
        if (message.startsWith("case ")) {
          throw new IllegalStateException("interrupted");
        }
      }

      @Override
      public void ended(Stage stage, Status status, Duration duration, String details) {}
    };
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
            Files.writeString(
                file, "# Changed.\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
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
