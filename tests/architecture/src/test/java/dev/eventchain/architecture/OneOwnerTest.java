package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
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
          "\"worst_case_execution_time\"",
          "\"worst_case_transport_time\"");

  @Test
  void namesOfChainDescriptionsAreInTheirTable() throws IOException {
    Map<String, List<String>> owners = new TreeMap<>();
    try (Stream<Path> files = Files.walk(BUNDLES)) {
      files
          .filter(file -> file.toString().matches(".*/src/main/java/.*\\.java"))
          .forEach(file -> addTo(owners, file));
    }
    Map<String, List<String>> expected = new TreeMap<>();
    OF_CHAINS.forEach(name -> expected.put(name, List.of("ChainNames.java")));
    assertEquals(expected, owners);
  }

  private static void addTo(Map<String, List<String>> owners, Path file) {
    String text = text(file);
    for (String name : OF_CHAINS) {
      if (text.contains(name)) {
        owners
            .computeIfAbsent(name, key -> new ArrayList<>())
            .add(String.valueOf(file.getFileName()));
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
