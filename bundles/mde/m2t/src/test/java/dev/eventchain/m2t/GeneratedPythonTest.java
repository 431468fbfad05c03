package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.output.OutputFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The template sets for Python generate valid Python for any model. */
class GeneratedPythonTest {
  private static final Path CASES = Path.of("src/test/resources/cases");

  @TempDir Path temporary;

  @ParameterizedTest
  @ValueSource(strings = {"ros2-python", "cyclonedds-python"})
  void everyGeneratedModuleCompiles(String set) throws Exception {
    List<String> command = new ArrayList<>(List.of("python3", "-W", "error", "-m", "py_compile"));
    try (Stream<Path> all = Files.list(CASES.resolve(set))) {
      for (Path folder : all.sorted().toList()) {
        command.addAll(write(folder));
      }
    }
    assertFalse(command.size() < 15, "there are modules to compile");
    Process python = new ProcessBuilder(command).redirectErrorStream(true).start();
    String output = new String(python.getInputStream().readAllBytes(), UTF_8);
    assertEquals(0, python.waitFor(), output);
  }

  private List<String> write(Path folder) throws IOException {
    List<String> modules = new ArrayList<>();
    Path base = temporary.resolve(folder.getFileName().toString());
    try (OutputFolder output = OutputFolder.open(base)) {
      for (Map.Entry<String, byte[]> file : new TemplateCase(folder).run().files().entrySet()) {
        output.write(file.getKey(), file.getValue());
        if (file.getKey().endsWith(".py")) {
          modules.add(base.resolve(file.getKey()).toString());
        }
      }
    }
    return modules;
  }
}
