package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WorkFolderTest {

  private static final String HOLD_LOCK =
      "import fcntl, sys; file = open(sys.argv[1], 'w'); fcntl.lockf(file, fcntl.LOCK_EX);"
          + "print('held', flush=True); sys.stdin.read()";

  /** Program that sweeps repeatedly, as another of our processes would. */
  private static final String SWEEP =
      """
      import fcntl, os, shutil, sys
      print('sweeps', flush=True)
      while True:
          for folder in os.listdir(sys.argv[1]):
              try:
                  with open(os.path.join(sys.argv[1], folder, 'lock'), 'r+') as lock:
                      fcntl.lockf(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                      shutil.rmtree(os.path.join(sys.argv[1], folder), ignore_errors=True)
              except OSError:
                  pass
      """;

  @TempDir Path place;

  @Test
  void isForItsOwnerOnlyAndGoesWithAllThatIsInIt() throws IOException {
    Path precious = Files.writeString(place.resolve("precious"), "x");
    WorkFolder folder = WorkFolder.create(place);
    Path work = folder.path();
    Path whole = work.getParent();
    assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(whole)));
    Path locked = Files.createDirectories(work.resolve("a/b"));
    Files.writeString(locked.resolve("-rf *\n\u00fc"), "x");
    Files.createSymbolicLink(locked.resolve("link"), place);
    Files.createSymbolicLink(work.resolve("file"), precious);
    Files.setPosixFilePermissions(locked, Set.of());
    Files.setPosixFilePermissions(work, PosixFilePermissions.fromString("r-x------"));
    folder.close();
    assertEquals(List.of(precious), entries());
  }

  @Test
  void leftByAKilledProcessIsSweptByTheNext() throws Exception {
    Path left = abandoned();
    Process holder = python(HOLD_LOCK, left.resolve("lock"), "held");
    AbandonedFolders.sweep(place);
    assertTrue(Files.exists(left.resolve("work/file")), "the folder of a living process went");
    holder.destroyForcibly().waitFor();
    AbandonedFolders.sweep(place);
    assertEquals(List.of(), entries());
  }

  @Test
  void folderThatIsBeingMadeIsNeverSweptByAnotherProcess() throws Exception {
    Process sweeper = python(SWEEP, place, "sweeps");
    try {
      for (int i = 0; i < 1000; i++) {
        try (WorkFolder folder = WorkFolder.create(place)) {
          assertTrue(Files.isDirectory(folder.path()));
        }
      }
      assertTrue(sweeper.isAlive());
    } finally {
      sweeper.destroyForcibly().waitFor();
    }
  }

  @Test
  void ownFoldersAndThoseBeingMadeStay() throws IOException {
    Path making = Files.createDirectory(place.resolve(AbandonedFolders.PREFIX + "1"));
    Path other = Files.createDirectory(place.resolve("eventchain-work"));
    try (WorkFolder folder = WorkFolder.create(place)) {
      AbandonedFolders.sweep(place);
      assertTrue(Files.isDirectory(folder.path()));
      assertTrue(Files.isDirectory(making));
    }
    Files.setLastModifiedTime(making, FileTime.from(Instant.now().minusSeconds(3600)));
    AbandonedFolders.sweep(place);
    assertEquals(List.of(other), entries());
  }

  @Test
  void linkInPlaceOfAFolderIsNotFollowed() throws IOException {
    Path elsewhere = Files.createDirectory(place.resolve("elsewhere"));
    Files.createFile(elsewhere.resolve("lock"));
    Files.createSymbolicLink(place.resolve(AbandonedFolders.PREFIX + "2"), elsewhere);
    AbandonedFolders.sweep(place);
    assertTrue(Files.exists(elsewhere.resolve("lock")));
  }

  @Test
  void firstFolderOfAProcessSweeps() throws IOException {
    abandoned();
    WorkFolder.create(place).close();
    assertEquals(List.of(), entries());
  }

  @Test
  void missingPlaceIsNamed() {
    Diagnostic finding = failure(place.resolve("missing"));
    assertEquals("The temporary folder cannot be used: it does not exist.", finding.message());
    assertTrue(finding.location().file().endsWith("/missing"), finding.location().file());
    assertTrue(finding.hint().contains("TMPDIR="), finding.hint());
  }

  @Test
  void placeThatMayNotBeWrittenIsNamed() throws IOException {
    Path closed = Files.createDirectory(place.resolve("closed"));
    Files.setPosixFilePermissions(closed, PosixFilePermissions.fromString("r-x------"));
    assumeTrue(!Files.isWritable(closed), "this user may write everything");
    assertEquals(
        "The temporary folder cannot be used: this user may not write to it.",
        failure(closed).message());
  }

  @Test
  void fullPlaceIsNamed() throws Exception {
    Path full = Files.createDirectory(place.resolve("full"));
    boolean mounted =
        run("mount", "-t", "tmpfs", "-o", "size=4k,nr_inodes=1", "none", full.toString());
    assumeTrue(mounted, "this user may not mount");
    try {
      String message = failure(full).message();
      assertEquals("The temporary folder cannot be used: No space left on device.", message);
    } finally {
      run("umount", full.toString());
    }
  }

  @Test
  void placeIsThatOfTheEnvironment() {
    assertEquals(Path.of("/other"), WorkFolder.place(Map.of("TMPDIR", "/other")));
    Path usual = Path.of(System.getProperty("java.io.tmpdir")).toAbsolutePath();
    assertEquals(usual, WorkFolder.place(Map.of()));
    assertEquals(usual, WorkFolder.place(Map.of("TMPDIR", "")));
  }

  private static Diagnostic failure(Path place) {
    var failure = assertThrows(DiagnosticException.class, () -> WorkFolder.create(place));
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, failure.reason());
    Diagnostic finding = failure.diagnostics().get(0);
    assertEquals("temporary.unwritable", finding.id());
    assertFalse(finding.message().contains("Exception"), finding.message());
    return finding;
  }

  private static Process python(String program, Path argument, String first) throws IOException {
    Process process =
        new ProcessBuilder(
                TestEnvironment.PYTHON.executable().toString(), "-c", program, argument.toString())
            .redirectErrorStream(true)
            .start();
    assertEquals(first, process.inputReader(StandardCharsets.UTF_8).readLine());
    return process;
  }

  private Path abandoned() throws IOException {
    Path left = Files.createDirectory(place.resolve(AbandonedFolders.PREFIX + "3"));
    Files.createFile(left.resolve("lock"));
    Files.writeString(Files.createDirectory(left.resolve("work")).resolve("file"), "x");
    return left;
  }

  private List<Path> entries() throws IOException {
    try (Stream<Path> files = Files.list(place)) {
      return files.toList();
    }
  }

  private static boolean run(String... command) throws IOException, InterruptedException {
    try {
      return new ProcessBuilder(command).redirectErrorStream(true).start().waitFor() == 0;
    } catch (IOException e) {
      return false;
    }
  }
}
