package dev.eventchain.catalogue.dbc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.RequirementTools;
import dev.eventchain.fixtures.Thorough;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
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
      Files.writeString(folder.resolve("legal-%04d.dbc".formatted(i)), RandomNetwork.legal(random));
      Files.writeString(
          folder.resolve("place-%04d.dbc".formatted(i)), RandomNetwork.anyPlace(random));
      Files.writeString(
          folder.resolve("shared-%04d.dbc".formatted(i)), RandomNetwork.overlapping(random));
    }
    RequirementTools tools = RequirementTools.install(PYTHON.resolve("requirements-dbc.txt"));
    RequirementTools.Ended ended =
        tools.run(folder, "python", PYTHON.resolve("read_dbc.py").toAbsolutePath(), folder);
    assertEquals(0, ended.code(), ended.output());
    Map<String, List<String>> theirs = byFile(ended.output());
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

  private static Map<String, List<String>> byFile(String output) {
    Map<String, List<String>> files = new TreeMap<>();
    List<String> last = new ArrayList<>();
    for (String line : output.lines().toList()) {
      if (line.startsWith("file ")) {
        last = new ArrayList<>();
        files.put(line.substring(5), last);
      } else {
        last.add(line);
      }
    }
    return files;
  }

  /** Returns the network as the program writes it. */
  private static List<String> lines(String text) {
    List<Diagnostic> found = new ArrayList<>();
    DbcNetwork network = DbcFormat.network(SourceText.of("network.dbc", text), found::add);
    if (!found.isEmpty()) {
      return List.of("refused");
    }
    List<String> lines = new ArrayList<>(List.of("nodes " + String.join(" ", network.nodes())));
    for (DbcMessage message : network.messages()) {
      String senders = String.join(",", new TreeSet<>(message.senders()));
      lines.add(
          "message %s %d %s %d %s %d %s"
              .formatted(
                  message.name(),
                  message.identifier(),
                  message.isExtended() ? "extended" : "standard",
                  message.size(),
                  senders.isEmpty() ? "-" : senders,
                  network.cycle(message),
                  quoted(message.comment())));
      message.signals().values().forEach(signal -> lines.add(line(signal)));
    }
    return lines;
  }

  private static String line(DbcSignal signal) {
    DbcSignal.Layout layout = signal.layout();
    boolean floating = signal.coding() != DbcSignal.Coding.INTEGER;
    String texts =
        new TreeMap<>(signal.texts())
            .entrySet().stream()
                .map(it -> "(" + DbcValues.plain(it.getKey()) + ", " + quoted(it.getValue()) + ")")
                .collect(Collectors.joining(", ", "[", "]"));
    return String.join(
        " ",
        signal.name(),
        layout.start() + "",
        layout.length() + "",
        layout.bigEndian() ? "big" : "little",
        floating ? "float" : layout.signed() ? "signed" : "unsigned",
        number(layout.factor()),
        number(layout.offset()),
        layout.hasRange() ? number(layout.least()) : "none",
        layout.hasRange() ? number(layout.most()) : "none",
        quoted(signal.unit()),
        signal.isMultiplexer() ? "M" : "-",
        signal.multiplexed().isEmpty() ? "-" : signal.multiplexed(),
        texts,
        quoted(signal.comment()));
  }

  /** Returns the bits of a double. */
  private static String number(BigDecimal number) {
    return "%016x".formatted(Double.doubleToRawLongBits(number.doubleValue()));
  }

  private static String quoted(String text) {
    String quote = text.contains("'") ? "\"" : "'";
    return quote + text.replace("\n", "\\n") + quote;
  }
}
