package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which questions a run asks a person, and which it need not ask. */
class HandoffRunTest {

  @TempDir Path folder;
  private Path project;

  @BeforeEach
  void copyExample() throws IOException {
    project = Program.exampleIn(folder);
  }

  @Test
  void promptsThatDoNotWaitForEachOtherAreWrittenAtOnce() throws IOException {
    forget("implement", "model", "constrain");
    run().expect(4).says("llm.handoff.waiting").says("waiting for 4 answers");
    assertEquals(
        List.of(
            "constrain-01.prompt.md",
            "implement-01.prompt.md",
            "implement-02.prompt.md",
            "model-01.prompt.md"),
        prompts());
  }

  @Test
  void whatIsRecordedIsNotAskedFor() throws IOException {
    forget("model");
    run().expect(4);
    assertEquals(List.of("model-01.prompt.md"), prompts());
    assertTrue(Files.exists(project.resolve("out/generated.ocl")));
  }

  @Test
  void nothingIsAskedBeforeTheDesignIsThere() throws IOException {
    forget("design", "implement", "model", "constrain");
    run().expect(4);
    assertEquals(List.of("design-01.prompt.md"), prompts());
  }

  @Test
  void whyTheAnswerBeforeWasRefusedIsSaid() throws IOException {
    forget("design");
    design().expect(4).says("waiting for 1 answer");
    Files.writeString(folder.resolve("handoff/design-01.answer.md"), "{\"a\": 1}\n");
    design()
        .expect(4)
        .says("design-02.prompt.md")
        .says("The previous answer was sent back: The file must hold an array, not an object.")
        .says("[agents.answer.returned]");
  }

  @Test
  void aModelThatIsMadeDirectlyHasNoPrompt() throws IOException {
    forget("model");
    Path configuration = project.resolve("eventchain.yaml");
    String text = Files.readString(configuration);
    Files.writeString(configuration, text.replace("model: authored", "model: direct"));
    new Program().run("run", project, "--to", "model").expect(0).says(", directly");
    assertTrue(Files.exists(project.resolve("out/chain.xmi")));
  }

  @Test
  void whatPeopleAcceptOfADesignSendsNoAnswerBack() throws IOException {
    new Program().run("run", project, "--to", "design").expect(0);
    String chain = Files.readString(project.resolve("out/chain.json"));
    String other = chain.replaceFirst("\"frequency\" ?: 20(.0)?", "\"frequency\": 40.0");
    assertTrue(!other.equals(chain));
    forget("design");
    design().expect(4).says("design-01");
    Files.writeString(folder.resolve("handoff/design-01.answer.md"), "```json\n" + other + "```\n");
    design().expect(4).says("llm.handoff.waiting").says("design-02");
    Files.writeString(
        project.resolve("eventchain-suppressions.yaml"),
        """
        - id: modeler.component.value.changed
          element: "*/frequency"
          file: out/chain.json
          reason: The supplier has agreed.
          expires: 2027-03-31
        """);
    design().expect(0).says("1 finding suppressed");
    assertTrue(Files.readString(project.resolve("out/chain.json")).contains("40.0"));
  }

  private Program.Ended design() {
    return new Program()
        .run(
            "run",
            project,
            "--to",
            "design",
            "--date",
            "2026-11-30",
            "--llm",
            "handoff:" + folder.resolve("handoff"));
  }

  private Program.Ended run() {
    return new Program().run("run", project, "--llm", "handoff:" + folder.resolve("handoff"));
  }

  private List<String> prompts() throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve("handoff"))) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  private void forget(String... tasks) throws IOException {
    for (String task : tasks) {
      try (Stream<Path> files = Files.walk(project.resolve("recordings").resolve(task))) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }
}
