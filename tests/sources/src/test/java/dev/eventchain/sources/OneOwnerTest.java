package dev.eventchain.sources;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Tests that what several bundles have to know is written in one of them. */
class OneOwnerTest {

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
    for (Path file : SourceFiles.ofBundles(".java")) {
      addTo(owners, file);
    }
    Map<String, List<String>> expected = new TreeMap<>();
    OF_CHAINS.forEach(name -> expected.put(name, List.of("ChainNames.java")));
    assertEquals(expected, owners);
  }

  private static void addTo(Map<String, List<String>> owners, Path file) throws IOException {
    String text = Files.readString(file);
    for (String name : OF_CHAINS) {
      if (text.contains(name)) {
        owners
            .computeIfAbsent(name, key -> new ArrayList<>())
            .add(String.valueOf(file.getFileName()));
      }
    }
  }
}
