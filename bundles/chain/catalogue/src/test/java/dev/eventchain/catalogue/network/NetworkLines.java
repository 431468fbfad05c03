package dev.eventchain.catalogue.network;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Networks in the lines of {@code read_networks.py}, which writes what cantools reads. */
public final class NetworkLines {

  private NetworkLines() {}

  /** Returns the lines that the program has written, by the files that they are about. */
  public static Map<String, List<String>> byFile(String output) {
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

  /** Returns a network as the program in Python writes it. */
  public static List<String> of(Network network) {
    List<String> lines = new ArrayList<>(List.of("nodes " + String.join(" ", network.nodes())));
    for (NetworkMessage message : network.messages()) {
      String senders = String.join(",", new TreeSet<>(message.senders()));
      lines.add(
          String.format(
              Locale.ROOT,
              "message %s %d %s %d %s %d %s",
              message.name(),
              message.identifier(),
              message.isExtended() ? "extended" : "standard",
              message.size(),
              senders.isEmpty() ? "-" : senders,
              cycle(network, message),
              quoted(message.comment())));
      message.signals().values().forEach(signal -> lines.add(line(signal)));
    }
    return lines;
  }

  private static int cycle(Network network, NetworkMessage message) {
    return message.signals().values().stream()
        .flatMapToInt(it -> it.cycle().stream())
        .min()
        .orElse(network.cycle(message));
  }

  private static String line(NetworkSignal signal) {
    NetworkSignal.Layout layout = signal.layout();
    boolean floating = signal.coding() != NetworkSignal.Coding.INTEGER;
    String texts =
        new TreeMap<>(signal.texts())
            .entrySet().stream()
                .map(
                    it ->
                        "(" + SignalValues.plain(it.getKey()) + ", " + quoted(it.getValue()) + ")")
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
        layout.least().map(NetworkLines::number).orElse("none"),
        layout.most().map(NetworkLines::number).orElse("none"),
        quoted(signal.unit()),
        signal.isMultiplexer() ? "M" : "-",
        multiplexed(signal),
        signal.initial().map(SignalValues::plain).orElse("none"),
        texts,
        quoted(signal.comment()));
  }

  /** Returns the numbers of the multiplexer with which a signal is there. */
  private static String multiplexed(NetworkSignal signal) {
    String numbers =
        signal.condition().stream()
            .flatMap(it -> it.ranges().stream())
            .map(it -> SignalValues.plain(it.from()))
            .collect(Collectors.joining(","));
    String own = signal.multiplexed().isEmpty() ? numbers : signal.multiplexed();
    return own.isEmpty() ? "-" : own;
  }

  /** Returns the bits of a double. */
  private static String number(BigDecimal number) {
    return String.format(Locale.ROOT, "%016x", Double.doubleToRawLongBits(number.doubleValue()));
  }

  private static String quoted(String text) {
    String quote = text.contains("'") ? "\"" : "'";
    return quote + text.replace("\n", "\\n") + quote;
  }
}
