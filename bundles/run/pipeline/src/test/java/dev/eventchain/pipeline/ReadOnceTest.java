package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import dev.eventchain.pipeline.run.Stage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that a run reads the model and the description of the chain once per state of their files.
 */
class ReadOnceTest {

  @TempDir Path folder;

  private final List<String> reads = new ArrayList<>();
  private Path project;

  @BeforeEach
  void copyTheExample() throws IOException {
    Path example = Path.of("../../../examples/aeb").toAbsolutePath().normalize();
    project = folder.resolve("aeb");
    Projects.withoutStrength(Projects.copy(example, project));
  }

  @InTurn
  @Test
  void aRunReadsEachStateOnce() throws IOException {
    assertEquals(Verdict.PASSED, run(Stage.DESIGN).verdict());
    assertEquals(List.of("chain.json", "chain.xmi", "chain.measured.xmi"), reads);
    reads.clear();
    assertEquals(Verdict.PASSED, run(Stage.DESIGN).verdict());
    assertEquals(List.of("chain.xmi", "chain.json", "chain.measured.xmi"), reads);
  }

  @InTurn
  @Test
  void aModelThatChangesDuringARunIsReadAgain() throws IOException {
    run(Stage.DESIGN);
    reads.clear();
    Path model = project.resolve("out/chain.xmi");
    RunResult result =
        run(
            Stage.CONSTRAIN,
            stage -> {
              if (stage == Stage.GENERATE) {
                replace(model, "name=\"TTC_Calculation\"", "name=\"class\"");
              }
            });
    assertEquals(Verdict.FAILED, result.verdict());
    assertEquals(List.of("chain.xmi", "chain.json", "chain.xmi"), reads);
  }

  private static void replace(Path file, String text, String by) {
    try {
      Files.writeString(file, Files.readString(file).replace(text, by));
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private RunResult run(Stage first) {
    return run(first, stage -> {});
  }

  private RunResult run(Stage first, java.util.function.Consumer<Stage> atStart) {
    Project opened = Project.open(project);
    Path output = opened.defaultOutput();
    RunOptions options = RunOptions.of(output).in(output, first, Stage.REPORT);
    return Pipeline.run(
        opened,
        options,
        new Progress() {
          @Override
          public void started(Stage stage) {
            atStart.accept(stage);
          }

          @Override
          public void step(Stage stage, String message) {}

          @Override
          public void ended(Stage stage, Status status, Duration duration, String details) {}

          @Override
          public void read(Path file) {
            reads.add(file.getFileName().toString());
          }
        });
  }
}
