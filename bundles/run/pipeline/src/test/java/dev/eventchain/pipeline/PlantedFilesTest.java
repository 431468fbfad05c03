package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ModelValidation;
import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.lifecycle.AfterProperty;
import net.jqwik.api.lifecycle.BeforeProperty;

/**
 * Tests that exactly the faults planted in random model files (violated constraints over
 * references, multiplicities, single ends) are found, at their lines.
 */
class PlantedFilesTest {

  private static final Duration LIMIT = Duration.ofMinutes(10);

  private Path folder;

  @BeforeProperty
  void makeFolder() throws IOException {
    folder = Files.createTempDirectory("planted");
  }

  @AfterProperty
  void removeFolder() throws IOException {
    try (var files = Files.list(folder)) {
      files.forEach(file -> file.toFile().delete());
    }
    Files.delete(folder);
  }

  /** The metamodel changes with the seed, so a neighbouring seed is no simpler case. */
  @Property(shrinking = ShrinkingMode.OFF)
  void allThatWasPlantedIsFoundAndNothingElse(@ForAll long seed) {
    PlantedFiles planted = new PlantedFiles(seed);
    List<Diagnostic> found = validate(planted);
    // Whether a rule concerns a model at all is random.
    List<String> findings =
        found.stream()
            .filter(each -> !each.id().equals("ocl.model-unconstrained"))
            .map(PlantedFilesTest::text)
            .sorted()
            .toList();
    assertEquals(planted.expected(), findings, () -> found + "\n" + planted);
  }

  private List<Diagnostic> validate(PlantedFiles planted) {
    try {
      planted.write(folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return ModelValidation.validate(
            ModelFiles.of(planted.models(folder), planted.metamodels(folder)),
            planted.documents(folder),
            List.of(),
            LIMIT)
        .diagnostics();
  }

  private static String text(Diagnostic found) {
    Path file = Path.of(found.location().file()).getFileName();
    String what = found.id().equals("ocl.violated") ? found.rule() : found.id();
    return file + ":" + found.location().line() + " " + what;
  }
}
