package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.FileReads.Recorded;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which files count as read by a piece of work. */
class FileReadsTest {

  @TempDir Path folder;
  private Path one;
  private Path two;

  @BeforeEach
  void writeFiles() throws Exception {
    one = Files.writeString(folder.resolve("one.txt"), "1");
    two = Files.writeString(folder.resolve("two.txt"), "2");
  }

  private static String text(Path file) {
    return SourceText.read(file).text();
  }

  @Test
  void filesAreRecordedWhereTheyAreRead() {
    Recorded<String> read =
        FileReads.record(() -> text(folder.resolve("./one.txt")) + text(one) + text(two));
    assertEquals("112", read.value());
    assertEquals(Set.of(one, two), read.files());
  }

  @Test
  void aMissingFileCountsAsRead() {
    Path missing = folder.resolve("missing.txt");
    Recorded<?> read =
        FileReads.record(() -> assertThrows(DiagnosticException.class, () -> text(missing)));
    assertEquals(Set.of(missing), read.files());
  }

  @Test
  void innerWorkBelongsToTheOuterOne() {
    Recorded<Recorded<String>> outer =
        FileReads.record(
            () -> {
              text(one);
              return FileReads.record(() -> text(two));
            });
    assertEquals(Set.of(two), outer.value().files());
    assertEquals(Set.of(one, two), outer.files());
  }

  @Test
  void unrecordedWorkDoesNot() {
    assertEquals(
        Set.of(one),
        FileReads.record(() -> FileReads.unrecorded(() -> text(two)) + text(one)).files());
  }

  @Test
  void startedThreadsBelongToTheWork() {
    Recorded<Thread> read =
        FileReads.record(
            () -> {
              Thread thread = new Thread(() -> text(one));
              thread.start();
              assertEquals(true, joined(thread));
              return thread;
            });
    assertEquals(Set.of(one), read.files());
  }

  private static boolean joined(Thread thread) {
    try {
      thread.join();
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  @Test
  void nothingIsRecordedAfterwards() {
    Recorded<String> read = FileReads.record(() -> "");
    text(one);
    assertEquals(Set.of(), read.files());
  }

  @Test
  void workThatFailsEndsItsRecord() {
    Recorded<String> outer =
        FileReads.record(
            () -> {
              assertThrows(
                  IllegalStateException.class,
                  () ->
                      FileReads.record(
                          () -> {
                            throw new IllegalStateException("failed");
                          }));
              return text(two);
            });
    assertEquals(Set.of(two), outer.files());
  }

  @Test
  void everythingIsRecordedForWhoDoesTheWholeWorkAgain() {
    Recorded<String> read =
        FileReads.recordAll(
            () ->
                FileReads.unrecorded(() -> text(one)) + FileReads.record(() -> text(two)).value());
    assertEquals(Set.of(one, two), read.files());
    Recorded<Boolean> failed =
        FileReads.recordAll(
            () -> {
              Path missing = folder.resolve("missing.txt");
              assertThrows(DiagnosticException.class, () -> FileReads.record(() -> text(missing)));
              return true;
            });
    assertEquals(Set.of(folder.resolve("missing.txt")), failed.files());
  }
}
