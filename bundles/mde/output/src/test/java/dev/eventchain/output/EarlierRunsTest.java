package dev.eventchain.output;

import static dev.eventchain.output.Runs.bytes;
import static dev.eventchain.output.Runs.write;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder.Outcome;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Effects of earlier and concurrent runs on a run. */
class EarlierRunsTest {

  @TempDir Path temporary;

  @Test
  void removesItsOwnFilesThatAreNoLongerProduced() throws IOException {
    try (OutputFolder folder = OutputFolder.open(temporary)) {
      for (String name : List.of("ros2/p/a", "ros2/p/b", "ros2/old/c", "report.html")) {
        folder.write(name, bytes(name));
      }
    }
    Files.writeString(temporary.resolve("ros2/p/b"), "mine");
    Files.writeString(temporary.resolve("ros2/p/d"), "mine");
    try (OutputFolder folder = OutputFolder.open(temporary)) {
      List<Diagnostic> findings = folder.removeOthers("ros2", List.of("ros2/p/a"));
      assertEquals(1, findings.size());
      assertTrue(findings.get(0).location().file().endsWith("ros2/p/b"));
    }
    assertTrue(Files.exists(temporary.resolve("ros2/p/a")));
    assertTrue(Files.exists(temporary.resolve("ros2/p/b")));
    assertTrue(Files.exists(temporary.resolve("ros2/p/d")));
    assertTrue(Files.exists(temporary.resolve("report.html")));
    assertFalse(Files.exists(temporary.resolve("ros2/old")));
  }

  @Test
  void removesWhatTheSameProducerNoLongerProduces() throws IOException {
    produce("sources", "a", "b", "c", "d");
    produce("other", "e", "b");
    Files.writeString(temporary.resolve("c"), "mine");

    assertEquals(1, produce("sources", "a", "e").size(), "c is edited");
    assertTrue(Files.exists(temporary.resolve("c")));
    assertFalse(Files.exists(temporary.resolve("d")));
    assertFalse(Files.exists(temporary.resolve("b")), "until the other one writes it again");
    assertEquals(1, produce("sources", "a").size(), "c is still there");
    assertFalse(Files.exists(temporary.resolve("e")));

    assertEquals(List.of(), produce("other", "e", "b"));
    assertTrue(Files.exists(temporary.resolve("a")));
    assertTrue(Files.exists(temporary.resolve("b")));
    assertTrue(Files.exists(temporary.resolve("e")));
  }

  private List<Diagnostic> produce(String producer, String... names) {
    try (OutputFolder folder = OutputFolder.open(temporary)) {
      for (String name : names) {
        folder.write(name, bytes(name));
      }
      return folder.removeFormer(producer, List.of(names));
    }
  }

  @Test
  void listsOfProducersReachNothingElse() {
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("a", bytes("a"));
      assertEquals(List.of(), folder.removeFormer("x", List.of("a")));
    }
    String list =
        files.keySet().stream().filter(name -> name.contains("produced-")).findFirst().get();
    files.put(list, bytes("../x\n/y\nmine\n.eventchain/files.json\na"));
    files.put("../x", bytes(""));
    files.put("mine", bytes("mine"));
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertEquals(List.of(), folder.removeFormer("x", List.of()));
    }
    assertTrue(files.keySet().containsAll(Set.of("../x", "mine", ".eventchain/files.json")));
    assertFalse(files.containsKey("a"));
  }

  @Test
  void neverRemovesProtectedAreas() {
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("x", bytes("Start of user code a\nmine\nEnd of user code\n"));
      assertEquals(1, folder.removeOthers("", List.of()).size());
    }
    assertTrue(files.containsKey("x"));
  }

  @Test
  void keepsASecondRunOutAndNamesTheFirst() {
    try (OutputFolder first = OutputFolder.open(temporary)) {
      DiagnosticException e =
          assertThrows(DiagnosticException.class, () -> OutputFolder.open(temporary));
      assertEquals("output.locked", e.diagnostics().get(0).id());
      String pid = Long.toString(ProcessHandle.current().pid());
      assertTrue(e.diagnostics().get(0).message().contains(pid));
      assertEquals(Outcome.WRITTEN, first.write("x", bytes("x")).outcome());
    }
    assertEquals(Outcome.UNCHANGED, write(temporary, "x", "x"), "open again once the first ended");
  }

  @Test
  void keepsAnotherProcessOutAndForgivesItsSuddenDeath() throws Exception {
    write(temporary, "whole", "before");
    Process other = KilledRun.start(temporary);
    try {
      DiagnosticException e =
          assertThrows(DiagnosticException.class, () -> OutputFolder.open(temporary));
      assertEquals("output.locked", e.diagnostics().get(0).id());
      assertTrue(e.diagnostics().get(0).message().contains(Long.toString(other.pid())));
    } finally {
      other.destroyForcibly().waitFor();
    }
    assertEquals("killed", Files.readString(temporary.resolve("whole")));
    assertEquals(Outcome.WRITTEN, write(temporary, "whole", "after"), "no person edited it");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "[]", "{\"x\": 1}", "{\"x\": \"abc", "nonsense"})
  void treatsFilesAsPeoplesWhenTheRecordsAreDamaged(String damage) {
    Map<String, byte[]> files = new HashMap<>();
    files.put(".eventchain/files.json", bytes(damage));
    files.put("x", bytes("old"));
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertEquals("output.records.damaged", folder.damage().orElseThrow().id());
      assertEquals(Outcome.KEPT, folder.write("x", bytes("new")).outcome());
      assertEquals(Outcome.WRITTEN, folder.write("y", bytes("new")).outcome());
    }
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertTrue(folder.damage().isEmpty());
    }
  }

  @Test
  void recordsNeverReachOutsideTheFolder() {
    Map<String, byte[]> files = new HashMap<>();
    files.put(".eventchain/files.json", bytes("{\"../x\": \"00\"}"));
    files.put("../x", bytes(""));
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertEquals(List.of(), folder.removeOthers("", List.of()));
    }
    assertTrue(files.containsKey("../x"));
  }

  @Test
  void whatIsRememberedElsewhereStandsInForLostRecords() {
    Map<String, byte[]> files = new HashMap<>();
    String fingerprint;
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertFalse(folder.hasRecords());
      folder.write("a.txt", bytes("one"));
      folder.write("b.txt", bytes("one"));
      fingerprint = folder.written("a.txt");
    }
    files.keySet().removeIf(name -> name.startsWith(".eventchain/"));
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertFalse(folder.hasRecords());
      assertEquals("", folder.written("a.txt"));
      folder.recall("a.txt", fingerprint);
      assertEquals(Outcome.WRITTEN, folder.write("a.txt", bytes("two")).outcome());
      assertEquals(Outcome.KEPT, folder.write("b.txt", bytes("two")).outcome());
    }
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      assertTrue(folder.hasRecords());
    }
  }

  @Test
  void aResultThatNoLongerHoldsIsRemovedAlsoIfAPersonChangedIt() {
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("a.txt", bytes("one"));
      assertEquals(Optional.empty(), folder.remove("a.txt"));
      assertEquals(Optional.empty(), folder.remove("a.txt"));
      folder.write("a.txt", bytes("one"));
      files.put("a.txt", bytes("mine"));
      assertEquals("eventchain.file.edited", folder.remove("a.txt").orElseThrow().id());
      assertEquals("output.path.refused", folder.remove("../a.txt").orElseThrow().id());
    }
    assertFalse(files.containsKey("a.txt"));
  }

  @Test
  void aSingleFileThatIsNoLongerProducedIsRemoved() {
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("a.txt", bytes("one"));
      folder.write("a.txt.bak", bytes("one"));
      assertEquals(List.of(), folder.removeOthers("a.txt", List.of()));
    }
    assertFalse(files.containsKey("a.txt"));
    assertTrue(files.containsKey("a.txt.bak"));
  }
}
