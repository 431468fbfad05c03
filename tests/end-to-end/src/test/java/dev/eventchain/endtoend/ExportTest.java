package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the command that writes scenarios for other players. */
class ExportTest {

  private static final Path CUT_IN = Program.ROOT.resolve("examples/cut-in");

  @TempDir Path folder;

  @Test
  void whatCannotBeWrittenIsReportedWithItsLine() throws IOException {
    Path target = folder.resolve("files");
    Program.Ended ended = new Program().run("export", CUT_IN, "--to", target).expect(1);
    String out = ended.out().replace("\\", "/");
    assertTrue(out.contains("scenarios/cut-in.yaml:8:"), out);
    assertTrue(out.contains("[export.condition]"), out);
    assertTrue(ended.err().contains("18 files in " + target + ": 18 written"), ended.err());
    assertTrue(Files.notExists(target.resolve("cut-in.xosc")));
  }

  @Test
  void oneScenarioIsWritten() throws IOException {
    Path target = folder.resolve("files");
    new Program().run("export", CUT_IN, "--scenario", "careful-driver", "-o", target).expect(0);
    assertTrue(Files.readString(target.resolve("careful-driver.xosc")).contains("Trajectory"));
    try (Stream<Path> files = Files.list(target)) {
      assertEquals(2, files.filter(file -> !isHidden(file)).count());
    }
  }

  private static boolean isHidden(Path file) {
    return file.getFileName().toString().startsWith(".");
  }

  @Test
  void theFolderIsNamedOnce() {
    new Program().run("export", CUT_IN).expect(2);
    Program.Ended ended =
        new Program().run("export", CUT_IN, "--to", folder, "-o", folder).expect(2);
    assertTrue(ended.err().contains("name the folder for the files once"), ended.err());
  }
}
