package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SourceTextTest {

  @TempDir Path folder;

  @Test
  void anOffsetBecomesLineColumnAndTheWholeLine() {
    SourceText text = SourceText.of("a.ocl", "one\ntwo three\nfour");
    assertEquals(new SourceLocation("a.ocl", 2, 5, "", "two three"), text.at(8));
    assertEquals(new SourceLocation("a.ocl", 1, 4, "", "one"), text.at(3));
    assertEquals(new SourceLocation("a.ocl", 3, 5, "", "four"), text.at(18));
  }

  @Test
  void anOffsetBeyondTheTextIsItsNearestEnd() {
    SourceText text = SourceText.of("a", "x\n");
    assertEquals(new SourceLocation("a", 2, 1, "", ""), text.at(99));
    assertEquals(new SourceLocation("a", 1, 1, "", "x"), text.at(-1));
    assertEquals(new SourceLocation("empty", 1, 1, "", ""), SourceText.of("empty", "").at(0));
  }

  @Test
  void findingsOnALineShareItsText() {
    SourceText text = SourceText.of("a", "one\n" + "x".repeat(10_000) + "\nthree");
    assertSame(text.at(10).excerpt(), text.at(2, 5_000).excerpt());
    assertEquals("three", text.at(3, 1).excerpt());
    assertEquals("one", text.at(0).excerpt());
  }

  @Test
  void carriageReturnsAreNotPartOfTheLine() {
    assertEquals("one", SourceText.of("a", "one\r\ntwo\r\n").at(0).excerpt());
  }

  @Test
  void aByteOrderMarkIsSkipped() throws IOException {
    Path file = folder.resolve("bom.ocl");
    Files.write(file, new byte[] {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF, 'a'});
    assertEquals("a", SourceText.read(file).text());
  }

  @Test
  void aMissingFileAFolderAndAWrongEncodingAreFindings() throws IOException {
    Path latin = folder.resolve("latin.txt");
    Files.write(latin, "gut\nschön\n".getBytes(StandardCharsets.ISO_8859_1));
    assertEquals("file.missing", idOf(folder.resolve("none")));
    assertEquals("file.unreadable", idOf(folder));
    assertEquals("file.unreadable", idOf(Path.of("/dev/zero")));
    assertEquals("file.encoding", idOf(latin));
    DiagnosticException e = assertThrows(DiagnosticException.class, () -> SourceText.read(latin));
    assertEquals(2, e.diagnostics().get(0).location().line());
  }

  @Test
  void whatUtf16WritesBetweenLettersIsNoText() throws IOException {
    Path wide = folder.resolve("wide.md");
    Files.write(wide, "\n- A".getBytes(StandardCharsets.UTF_16LE));
    assertEquals("file.encoding", idOf(wide));
    DiagnosticException e = assertThrows(DiagnosticException.class, () -> SourceText.read(wide));
    assertEquals(2, e.diagnostics().get(0).location().line());
  }

  @Test
  void aFileHasOneNameHoweverTheWayToItIsWritten() {
    assertEquals("x/y", SourceLocation.of(Path.of("./x/../x/y")).file());
    assertEquals(".", SourceLocation.of(Path.of("./")).file());
    assertEquals("../y", SourceLocation.of(Path.of("../y")).file());
  }

  private static String idOf(Path file) {
    DiagnosticException e = assertThrows(DiagnosticException.class, () -> SourceText.read(file));
    assertEquals(DiagnosticException.Reason.INPUT, e.reason());
    return e.diagnostics().get(0).id();
  }
}
