package dev.eventchain.output;

import static dev.eventchain.output.Runs.bytes;
import static dev.eventchain.output.Runs.write;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.output.OutputFolder.Outcome;
import dev.eventchain.output.OutputFolder.Written;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Outcomes of writing files, by path and origin of the existing file. */
class OutputFolderTest {

  @TempDir Path temporary;

  @Test
  void createsTheFolderAndTheFile() throws IOException {
    Path base = temporary.resolve("a/b");
    assertEquals(Outcome.WRITTEN, write(base, "x/y.txt", "hello"));
    assertEquals("hello", Files.readString(base.resolve("x/y.txt")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "/etc/x",
        "../x",
        "a/../../x",
        "a/..",
        "a\\b",
        "C:x",
        "c:/x",
        "a\nb",
        "a\0b",
        "folder/",
        ".",
        ".eventchain/files.json",
        "./.Eventchain/lock"
      })
  void refusesNamesThatLeaveTheFolderOrCannotBeFiles(String name) throws IOException {
    Path base = temporary.resolve("out");
    try (OutputFolder folder = OutputFolder.open(base)) {
      OutputFolder.Written written = folder.write(name, bytes("bad"));
      assertEquals(Outcome.REFUSED, written.outcome());
      assertEquals("output.path.refused", written.finding().orElseThrow().id());
      assertEquals(base.toString(), written.finding().orElseThrow().location().file());
      assertTrue(folder.read(name).isEmpty());
    }
    try (Stream<Path> all = Files.walk(temporary)) {
      assertEquals(
          List.of("files.json", "lock"),
          all.filter(Files::isRegularFile).map(f -> f.getFileName().toString()).sorted().toList());
    }
  }

  @Test
  void refusesNamesLongerThanFileSystemsTake() {
    try (OutputFolder folder = OutputFolder.open(temporary)) {
      assertEquals(Outcome.REFUSED, folder.write("x".repeat(256), bytes("")).outcome());
      assertEquals(Outcome.REFUSED, folder.write("abc/".repeat(1024) + "x", bytes("")).outcome());
      assertEquals(Outcome.WRITTEN, folder.write("x".repeat(255), bytes("")).outcome());
    }
  }

  @Test
  void dropsHarmlessDetoursInNames() {
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("./a//b.txt", bytes("x"));
    }
    assertTrue(files.containsKey("a/b.txt"));
  }

  @Test
  void doesNotFollowLinksThatLeaveTheFolder() throws IOException {
    Path outside = Files.createDirectory(temporary.resolve("outside"));
    Files.writeString(outside.resolve("secret"), "secret");
    Path base = Files.createDirectory(temporary.resolve("out"));
    Files.createSymbolicLink(base.resolve("link"), outside);
    Files.createSymbolicLink(base.resolve("file"), outside.resolve("secret"));
    Files.createSymbolicLink(base.resolve("dangling"), temporary.resolve("nowhere"));
    try (OutputFolder folder = OutputFolder.open(base)) {
      assertEquals(Outcome.REFUSED, folder.write("link/x", bytes("x")).outcome());
      assertEquals(Outcome.REFUSED, folder.write("file", bytes("x")).outcome());
      assertEquals(Outcome.REFUSED, folder.write("dangling", bytes("x")).outcome());
      assertTrue(folder.read("file").isEmpty());
    }
    assertEquals("secret", Files.readString(outside.resolve("secret")));
    assertFalse(Files.exists(outside.resolve("x")));
    assertFalse(Files.exists(temporary.resolve("nowhere")));
  }

  @Test
  void refusesAFolderWhoseRecordsAreALinkToElsewhere() throws IOException {
    Path outside = Files.createDirectory(temporary.resolve("outside"));
    Path base = Files.createDirectory(temporary.resolve("out"));
    Files.createSymbolicLink(base.resolve(".eventchain"), outside);
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> OutputFolder.open(base).close());
    assertEquals("output.unwritable", e.diagnostics().get(0).id());
    try (Stream<Path> entries = Files.list(outside)) {
      assertEquals(0, entries.count());
    }
  }

  @Test
  void leavesUnchangedFilesUntouched() throws IOException {
    write(temporary, "x", "same");
    FileTime old = FileTime.from(1_000_000_000, TimeUnit.SECONDS);
    Files.setLastModifiedTime(temporary.resolve("x"), old);
    Files.setLastModifiedTime(temporary.resolve(".eventchain/files.json"), old);
    assertEquals(Outcome.UNCHANGED, write(temporary, "x", "same"));
    assertEquals(old, Files.getLastModifiedTime(temporary.resolve("x")));
    assertEquals(old, Files.getLastModifiedTime(temporary.resolve(".eventchain/files.json")));
  }

  @Test
  void replacesItsOwnFiles() throws IOException {
    write(temporary, "x", "one");
    assertEquals(Outcome.WRITTEN, write(temporary, "x", "two"));
    assertEquals("two", Files.readString(temporary.resolve("x")));
  }

  @Test
  void keepsAFileThatAPersonEditedAndSaysSo() throws IOException {
    write(temporary, "x", "one");
    Files.writeString(temporary.resolve("x"), "mine");
    try (OutputFolder folder = OutputFolder.open(temporary)) {
      assertTrue(folder.isEdited("x"));
      OutputFolder.Written written = folder.write("x", bytes("two"));
      assertEquals(Outcome.KEPT, written.outcome());
      assertEquals("eventchain.file.edited", written.finding().orElseThrow().id());
      assertEquals("mine", Files.readString(temporary.resolve("x")));
    }
    assertEquals(Outcome.KEPT, write(temporary, "x", "three"), "still a person's the next time");
  }

  @Test
  void keepsAFileThatAPersonPutThere() throws IOException {
    Files.writeString(temporary.resolve("x"), "mine");
    try (OutputFolder folder = OutputFolder.open(temporary)) {
      OutputFolder.Written written = folder.write("x", bytes("ours"));
      assertEquals(Outcome.KEPT, written.outcome());
      Diagnostic finding = written.finding().orElseThrow();
      assertTrue(finding.message().contains("not recorded as written"), finding.message());
      // Deleting the file would lose the content of its protected areas.
      assertTrue(finding.hint().contains("--overwrite"), finding.hint());
    }
  }

  @Test
  void overwritesAnEditedFileWhenToldAndSaysSo() {
    Map<String, byte[]> files = new HashMap<>(Map.of("x", bytes("mine")));
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      OutputFolder.Written written = folder.write("x", bytes("ours"), OnEdit.OVERWRITE);
      assertEquals(Outcome.WRITTEN, written.outcome());
      assertEquals("eventchain.file.edited", written.finding().orElseThrow().id());
    }
    assertArrayEquals(bytes("ours"), files.get("x"));
  }

  @Test
  void acceptsAnEditWithAWarningAndGoesOnTreatingItAsAnEdit() {
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("x", bytes("ours"));
      assertTrue(folder.accept("x").isEmpty());
      assertTrue(folder.accept("missing").isEmpty());
      files.put("x", bytes("mine"));
      assertEquals("eventchain.file.edited", folder.accept("x").orElseThrow().id());
      assertEquals(Outcome.KEPT, folder.write("x", bytes("newer")).outcome());
    }
  }

  @Test
  void changesInsideProtectedAreasAreNoEdits() {
    String generated = "a\n# Start of user code id\n# here\n# End of user code\nb\n";
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("x", bytes(generated));
      files.put("x", bytes(generated.replace("# here", "my\ncode")));
      assertFalse(folder.isEdited("x"));
      files.put("x", bytes(generated.replace("b\n", "B\n")));
      assertTrue(folder.isEdited("x"));
      files.put("x", bytes(generated.replace("code id\n", "code id \t\n")));
      assertFalse(folder.isEdited("x"), "an editor left blanks");
    }
  }

  @Test
  void anAreaOnOneLineIsNoneThatKeepsChanges() {
    String generated = "Start of user code id x End of user code\nb\nEnd of user code\n";
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("x", bytes(generated));
      files.put("x", bytes(generated.replace(" x ", " y ")));
      assertTrue(folder.isEdited("x"));
      files.put("x", bytes(generated.replace("b\n", "B\n")));
      assertTrue(folder.isEdited("x"));
    }
  }

  @Test
  void addsLostAreasToThoseThatAPersonTidied() {
    String lost = "Start of user code a\nmine\nEnd of user code\n";
    Map<String, byte[]> files = new HashMap<>();
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      folder.write("x.lost", bytes(lost + lost.replace("a\n", "b\n")));
      files.put("x.lost", bytes(lost));
      byte[] more = bytes(lost + lost.replace("a\n", "c\n"));
      assertEquals(new Written(Outcome.WRITTEN, Optional.empty()), folder.write("x.lost", more));
      files.put("x.lost", bytes("mine"));
      assertEquals(Outcome.KEPT, folder.write("x.lost", more).outcome());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"/proc/eventchain-output", "/dev/null/out"})
  void saysThatAFolderCannotBeWritten(String folder) {
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> OutputFolder.open(Path.of(folder)).close());
    assertEquals(DiagnosticException.Reason.INPUT, e.reason());
    assertEquals("output.unwritable", e.diagnostics().get(0).id());
    assertEquals(folder, e.diagnostics().get(0).location().file());
  }

  @Test
  void saysThatAFolderStandsWhereAFileShould() throws IOException {
    Files.createDirectories(temporary.resolve("x"));
    DiagnosticException e =
        assertThrows(DiagnosticException.class, () -> write(temporary, "x", "text"));
    assertEquals("output.unwritable", e.diagnostics().get(0).id());
  }
}
