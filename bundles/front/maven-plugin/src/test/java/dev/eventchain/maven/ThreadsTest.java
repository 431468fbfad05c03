package dev.eventchain.maven;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Diagnostic;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;

/**
 * Tests that goals marked as thread-safe work in parallel: modules of one build share the plugin's
 * classes.
 */
class ThreadsTest {

  private static final int BUILDS = 40;

  private static Validation validate(String sample) {
    Path project = Path.of("src/it/modules", sample);
    Path folder = project.resolve("src/main");
    return ModelValidation.validate(
        new ModelFiles(
            List.of(folder.resolve("models/town.library")),
            List.of(folder.resolve("rules/library.ecore")),
            new ReferenceFolders(List.of(project), Map.of())),
        List.of(folder.resolve("rules/library.ocl")),
        List.of(),
        Duration.ofSeconds(30));
  }

  @Test
  void modelsAreValidatedSideBySide() throws InterruptedException, ExecutionException {
    ExecutorService threads = Executors.newFixedThreadPool(8);
    try {
      List<Future<Validation>> good = new ArrayList<>();
      List<Future<Validation>> bad = new ArrayList<>();
      for (int i = 0; i < BUILDS; i++) {
        good.add(threads.submit(() -> validate("good-model")));
        bad.add(threads.submit(() -> validate("bad-model")));
      }
      for (int i = 0; i < BUILDS; i++) {
        assertEquals(List.of(), good.get(i).get().diagnostics());
        assertEquals(3, good.get(i).get().coverage().elements());
        List<String> rules = bad.get(i).get().diagnostics().stream().map(Diagnostic::rule).toList();
        assertEquals(List.of("Book::HasPages"), rules);
      }
    } finally {
      threads.shutdownNow();
    }
  }
}
