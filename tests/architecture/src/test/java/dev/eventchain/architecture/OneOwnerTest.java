package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests that what several bundles have to know is written in one of them. */
class OneOwnerTest {

  private static final Path BUNDLES = Path.of("..", "..", "bundles");

  /** Names of {@code chain.json} that mean nothing else, and so can be found in sources. */
  private static final List<String> OF_CHAINS =
      List.of(
          "\"best_case_execution_time\"",
          "\"lease_duration\"",
          "\"maximum_age\"",
          "\"message_type\"",
          "\"safe_value\"",
          "\"worst_case_execution_time\"");

  @Test
  void namesOfChainDescriptionsAreInTheirTable() throws IOException {
    for (String name : OF_CHAINS) {
      try (Stream<Path> files = Files.walk(BUNDLES)) {
        List<String> owners =
            files
                .filter(file -> file.toString().matches(".*/src/main/java/.*\\.java"))
                .filter(file -> text(file).contains(name))
                .map(file -> String.valueOf(file.getFileName()))
                .toList();
        assertEquals(List.of("ChainNames.java"), owners, name);
      }
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
