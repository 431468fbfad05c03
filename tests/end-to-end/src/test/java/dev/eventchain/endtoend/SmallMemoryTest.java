package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that a command reports too little memory and passes nothing; with enough, all results
 * exist.
 */
class SmallMemoryTest {

  @TempDir Path folder;

  static Stream<Integer> sizes() {
    return Thorough.IS_ON ? Stream.of(8, 10, 12, 16) : Stream.of(8, 12);
  }

  @ParameterizedTest
  @MethodSource("sizes")
  void allOfItOrAFinding(int megabytes) throws IOException {
    Path example = Program.exampleIn(folder);
    Path report = folder.resolve("findings.json");
    Program.Ended ended =
        new Program()
            .with("JAVA_TOOL_OPTIONS", "-Xmx" + megabytes + "m")
            .run("validate", example, "--report", "json=" + report);
    if (ended.code() == 0) {
      ended.says("0 errors").says("constraints evaluated");
      assertTrue(Files.readString(report).contains("\"exitCode\" : 0"), Files.readString(report));
      return;
    }
    ended.expect(3).says("[eventchain.memory]").says("EVENTCHAIN_MEMORY");
    assertEquals("", ended.out());
    if (Files.exists(report)) {
      assertTrue(Files.readString(report).contains("\"exitCode\" : 3"), Files.readString(report));
    }
  }
}
