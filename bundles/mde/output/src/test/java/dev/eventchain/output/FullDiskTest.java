package dev.eventchain.output;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder.Outcome;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Runs on a disk that fills up. The disk is a file system of 256 kB in memory, in a process with
 * its own mount namespace. The test is skipped, with a message, if the kernel forbids that.
 */
class FullDiskTest {

  private static final String FINISHED = "finished";

  @TempDir Path temporary;

  @Test
  void isToldAndLeavesEarlierFilesWholeAndTheFolderUsable() throws Exception {
    assumeTrue(Files.isExecutable(Path.of("/usr/bin/unshare")), "there is no unshare");
    Process process =
        new ProcessBuilder(
                "unshare",
                "-rm",
                "sh",
                "-c",
                "mount -t tmpfs -o size=256k none \"$1\" || exit 77; shift; exec \"$@\"",
                "sh",
                temporary.toString(),
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:-UsePerfData",
                "-ea",
                "-cp",
                System.getProperty("java.class.path"),
                FullDiskTest.class.getName(),
                temporary.toString())
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes(), UTF_8);
    process.waitFor();
    assumeTrue(!said.startsWith("unshare:"), "the kernel gives no mounts of its own: " + said);
    assumeTrue(process.exitValue() != 77, "no file system could be mounted: " + said);
    assertEquals(FINISHED, said.strip());
  }

  /** Runs the part on the small disk. It prints a message at the end, or fails with the reason. */
  public static void main(String[] arguments) throws IOException {
    Path base = Path.of(arguments[0]).resolve("out");
    byte[] small = "small".getBytes(UTF_8);
    byte[] half = new byte[100_000];
    try (OutputFolder folder = OutputFolder.open(base)) {
      assertEquals(Outcome.WRITTEN, folder.write("a", small).outcome());
      assertEquals(Outcome.WRITTEN, folder.write("b", half).outcome());
    }
    String id = "";
    try (OutputFolder folder = OutputFolder.open(base)) {
      folder.write("a", new byte[200_000]);
    } catch (DiagnosticException e) {
      id = e.diagnostics().get(0).id();
    }
    assertEquals("output.unwritable", id);
    assertEquals("small", Files.readString(base.resolve("a")));
    assertEquals(half.length, Files.size(base.resolve("b")));
    try (OutputFolder folder = OutputFolder.open(base)) {
      assertEquals(List.of(), folder.removeOthers("", List.of("a")));
      assertEquals(Outcome.WRITTEN, folder.write("a", new byte[200_000]).outcome());
    }
    System.out.println(FINISHED);
  }
}
