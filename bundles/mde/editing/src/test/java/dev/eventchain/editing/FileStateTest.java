package dev.eventchain.editing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileStateTest {

  @TempDir Path folder;

  @Test
  void versionsOfAFileDiffer() throws IOException {
    Path file = Files.writeString(folder.resolve("a"), "one");
    Files.setLastModifiedTime(file, FileTime.from(Instant.ofEpochSecond(1)));
    FileState first = FileState.of(file);
    assertTrue(first.isFile());
    assertEquals(first, FileState.of(file));
    Files.setLastModifiedTime(file, FileTime.from(Instant.ofEpochSecond(2)));
    FileState touched = FileState.of(file);
    assertNotEquals(first, touched);
    Files.writeString(file, "three");
    Files.setLastModifiedTime(file, FileTime.from(Instant.ofEpochSecond(2)));
    assertNotEquals(touched, FileState.of(file));
    Files.delete(file);
    assertEquals(FileState.MISSING, FileState.of(file));
  }

  @Test
  void aFolderIsNoFile() {
    assertFalse(FileState.of(folder).isFile());
    assertNotEquals(FileState.MISSING, FileState.of(folder));
  }
}
