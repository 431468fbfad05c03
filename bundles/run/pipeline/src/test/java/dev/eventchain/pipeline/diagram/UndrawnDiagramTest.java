package dev.eventchain.pipeline.diagram;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.diagram.Diagrams.Kind;
import dev.eventchain.pipeline.files.WrittenFiles;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** A model for whose instance diagram PlantUML fails to find a layout. */
@Isolated("it replaces the error stream of all tests")
class UndrawnDiagramTest {

  private static final Path FILES =
      Path.of("src/test/resources/dev/eventchain/pipeline/diagram/undrawn");

  @TempDir private Path folder;

  private WrittenFiles draw() {
    return Diagrams.draw(
        EnumSet.of(Kind.INSTANCE),
        ModelFiles.of(List.of(FILES.resolve("m.xmi")), List.of(FILES.resolve("plan.ecore"))),
        folder.resolve("out"),
        OnEdit.KEEP);
  }

  @Test
  void itsTextIsWrittenAndNothingIsPrinted() {
    PrintStream before = System.err;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
    WrittenFiles written;
    try {
      written = draw();
    } finally {
      System.setErr(before);
    }
    assertEquals(
        List.of("diagram.undrawn"), written.diagnostics().stream().map(Diagnostic::id).toList());
    assertTrue(Files.exists(folder.resolve("out/instance.puml")));
    assertFalse(Files.exists(folder.resolve("out/instance.svg")));
    assertEquals("", printed.toString(StandardCharsets.UTF_8));
  }
}
