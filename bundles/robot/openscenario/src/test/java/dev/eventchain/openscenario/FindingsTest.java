package dev.eventchain.openscenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.openscenario.document.ScenarioFile;
import dev.eventchain.openscenario.document.Variations;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Findings about wrong files: a folder for each rule, with its expected findings beside it. */
class FindingsTest {

  private static final Path FOLDERS = Path.of("src/test/resources/findings");

  static Stream<Path> folders() throws IOException {
    try (Stream<Path> folders = Files.list(FOLDERS)) {
      return folders.filter(Files::isDirectory).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("folders")
  void findingsAreAsExpected(Path folder) throws IOException {
    List<Diagnostic> found = new ArrayList<>();
    for (Path file : ExpectedFile.inputs(folder, ".xosc")) {
      found.addAll(findings(file, folder));
    }
    String rule = folder.getFileName().toString();
    assertTrue(found.stream().anyMatch(each -> each.id().equals(rule)), rule);
    String actual = DiagnosticFormat.TEXT.render(found);
    ExpectedFile.check(folder.resolveSibling(rule + ".expected"), actual);
  }

  private static List<Diagnostic> findings(Path file, Path root) {
    try {
      ScenarioFile read = ScenarioFile.read(file, root);
      return read.kind() == ScenarioFile.Kind.DISTRIBUTION
          ? Variations.of(read).warnings()
          : read.resolve(Map.of()).warnings();
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
  }

  @Test
  void fileOf100MegabytesIsNotRead(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("large.xosc");
    try (RandomAccessFile large = new RandomAccessFile(file.toFile(), "rw")) {
      large.setLength(100L << 20);
    }
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> ScenarioFile.read(file));
    assertEquals("osc.size", refused.diagnostics().get(0).id());
  }
}
