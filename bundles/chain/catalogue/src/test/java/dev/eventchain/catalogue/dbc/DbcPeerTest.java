package dev.eventchain.catalogue.dbc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkLines;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
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

/** Compares the reader with cantools, on the example of the cases and on random networks. */
class DbcPeerTest {

  private static final Path PYTHON = Path.of("src/test/python");
  private static final Path EXAMPLE = Path.of("src/test/resources/cases/good-dbc/network.dbc");
  private static final int COUNT = Thorough.IS_ON ? 3_000 : 150;

  @TempDir private Path folder;

  @Test
  void readsWhatCantoolsReads() throws Exception {
    Random random = new Random(Thorough.turn());
    Files.writeString(folder.resolve("example.dbc"), example());
    for (int i = 0; i < COUNT; i++) {
      Files.writeString(
          folder.resolve(String.format(Locale.ROOT, "legal-%04d.dbc", i)),
          RandomNetwork.legal(random));
      Files.writeString(
          folder.resolve(String.format(Locale.ROOT, "place-%04d.dbc", i)),
          RandomNetwork.anyPlace(random));
      Files.writeString(
          folder.resolve(String.format(Locale.ROOT, "shared-%04d.dbc", i)),
          RandomNetwork.overlapping(random));
    }
    RequirementTools tools = RequirementTools.install(PYTHON.resolve("requirements-dbc.txt"));
    RequirementTools.Ended ended =
        tools.run(folder, "python", PYTHON.resolve("read_networks.py").toAbsolutePath(), folder);
    assertEquals(0, ended.code(), ended.output());
    Map<String, List<String>> theirs = NetworkLines.byFile(ended.output());
    assertEquals(3 * COUNT + 1, theirs.size());
    int refused = 0;
    for (Map.Entry<String, List<String>> their : theirs.entrySet()) {
      String text = Files.readString(folder.resolve(their.getKey()));
      assertEquals(
          String.join("\n", their.getValue()), String.join("\n", lines(text)), their.getKey());
      refused += their.getValue().get(0).startsWith("refused") ? 1 : 0;
    }
    assertTrue(refused > COUNT / 5 && refused < 2 * COUNT, refused + " refused");
  }

  /**
   * Returns the example without what cantools reads in another way: the speed of the bus, signals
   * of no message, and multiplexers of multiplexed signals, for which it wants all ranges.
   */
  private static String example() throws Exception {
    String text = Files.readString(EXAMPLE).replaceFirst("(?m)^BS_: .*$", "BS_:");
    return text.replaceFirst("(?m)^SG_MUL_VAL_ .*\n", "")
        .replace(" m2M ", " m2 ")
        .replaceAll("(?m)^BO_ 3221225472 .*\n SG_ .*\n", "");
  }

  private static List<String> lines(String text) {
    List<Diagnostic> found = new ArrayList<>();
    Network network = DbcFormat.network(SourceText.of("network.dbc", text), found::add);
    return found.isEmpty() ? NetworkLines.of(network) : List.of("refused");
  }
}
