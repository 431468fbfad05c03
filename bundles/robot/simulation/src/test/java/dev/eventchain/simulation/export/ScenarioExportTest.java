package dev.eventchain.simulation.export;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the files of scenarios, and what is not exported. */
class ScenarioExportTest {

  private static final Path FOLDER = Path.of("src/test/resources/export");

  private static ScenarioExport export(Path file) throws IOException {
    String text = Files.readString(file);
    SourceText source = SourceText.of(file.getFileName().toString(), text);
    return ScenarioExport.of(Scenario.parse(source, Bench.carla()), "software");
  }

  private static String text(ScenarioExport export, String name) {
    return new String(export.files().get(name), StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @ValueSource(strings = {"bend", "waits", "names"})
  void theFilesAreThese(String name) throws IOException {
    ScenarioExport export = export(FOLDER.resolve(name + ".yaml"));
    assertEquals(List.of(), export.diagnostics());
    for (String file : List.of(name + ".xosc", name + ".xodr")) {
      ExpectedFile.check(FOLDER.resolve(file), text(export, file));
    }
    assertEquals(2, export.files().size());
  }

  @Test
  void theSameScenarioHasTheSameBytes() throws IOException {
    Path file = FOLDER.resolve("names.yaml");
    assertArrayEquals(
        export(file).files().get("names.xosc"), export(file).files().get("names.xosc"));
  }

  static Stream<Path> refused() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER.resolve("refused"))) {
      return files.filter(file -> file.toString().endsWith(".yaml")).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("refused")
  void whatCannotBeSaidIsNotWritten(Path file) throws IOException {
    ScenarioExport export = export(file);
    assertTrue(Diagnostic.anyError(export.diagnostics()));
    assertTrue(export.files().isEmpty());
    String name = file.getFileName().toString().replace(".yaml", ".txt");
    ExpectedFile.check(
        file.resolveSibling(name), DiagnosticFormat.TEXT.render(export.diagnostics()));
  }
}
