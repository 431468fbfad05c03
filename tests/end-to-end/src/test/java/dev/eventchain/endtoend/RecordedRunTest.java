package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests recordings of scenarios on request. */
class RecordedRunTest {

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
  private static final String SCENARIO = "stopped-vehicle-50";
  private static final int TRIES = 20;

  @TempDir static Path folder;

  private static Path project;
  private static Path recordings;

  @BeforeAll
  static void run() throws IOException {
    project = FinishedRun.in(folder).path();
    recordings = project.resolve("out/mcap");
    assertFalse(Files.exists(recordings));
  }

  private static List<String> recorded() throws IOException {
    if (!Files.exists(recordings)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(recordings)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  /** Unchanged scenarios are simulated again, and only the recordings are new. */
  @InTurn
  @Test
  void aRunRecordsEachScenarioAndStaysWhatItWas() throws IOException {
    byte[] verdict = Files.readAllBytes(project.resolve("out/verdict.json"));
    Path file = recordings.resolve(SCENARIO + ".mcap");
    new Program().run("run", project, "--mcap").expect(0).says("Recording: " + file);
    assertEquals(scenarios(), recorded());
    assertArrayEquals(verdict, Files.readAllBytes(project.resolve("out/verdict.json")));
    byte[] first = Files.readAllBytes(file);
    new Program().run("simulate", project, "--scenario", SCENARIO, "--mcap").expect(0);
    assertArrayEquals(first, Files.readAllBytes(file));
    assertEquals(scenarios(), recorded());
    new Program().run("run", project).expect(0).says("unchanged");
    assertEquals(scenarios(), recorded(), "nothing was simulated");
    new Program().run("simulate", project).expect(0);
    assertEquals(List.of(), recorded(), "they were of another simulation");
  }

  private static List<String> scenarios() throws IOException {
    try (Stream<Path> files = Files.walk(project.resolve("scenarios"))) {
      return files
          .filter(Files::isRegularFile)
          .map(file -> file.getFileName().toString().replace(".yaml", ".mcap"))
          .sorted()
          .toList();
    }
  }

  @Test
  void nothingIsRecordedWithoutASimulation() {
    new Program().run("run", project, "--mcap", "--to", "generate").expect(2).says("--mcap");
    new Program().run("run", project, "--mcap", "--from", "report").expect(2).says("--mcap");
  }

  @Test
  void whatLedToAFailureIsRecorded() throws IOException {
    Path failing = Program.exampleIn(folder.resolve("failing"));
    new Program().run("run", failing, "--to", "implement").expect(0);
    Path component = failing.resolve("out/components/Braking_Decision.py");
    String text = Files.readString(component);
    Files.writeString(component, text.replaceFirst("(?m)^( +)return ", "$1raise ValueError\n$0"));
    new Program()
        .run("run", failing, "--from", "model", "--mcap", "--scenario", SCENARIO)
        .expect(1)
        .says("component.raised")
        .says("Recording: ");
    assertWhole(failing.resolve("out/mcap/" + SCENARIO + ".mcap"));
  }

  @InTurn
  @Test
  void aKilledRunLeavesNoHalfRecording() throws Exception {
    Path killed = Program.exampleIn(folder.resolve("killed"));
    new Program().run("run", killed, "--to", "generate").expect(0);
    Path unfinished = killed.resolve("out/.eventchain/new-files");
    kill(killed, unfinished);
    if (Files.exists(killed.resolve("out/mcap"))) {
      try (Stream<Path> files = Files.list(killed.resolve("out/mcap"))) {
        files.forEach(RecordedRunTest::assertWhole);
      }
    }
    new Program().run("generate", killed).expect(0);
    assertFalse(Files.exists(unfinished));
  }

  /** Kills a run during a recording. */
  private static void kill(Path project, Path unfinished) throws Exception {
    Path log = folder.resolve("killed.log");
    for (int i = 0; i < TRIES; i++) {
      Process process = new Program().start(log, log, "simulate", project, "--mcap");
      while (process.isAlive() && isEmpty(unfinished)) {
        Thread.sleep(1);
      }
      process.destroyForcibly().waitFor();
      if (!isEmpty(unfinished)) {
        return;
      }
    }
    throw new AssertionError("it never wrote: " + Files.readString(log));
  }

  private static boolean isEmpty(Path folder) {
    String[] files = folder.toFile().list();
    return files == null || files.length == 0;
  }

  private static void assertWhole(Path file) {
    try {
      byte[] bytes = Files.readAllBytes(file);
      assertArrayEquals(MAGIC, Arrays.copyOf(bytes, MAGIC.length), file.toString());
      assertArrayEquals(
          MAGIC, Arrays.copyOfRange(bytes, bytes.length - MAGIC.length, bytes.length));
      assertTrue(bytes.length > 10_000, file.toString());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
