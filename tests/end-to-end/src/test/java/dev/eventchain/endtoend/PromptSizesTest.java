package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that the prompts of the emergency braking are short, as they are given to a chat. */
class PromptSizesTest {

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({"design, 20000", "constrain, 20000", "model, 25000"})
  void promptsAreShort(String task, int most) throws IOException {
    Path project = Program.exampleIn(folder);
    delete(project.resolve("recordings").resolve(task));
    Path asked = folder.resolve("asked");
    new Program().run("run", project, "--llm", "handoff:" + asked).expect(4);
    long size = Files.size(asked.resolve(task + "-01.prompt.md"));
    assertTrue(size <= most, () -> size + " bytes");
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      List<Path> all = files.sorted(Comparator.reverseOrder()).toList();
      for (Path file : all) {
        Files.delete(file);
      }
    }
  }
}
