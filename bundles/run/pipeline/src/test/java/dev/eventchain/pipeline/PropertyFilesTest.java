package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PropertyFilesTest {

  @TempDir Path folder;

  private Path file(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private static Diagnostic refused(Path... files) {
    return assertThrows(DiagnosticException.class, () -> PropertyFiles.read(List.of(files)))
        .diagnostics()
        .get(0);
  }

  @Test
  void propertiesStandByTheNamesOfTheirFilesInOrder() throws IOException {
    Path second = file("b/second.properties", "key = 2\n");
    Path first = file("a/first.properties", "# comment\nkey: \\u00e4\nother=\n");
    Map<String, Map<String, String>> read = PropertyFiles.read(List.of(second, first));
    assertEquals(List.of("second.properties", "first.properties"), List.copyOf(read.keySet()));
    assertEquals(Map.of("key", "2"), read.get("second.properties"));
    assertEquals(Map.of("key", "\u00e4", "other", ""), read.get("first.properties"));
  }

  @Test
  void filesThatCannotBeReadAreRefused() throws IOException {
    Path missing = folder.resolve("missing.properties");
    assertEquals("file.missing", refused(missing).id());
    Diagnostic broken = refused(file("broken.properties", "key=\\u00zz\n"));
    assertEquals("file.unreadable", broken.id());
    assertEquals("file.unreadable", refused(Files.createDirectories(folder.resolve("d"))).id());
  }

  @Test
  void filesOfOneNameAreRefused() throws IOException {
    Path second = file("b/same.properties", "");
    Diagnostic twice = refused(file("a/same.properties", ""), second);
    assertEquals("properties.duplicate", twice.id());
    assertEquals(second.toString(), twice.location().file());
  }
}
