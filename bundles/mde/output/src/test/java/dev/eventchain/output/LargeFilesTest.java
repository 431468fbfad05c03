package dev.eventchain.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.output.OutputFolder.Outcome;
import dev.eventchain.output.OutputFolder.Written;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Large files that are written to the scratch folder and then moved. */
class LargeFilesTest {

  @TempDir Path temporary;

  private Path base;

  @BeforeEach
  void folder() {
    base = temporary.resolve("out");
  }

  private Written move(String content, String name) throws IOException {
    try (OutputFolder folder = OutputFolder.open(base)) {
      Path file = Files.writeString(folder.scratch().resolve("file"), content);
      return folder.move(file, name);
    }
  }

  private static Optional<String> id(Written written) {
    return written.finding().map(Diagnostic::id);
  }

  @Test
  void aFinishedFileIsMovedAndReplacedByTheNext() throws IOException {
    assertEquals(new Written(Outcome.WRITTEN, Optional.empty()), move("one", "a/b.bin"));
    assertEquals(new Written(Outcome.WRITTEN, Optional.empty()), move("two", "a/b.bin"));
    assertEquals("two", Files.readString(base.resolve("a/b.bin")));
  }

  @Test
  void whatAPersonPutThereIsReplacedAndThatIsSaid() throws IOException {
    Files.createDirectories(base.resolve("a"));
    Files.writeString(base.resolve("a/b.bin"), "mine");
    assertEquals(Optional.of("eventchain.file.edited"), id(move("one", "a/b.bin")));
    assertEquals("one", Files.readString(base.resolve("a/b.bin")));
  }

  @Test
  void whatAKilledRunLeftIsGoneAndNoLinkIsFollowed() throws IOException {
    Path half;
    try (OutputFolder folder = OutputFolder.open(base)) {
      half = Files.writeString(folder.scratch().resolve("half"), "half");
    }
    OutputFolder.open(base).close();
    assertFalse(Files.exists(half));
    Path elsewhere = Files.createDirectory(temporary.resolve("elsewhere"));
    Files.writeString(elsewhere.resolve("precious"), "mine");
    Files.createSymbolicLink(half.getParent(), elsewhere);
    OutputFolder.open(base).close();
    assertTrue(Files.exists(elsewhere.resolve("precious")));
  }

  @Test
  void noFileLeavesTheFolder() throws IOException {
    assertEquals(Outcome.REFUSED, move("one", "../b.bin").outcome());
    Files.createSymbolicLink(base.resolve("link"), temporary);
    assertEquals(Optional.of("output.path.refused"), id(move("one", "link/b.bin")));
    assertFalse(Files.exists(temporary.resolve("b.bin")));
  }

  @Test
  void resultsThatNoLongerHoldAreRemovedAndOnlyOurs() throws IOException {
    move("one", "a/b.bin");
    move("one", "a.bin");
    Files.writeString(base.resolve("a/mine.bin"), "mine");
    try (OutputFolder folder = OutputFolder.open(base)) {
      folder.removeAll("a");
    }
    assertFalse(Files.exists(base.resolve("a/b.bin")));
    assertTrue(Files.exists(base.resolve("a/mine.bin")));
    assertTrue(Files.exists(base.resolve("a.bin")));
  }
}
