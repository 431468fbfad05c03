package dev.eventchain.catalogue.arxml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkLines;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.fixtures.RequirementTools;
import dev.eventchain.fixtures.Thorough;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compares the reader with cantools, on random descriptions. */
class ArxmlPeerTest {

  private static final Path PYTHON = Path.of("src/test/python");
  private static final int COUNT = Thorough.IS_ON ? 1_000 : 60;

  @TempDir private Path folder;

  @Test
  void readsWhatCantoolsReads() throws Exception {
    Random random = new Random(Thorough.turn());
    for (int i = 0; i < COUNT; i++) {
      write("legal", i, RandomDescription.legal(random));
      write("place", i, RandomDescription.anyPlace(random));
      write("multiplexed", i, RandomDescription.multiplexed(random));
    }
    RequirementTools tools = RequirementTools.install(PYTHON.resolve("requirements-dbc.txt"));
    RequirementTools.Ended ended =
        tools.run(folder, "python", PYTHON.resolve("read_networks.py").toAbsolutePath(), folder);
    assertEquals(0, ended.code(), ended.output());
    Map<String, List<String>> theirs = NetworkLines.byFile(ended.output());
    assertEquals(3 * COUNT, theirs.size());
    int refused = 0;
    for (Map.Entry<String, List<String>> their : theirs.entrySet()) {
      List<String> ours = lines(folder.resolve(their.getKey()));
      assertEquals(sorted(their.getValue()), sorted(ours), their.getKey());
      refused += their.getValue().get(0).equals("refused") ? 1 : 0;
    }
    assertTrue(refused > COUNT / 5 && refused < COUNT, refused + " refused");
  }

  private void write(String kind, int number, String text) throws Exception {
    Files.writeString(
        folder.resolve(String.format(Locale.ROOT, "%s-%04d.arxml", kind, number)), text);
  }

  /** The order of signals of multiplexed messages is another one. */
  private static String sorted(List<String> lines) {
    return String.join("\n", lines.stream().sorted().toList());
  }

  private static List<String> lines(Path file) {
    List<Diagnostic> found = new ArrayList<>();
    Network network = ArxmlFormat.network(List.of(file), found::add);
    boolean refused =
        found.stream()
            .anyMatch(it -> it.severity() == Severity.ERROR || it.id().equals("catalogue.overlap"));
    return refused ? List.of("refused") : NetworkLines.of(network);
  }
}
