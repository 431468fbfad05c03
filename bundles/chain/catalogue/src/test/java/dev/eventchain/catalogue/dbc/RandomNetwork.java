package dev.eventchain.catalogue.dbc;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.StringJoiner;

/** The text of a random network, of which each part may be missing. */
final class RandomNetwork {

  private static final List<String> FACTORS =
      List.of("1", "0.1", "2", "-1", "1E-05", "0.125", "3.0");
  private static final List<String> OFFSETS = List.of("0", "-40", "0.5", "1e3", "+7");
  private static final List<String> UNITS = List.of("", "km/h", "%", "m/s", "a b");

  private final Random random;
  private final StringBuilder messages = new StringBuilder();
  private final List<String> facts = new ArrayList<>();

  private RandomNetwork(Random random) {
    this.random = random;
  }

  /** Returns a network whose signals fit into their messages and do not overlap. */
  static String legal(Random random) {
    RandomNetwork network = new RandomNetwork(random);
    int count = 1 + random.nextInt(4);
    for (int i = 0; i < count; i++) {
      network.message(i);
    }
    String nodes = "BU_: A B" + (random.nextBoolean() ? "\n  C" : " C") + "\n\n";
    String head = "VERSION \"\"\n\nNS_ :\n\tCM_\n\tVAL_\n\nBS_:\n\n" + nodes;
    String defaults =
        random.nextBoolean()
            ? "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\nBA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
            : "";
    StringJoiner rest = new StringJoiner("\n", defaults, "\n");
    network.facts.forEach(rest::add);
    return head + network.messages + rest;
  }

  /** Returns a network with one signal, which may not fit. */
  static String anyPlace(Random random) {
    return String.format(
        Locale.ROOT,
        "BU_: A\nBO_ 1 One: %d A\n SG_ S : %d|%d@%d%s (1,0) [0|0] \"\" A\n",
        1 + random.nextInt(8),
        random.nextInt(70),
        1 + random.nextInt(40),
        random.nextInt(2),
        random.nextBoolean() ? "+" : "-");
  }

  /** Returns a network with signals anywhere in a message, which may share bits. */
  static String overlapping(Random random) {
    StringBuilder text =
        new StringBuilder("BU_: A\nBO_ 1 One: 4 A\n SG_ S0 M : 0|3@1+ (1,0) [0|0] \"\" A\n");
    int count = 1 + random.nextInt(4);
    for (int i = 1; i <= count; i++) {
      int length = 1 + random.nextInt(9);
      int place = random.nextInt(33 - length);
      boolean bigEndian = random.nextBoolean();
      text.append(
          String.format(
              Locale.ROOT,
              " SG_ S%d%s : %d|%d@%d+ (1,0) [0|0] \"\" A\n",
              i,
              random.nextInt(3) == 0 ? "" : " m" + random.nextInt(3),
              bigEndian ? place / 8 * 8 + 7 - place % 8 : place,
              length,
              bigEndian ? 0 : 1));
    }
    return text.toString();
  }

  private <T> T any(List<T> all) {
    return all.get(random.nextInt(all.size()));
  }

  private void message(int index) {
    boolean extended = random.nextBoolean();
    long number = extended ? 0x8000_0000L + random.nextInt(1 << 29) : random.nextInt(200);
    number = number / 8 * 8 + index;
    int size = 1 + random.nextInt(16);
    String sender = any(List.of("A", "B", "Vector__XXX"));
    messages.append(
        String.format(Locale.ROOT, "BO_ %d Message_%d: %d %s\n", number, index, size, sender));
    int bits = 0;
    int count = 0;
    boolean multiplexed = random.nextInt(3) == 0;
    while (bits < 8 * size && count < 6) {
      bits = signal(number, count, bits, 8 * size, multiplexed);
      count++;
    }
    messages.append('\n');
    if (random.nextBoolean()) {
      facts.add(String.format(Locale.ROOT, "CM_ BO_ %d \"Message %d\";", number, index));
    }
    if (random.nextBoolean()) {
      facts.add(
          String.format(
              Locale.ROOT, "BA_ \"GenMsgCycleTime\" BO_ %d %d;", number, random.nextInt(3) * 10));
      facts.add(0, "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;");
    }
  }

  /** Adds a signal after some bits; returns how many there are then. */
  private int signal(long number, int index, int before, int bits, boolean multiplexed) {
    boolean bigEndian = random.nextBoolean();
    boolean floating = !multiplexed && random.nextInt(5) == 0;
    int from = bigEndian ? (before + 7) / 8 * 8 : before;
    int length = floating ? (random.nextBoolean() ? 32 : 64) : 1 + random.nextInt(20);
    if (from + length > bits) {
      return bits;
    }
    int start = bigEndian ? from / 8 * 8 + 7 - from % 8 : from;
    String role = multiplexed ? index == 0 ? " M" : " m" + random.nextInt(2) : "";
    boolean range = random.nextBoolean();
    messages.append(
        String.format(
            Locale.ROOT,
            " SG_ Signal_%d%s : %d|%d@%d%s (%s,%s) [%s] \"%s\" %s\n",
            index,
            role,
            start,
            length,
            bigEndian ? 0 : 1,
            random.nextBoolean() ? "+" : "-",
            any(FACTORS),
            any(OFFSETS),
            range ? "-3|" + (1 + random.nextInt(90)) / 4.0 : "0|0",
            any(UNITS),
            any(List.of("A", "B,C", "Vector__XXX"))));
    facts(number, index, floating, length);
    // Bits of both byte orders in one byte might overlap.
    return bigEndian ? (from + length + 7) / 8 * 8 : from + length;
  }

  private void facts(long number, int index, boolean floating, int length) {
    String name = number + " Signal_" + index;
    if (floating) {
      facts.add("SIG_VALTYPE_ " + name + " : " + (length == 32 ? 1 : 2) + ";");
    } else if (random.nextInt(3) == 0) {
      facts.add("VAL_ " + name + " 1 \"on\" 255 \"SNA\" 0 \"off, or not\" ;");
    }
    if (random.nextBoolean()) {
      facts.add("CM_ SG_ " + name + " \"What it is,\nin \\\"two\\\" lines\";");
    }
  }
}
