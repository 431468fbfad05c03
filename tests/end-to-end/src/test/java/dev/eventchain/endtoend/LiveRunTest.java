package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the example with answers of a service, in the format of each kind of service. */
class LiveRunTest {

  private static final String KEY = "sk-not-to-be-seen-anywhere";

  @TempDir Path folder;

  private Path project(String wire, String url) throws IOException {
    Path project = Program.exampleIn(folder);
    try (Stream<Path> files = Files.walk(project.resolve("recordings"))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.delete(file);
      }
    }
    Files.writeString(
        project.resolve("eventchain.yaml"),
        """

        services:
          ours: {wire: %s, url: "%s", key: OURS_KEY}
        """
            .formatted(wire, url),
        StandardOpenOption.APPEND);
    return project;
  }

  private static RecordedService service(String wire) throws IOException {
    return new RecordedService(wire, Program.ROOT.resolve("examples/aeb/recordings"));
  }

  static Stream<String> wires() {
    return Thorough.allOrOne(
        List.of("openai", "openai-compatible", "gemini", "anthropic", "ollama"))
        .stream();
  }

  @ParameterizedTest
  @MethodSource("wires")
  void requirementsGetToTheirConstraintsByAnswersOfAService(String wire) throws IOException {
    try (RecordedService service = service(wire)) {
      Path project = project(wire, service.url());
      Program program = new Program().with("OURS_KEY", KEY);
      Program.Ended ended =
          program.run("run", project, "--to", "constrain", "--llm", "ours/authored", "--record");
      ended.expect(0).says("tokens so far");
      assertTrue(service.headers().contains(KEY) || wire.equals("ollama"), service::headers);
      program.run("run", project, "--to", "constrain", "--again", "--llm", "replay").expect(2);
      Files.writeString(
          project.resolve("eventchain.yaml"),
          Files.readString(project.resolve("eventchain.yaml"))
              .replace(": authored", ": ours/authored"));
      program.run("run", project, "--to", "constrain", "--again", "--llm", "replay").expect(0);
      assertFalse((ended.out() + ended.err()).contains(KEY));
      assertEquals(List.of(), filesWith(project));
    }
  }

  @InTurn
  @Test
  void theKeyIsInNoFindingAboutIt() throws IOException {
    try (RecordedService service = service("openai")) {
      Path project = project("gemini", service.url().replace("localhost", "localhost.invalid"));
      Program.Ended ended =
          new Program().with("OURS_KEY", KEY).run("design", project, "--llm", "ours/authored");
      ended.expect(3).says("[llm.service.unreachable]");
      assertFalse((ended.out() + ended.err()).contains(KEY));
      assertEquals(List.of(), filesWith(project));
    }
  }

  private static List<Path> filesWith(Path project) throws IOException {
    try (Stream<Path> files = Files.walk(project)) {
      return files.filter(Files::isRegularFile).filter(LiveRunTest::holdsTheKey).toList();
    }
  }

  private static boolean holdsTheKey(Path file) {
    try {
      return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).contains(KEY);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
