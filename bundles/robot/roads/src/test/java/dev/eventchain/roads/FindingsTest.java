package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class FindingsTest {

  private static final Path FOLDER = Path.of("src/test/resources/bad");

  static Stream<Path> files() throws IOException {
    return ExpectedFile.inputs(FOLDER, ".xodr").stream();
  }

  /** The first rule of the findings is the file's name, or a prefix of it. */
  @ParameterizedTest
  @MethodSource("files")
  void findingsAreAsExpected(Path file) throws IOException {
    List<Diagnostic> found = findings(file);
    ExpectedFile.check(ExpectedFile.beside(file), DiagnosticFormat.TEXT.render(found));
    String name = String.valueOf(file.getFileName());
    assertTrue(found.stream().anyMatch(each -> name.startsWith(each.id())), found.toString());
    assertTrue(found.stream().noneMatch(each -> each.hint().isEmpty()), found.toString());
  }

  private static List<Diagnostic> findings(Path file) {
    try {
      return RoadNetwork.read(file).findings();
    } catch (DiagnosticException e) {
      assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      return e.diagnostics();
    }
  }

  @Test
  void readingEndsAfterAHundredErrors() {
    String text = "<OpenDRIVE>" + "<controller/>".repeat(1000) + "</OpenDRIVE>";
    DiagnosticException failure =
        assertThrows(
            DiagnosticException.class, () -> RoadNetwork.parse(SourceText.of("x.xodr", text)));
    assertEquals(100, failure.diagnostics().size());
  }

  @Test
  void hugeFilesAreRefusedUnread(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("huge.xodr");
    try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
      sparse.setLength((100L << 20) + 1);
    }
    assertEquals(List.of("road.size"), findings(file).stream().map(Diagnostic::id).toList());
  }

  @Test
  void missingFilesAndFoldersAreSaidToBe(@TempDir Path folder) {
    assertEquals("file.missing", findings(folder.resolve("none.xodr")).get(0).id());
    assertEquals("file.unreadable", findings(folder).get(0).id());
  }
}
