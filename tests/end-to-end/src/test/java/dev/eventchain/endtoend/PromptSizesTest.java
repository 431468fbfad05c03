package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the prompts of the emergency braking fit into a chat, with all that they name. */
class PromptSizesTest {

  @TempDir private Path folder;

  @Test
  void promptsAreShort() throws IOException {
    Path project = Program.copyOf("aeb", folder);
    Path design = folder.resolve("design");
    String noAnswers = "eventchain.yaml";
    new Program().run("run", withoutRecordings(project, "design"), "--llm", "handoff:" + design);
    assertSize(design.resolve("design-01.prompt.md"), 20_000);
    new Program().run("run", withoutRecordings(again(), "model"), "--llm", "handoff:" + design);
    assertSize(design.resolve("model-01.prompt.md"), 25_000);
    new Program().run("run", withoutRecordings(again(), "constrain"), "--llm", "handoff:" + design);
    assertSize(design.resolve("constrain-01.prompt.md"), 20_000);
    assertTrue(Files.exists(project.resolve(noAnswers)));
  }
}
