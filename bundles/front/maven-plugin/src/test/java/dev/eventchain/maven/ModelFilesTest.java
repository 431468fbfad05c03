package dev.eventchain.maven;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelFilesTest {

  @TempDir private Path folder;

  @Test
  void findsFilesInOrderAndLeavesOutThoseOfVersionControl() throws IOException {
    for (String name : List.of("b.xmi", "a/c.xmi", "a/notes.txt", ".git/d.xmi")) {
      Path file = folder.resolve(name);
      Files.createDirectories(file.getParent());
      Files.createFile(file);
    }
    ModelFiles files = new ModelFiles(folder.toFile(), "**/*.xmi");
    List<String> found =
        files.files().stream()
            .map(file -> folder.relativize(file.toAbsolutePath()).toString())
            .toList();
    assertEquals(List.of("a/c.xmi", "b.xmi"), found);
    assertEquals(Optional.empty(), files.nothing());
  }

  @Test
  void whatMatchesNothingIsAFinding() {
    Diagnostic finding = new ModelFiles(folder.toFile(), "*.xmi").nothing().orElseThrow();
    assertEquals("maven.nothing-to-check", finding.id());
    assertTrue(finding.message().contains("*.xmi"), finding.message());
    Path missing = folder.resolve("missing");
    Diagnostic other = new ModelFiles(missing.toFile(), "*.xmi").nothing().orElseThrow();
    assertEquals("There is no such folder of models.", other.message());
    assertTrue(new ModelFiles().nothing().orElseThrow().message().contains("directory"));
  }
}
