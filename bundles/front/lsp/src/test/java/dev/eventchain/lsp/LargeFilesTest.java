package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.check.FileChecks;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.AnyModel;
import dev.eventchain.project.SuppressionFile;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A check of a file, as after each pause in typing, takes time in proportion to its length. */
class LargeFilesTest {

  private static final int FEW = 60;
  private static final int TIMES = 6;
  private static final int ROUNDS = 5;

  /** Between what is proportional, with allowance for what varies, and what is quadratic. */
  private static final double MOST = 2.0 * TIMES;

  private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

  @TempDir private Path folder;

  @Test
  void rules() throws IOException {
    assertProportional(
        "rules.ocl",
        number ->
            String.format(
                Locale.ROOT,
                """
            context EClass
              def: many%1$d : Boolean = self.eAllReferences->size() > %1$d
              inv Rule%1$d: self.eAllStructuralFeatures->forAll(f | f.name.size() > %1$d)

            """,
                number),
        file -> FileChecks.rules(file, List.of()).diagnostics());
  }

  @Test
  void templates() throws IOException {
    String head = "[module main('" + EcorePackage.eNS_URI + "')]\n";
    assertProportional(
        "main.mtl",
        number ->
            (number == 0 ? head : "")
                + String.format(
                    Locale.ROOT,
                    """
                [query public wide%1$d(c : EClass) : Boolean = c.eAttributes->size() > %1$d /]
                [template public page%1$d(c : EClass)]
                [for (f | c.eAllStructuralFeatures)]
                  [if (f.eContainingClass.wide%1$d())][f.name.toUpperFirst()/][/if]
                [/for]
                [/template]
                """,
                    number),
        file ->
            AnyModel.compile(
                List.of(),
                ReferenceFolders.NONE,
                List.of(new AnyModel.Template(file, List.of(), List.of(), List.of()))));
  }

  @Test
  void suppressions() throws IOException {
    assertProportional(
        "eventchain-suppressions.yaml",
        number ->
            String.format(
                Locale.ROOT,
                """
            - id: ocl.violated
              message: "*%d*"
              reason: Later.
              expires: 2027-03-31
            """,
                number),
        file -> {
          SuppressionFile.read(file, LocalDate.of(2026, 11, 21));
          return List.of();
        });
  }

  private void assertProportional(
      String name, IntFunction<String> part, Function<Path, List<Diagnostic>> check)
      throws IOException {
    Path file = folder.resolve(name);
    milliseconds(file, FEW, part, check); // the first calls load classes and are compiled
    double few = milliseconds(file, FEW, part, check);
    double many = milliseconds(file, FEW * TIMES, part, check);
    assertTrue(many < MOST * few, few + " ms, and " + many + " ms for " + TIMES + " times as much");
  }

  /** Returns the median of the processor time of some checks. */
  private static double milliseconds(
      Path file, int parts, IntFunction<String> part, Function<Path, List<Diagnostic>> check)
      throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < parts; i++) {
      text.append(part.apply(i));
    }
    Files.writeString(file, text);
    double[] times = new double[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
      long start = CLOCK.getCurrentThreadCpuTime();
      assertEquals(List.of(), check.apply(file));
      times[i] = (CLOCK.getCurrentThreadCpuTime() - start) / 1e6;
    }
    Arrays.sort(times);
    return times[ROUNDS / 2];
  }
}
