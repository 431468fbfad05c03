package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that texts of an editor are read instead of files, and only where that is asked for. */
class UnsavedTextsTest {

  @TempDir private Path folder;

  @Test
  void areReadInsteadOfTheirFiles() throws Exception {
    Path file = Files.writeString(folder.resolve("a.txt"), "saved");
    Map<Path, String> texts = Map.of(file, "typed");
    Path other = folder.resolve("./b/../a.txt");
    assertEquals("typed", UnsavedTexts.during(texts, () -> SourceText.read(other).text()));
    assertEquals("saved", SourceText.read(file).text());
  }

  @Test
  void areReadByThreadsThatTheWorkStarts() throws Exception {
    Path file = Files.writeString(folder.resolve("a.txt"), "saved");
    List<String> read = new ArrayList<>();
    UnsavedTexts.during(
        Map.of(file, "typed"),
        () -> {
          Thread thread = new Thread(() -> read.add(SourceText.read(file).text()));
          thread.start();
          try {
            thread.join();
          } catch (InterruptedException e) {
            throw new IllegalStateException(e);
          }
          return true;
        });
    assertEquals(List.of("typed"), read);
  }

  @Test
  void areDecodedAlready() throws Exception {
    String text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><é/>";
    Path file = folder.resolve("a.xml");
    Files.write(file, text.getBytes(StandardCharsets.ISO_8859_1));
    assertEquals(text, XmlText.read(file, "a.xml").text());
    Map<Path, String> texts = Map.of(file, text);
    assertEquals(text, UnsavedTexts.during(texts, () -> XmlText.read(file, "a.xml").text()));
  }

  @Test
  void haveTheSameProblemsAsFiles() {
    Path file = folder.resolve("a.txt");
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> UnsavedTexts.during(Map.of(file, "a\0"), () -> SourceText.read(file)));
    assertEquals("file.encoding", refused.diagnostics().get(0).id());
  }
}
