package dev.eventchain.catalogue.arxml;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** The text of a random system description with one message, of which each part may be missing. */
final class RandomDescription {

  private static final List<String> LINES =
      List.of("0 1 1", "-40 1 1", "0 1 100", "0.5 0.125 1", "1e3 2 1", "0 1 3", "5 -1 2");
  private static final List<String> LIMITED = List.of("0 1 1", "-40 1 1", "0.5 0.125 1", "0 2 1");
  private static final List<String> UNITS = List.of("km/h", "%", "m/s", "a b");

  private final Random random;
  private final StringBuilder signals = new StringBuilder();
  private final StringBuilder systems = new StringBuilder();
  private final StringBuilder methods = new StringBuilder();
  private final StringBuilder packages = new StringBuilder();

  private RandomDescription(Random random) {
    this.random = random;
  }

  /** Returns a description whose signals fit into their message and do not overlap. */
  static String legal(Random random) {
    RandomDescription text = new RandomDescription(random);
    int size = 1 + random.nextInt(16);
    StringBuilder mappings = new StringBuilder();
    int bits = 0;
    for (int i = 0; i < 6 && bits < 8 * size; i++) {
      boolean bigEndian = random.nextBoolean();
      boolean floating = random.nextInt(5) == 0;
      int from = bigEndian ? (bits + 7) / 8 * 8 : bits;
      int length = floating ? (random.nextBoolean() ? 32 : 64) : 1 + random.nextInt(20);
      if (from + length <= 8 * size) {
        text.signal("Signal_" + i, length, floating);
        int start = bigEndian ? from / 8 * 8 + 7 - from % 8 : from;
        mappings.append(mapping("/Signals/Signal_" + i, bigEndian, start));
        bits = bigEndian ? (from + length + 7) / 8 * 8 : from + length;
      }
    }
    return text.whole(size, text.pdu("Pdu", size, mappings), "I-SIGNAL-I-PDU");
  }

  /** Returns a description with one or two signals, which may not fit and may share bits. */
  static String anyPlace(Random random) {
    RandomDescription text = new RandomDescription(random);
    StringBuilder mappings = new StringBuilder();
    for (int i = 0; i <= random.nextInt(2); i++) {
      text.signals.append(isignal("Signal_" + i, 1 + random.nextInt(20), "", ""));
      mappings.append(mapping("/Signals/Signal_" + i, random.nextBoolean(), random.nextInt(40)));
    }
    int size = 1 + random.nextInt(5);
    return text.whole(size, text.pdu("Pdu", size, mappings), "I-SIGNAL-I-PDU");
  }

  /** Returns a description with two alternatives, each with the selector and another signal. */
  static String multiplexed(Random random) {
    RandomDescription text = new RandomDescription(random);
    boolean bigEndian = random.nextBoolean();
    int start = bigEndian ? 7 : 0;
    StringBuilder pdus = new StringBuilder();
    StringBuilder alternatives = new StringBuilder();
    for (int i = 0; i < 2; i++) {
      text.signal("Signal_" + i, 1 + random.nextInt(20), false);
      text.packages.append(aPackage("Selector_" + i, isignal("Message_selector1", 4, "", "")));
      String mappings =
          mapping("/Selector_" + i + "/Message_selector1", bigEndian, start)
              + mapping("/Signals/Signal_" + i, false, 8);
      pdus.append(text.pdu("Alternative_" + i, 8, mappings));
      alternatives.append(
          "<DYNAMIC-PART-ALTERNATIVE>"
              + reference("I-PDU-REF", "I-SIGNAL-I-PDU", "/Pdus/Alternative_" + i)
              + element("SELECTOR-FIELD-CODE", i * 3)
              + "</DYNAMIC-PART-ALTERNATIVE>");
    }
    String parts =
        element("LENGTH", 8)
            + element(
                "DYNAMIC-PARTS",
                element("DYNAMIC-PART", element("DYNAMIC-PART-ALTERNATIVES", alternatives)))
            + element("SELECTOR-FIELD-BYTE-ORDER", order(bigEndian))
            + element("SELECTOR-FIELD-LENGTH", 4)
            + element("SELECTOR-FIELD-START-POSITION", start);
    return text.whole(8, pdus + named("MULTIPLEXED-I-PDU", "Pdu", parts), "MULTIPLEXED-I-PDU");
  }

  private <T> T any(List<T> all) {
    return all.get(random.nextInt(all.size()));
  }

  /** Adds a signal. */
  private void signal(String name, int length, boolean floating) {
    String kind = floating ? "float" : random.nextBoolean() ? "sint" : "uint";
    String initial =
        random.nextBoolean()
            ? element(
                "INIT-VALUE",
                element("NUMERICAL-VALUE-SPECIFICATION", element("VALUE", random.nextInt(3))))
            : "";
    String type =
        random.nextInt(4) == 0 && !floating
            ? ""
            : properties(
                "NETWORK-REPRESENTATION-PROPS",
                reference("BASE-TYPE-REF", "SW-BASE-TYPE", "/Types/" + kind));
    signals.append(
        isignal(
            name,
            length,
            initial,
            type + reference("SYSTEM-SIGNAL-REF", "SYSTEM-SIGNAL", "/Systems/" + name)));
    meaning(name, floating);
  }

  /** Adds what a signal stands for. */
  private void meaning(String name, boolean floating) {
    methods.append(named("UNIT", "Unit_" + name, element("DISPLAY-NAME", any(UNITS))));
    String unit =
        random.nextBoolean() ? reference("UNIT-REF", "UNIT", "/Methods/Unit_" + name) : "";
    boolean inMethod = random.nextBoolean();
    boolean method = random.nextInt(4) > 0;
    if (method) {
      methods.append(
          named("COMPU-METHOD", name, method(floating).replace("UNIT", inMethod ? unit : "")));
    }
    String physical =
        (method ? reference("COMPU-METHOD-REF", "COMPU-METHOD", "/Methods/" + name) : "")
            + (inMethod && method ? "" : unit);
    String description =
        random.nextBoolean()
            ? "<DESC><L-2 L=\"EN\">About " + name + " &amp; more</L-2></DESC>"
            : "";
    systems.append(
        named(
            "SYSTEM-SIGNAL",
            name,
            description + (physical.isEmpty() ? "" : properties("PHYSICAL-PROPS", physical))));
  }

  /** Returns the parts of a method, with the word UNIT where its unit may stand. */
  private String method(boolean floating) {
    String category =
        floating
            ? "LINEAR"
            : any(List.of("LINEAR", "TEXTTABLE", "SCALE_LINEAR_AND_TEXTTABLE", "IDENTICAL"));
    List<String> scales = new ArrayList<>();
    if (category.startsWith("SCALE")) {
      scales.add(limits(0, 10) + line(any(LIMITED)));
    } else if (category.equals("LINEAR")) {
      boolean limited = random.nextBoolean();
      scales.add(
          limited ? limits(0, 1 + random.nextInt(3)) + line(any(LIMITED)) : line(any(LINES)));
    }
    if (category.endsWith("TEXTTABLE")) {
      scales.add(limits(1, 1) + text("on"));
      scales.add(limits(0, 0) + text("off, or not"));
      scales.add(limits(15, 15) + text("SNA"));
    }
    StringBuilder all = new StringBuilder();
    scales.forEach(each -> all.append(element("COMPU-SCALE", each)));
    return element("CATEGORY", category)
        + "UNIT"
        + (scales.isEmpty() ? "" : element("COMPU-INTERNAL-TO-PHYS", element("COMPU-SCALES", all)));
  }

  private static String line(String numbers) {
    String[] each = numbers.split(" ", 3);
    return element(
        "COMPU-RATIONAL-COEFFS",
        element("COMPU-NUMERATOR", element("V", each[0]) + element("V", each[1]))
            + element("COMPU-DENOMINATOR", element("V", each[2])));
  }

  private static String limits(int from, int to) {
    return String.format(
        Locale.ROOT,
        "<LOWER-LIMIT INTERVAL-TYPE=\"CLOSED\">%d</LOWER-LIMIT><UPPER-LIMIT>%d</UPPER-LIMIT>",
        from,
        to);
  }

  private static String text(String text) {
    return element("COMPU-CONST", element("VT", text));
  }

  private static String properties(String tag, String all) {
    return element(
        tag, element("SW-DATA-DEF-PROPS-VARIANTS", element("SW-DATA-DEF-PROPS-CONDITIONAL", all)));
  }

  private static String isignal(String name, int length, String initial, String rest) {
    return named("I-SIGNAL", name, initial + element("LENGTH", length) + rest);
  }

  private static String order(boolean bigEndian) {
    return "MOST-SIGNIFICANT-BYTE-" + (bigEndian ? "FIRST" : "LAST");
  }

  private static String mapping(String signal, boolean bigEndian, int start) {
    return named(
        "I-SIGNAL-TO-I-PDU-MAPPING",
        signal.substring(signal.lastIndexOf('/') + 1),
        reference("I-SIGNAL-REF", "I-SIGNAL", signal)
            + element("PACKING-BYTE-ORDER", order(bigEndian))
            + element("START-POSITION", start));
  }

  private String pdu(String name, int size, CharSequence mappings) {
    String period =
        random.nextBoolean()
            ? ""
            : element(
                "I-PDU-TIMING-SPECIFICATIONS",
                element(
                    "I-PDU-TIMING",
                    element(
                        "TRANSMISSION-MODE-DECLARATION",
                        element(
                            "TRANSMISSION-MODE-TRUE-TIMING",
                            element(
                                "CYCLIC-TIMING",
                                element(
                                    "TIME-PERIOD",
                                    element("VALUE", any(List.of("0.01", "0.5", "1.0")))))))));
    return named(
        "I-SIGNAL-I-PDU",
        name,
        element("LENGTH", size) + period + element("I-SIGNAL-TO-PDU-MAPPINGS", mappings));
  }

  private String frame(int size, String kind) {
    String parts =
        (random.nextBoolean() ? "<DESC><L-2 L=\"FOR-ALL\">A frame</L-2></DESC>" : "")
            + element("FRAME-LENGTH", size)
            + element(
                "PDU-TO-FRAME-MAPPINGS",
                named(
                    "PDU-TO-FRAME-MAPPING",
                    "Mapping",
                    reference("PDU-REF", kind, "/Pdus/Pdu") + element("START-POSITION", 0)));
    return named("CAN-FRAME", "Message", parts);
  }

  private String cluster() {
    boolean extended = random.nextBoolean();
    String triggering =
        reference("FRAME-REF", "CAN-FRAME", "/Bus/Message")
            + element("CAN-ADDRESSING-MODE", extended ? "EXTENDED" : "STANDARD")
            + element("IDENTIFIER", random.nextInt(extended ? 1 << 29 : 1 << 11));
    String channel =
        element("FRAME-TRIGGERINGS", named("CAN-FRAME-TRIGGERING", "Sent", triggering));
    String variants =
        element(
            "CAN-CLUSTER-VARIANTS",
            element(
                "CAN-CLUSTER-CONDITIONAL",
                element("PHYSICAL-CHANNELS", named("CAN-PHYSICAL-CHANNEL", "Channel", channel))));
    return named("CAN-CLUSTER", "Cluster", variants);
  }

  private static String type(String name, String encoding) {
    return named("SW-BASE-TYPE", name, element("BASE-TYPE-ENCODING", encoding));
  }

  private String whole(int size, String pdus, String kind) {
    return """
        <AUTOSAR xmlns="http://autosar.org/schema/r4.0"><AR-PACKAGES>
        %s</AR-PACKAGES></AUTOSAR>
        """
        .formatted(
            aPackage("Types", type("uint", "NONE") + type("sint", "2C") + type("float", "IEEE754"))
                + aPackage("Methods", methods)
                + aPackage("Systems", systems)
                + aPackage("Signals", signals)
                + packages
                + aPackage("Pdus", pdus + group("Pdu", kind))
                + aPackage("Bus", ecu() + frame(size, kind) + cluster()));
  }

  private static String group(String pdu, String kind) {
    return named(
        "I-SIGNAL-I-PDU-GROUP",
        "Group",
        element("COMMUNICATION-DIRECTION", "OUT")
            + element(
                "I-SIGNAL-I-PDUS",
                element(
                    "I-SIGNAL-I-PDU-REF-CONDITIONAL",
                    reference("I-SIGNAL-I-PDU-REF", kind, "/Pdus/" + pdu))));
  }

  private String ecu() {
    return named(
        "ECU-INSTANCE",
        "A",
        random.nextBoolean()
            ? ""
            : element(
                "ASSOCIATED-COM-I-PDU-GROUP-REFS",
                reference(
                    "ASSOCIATED-COM-I-PDU-GROUP-REF", "I-SIGNAL-I-PDU-GROUP", "/Pdus/Group")));
  }

  private static String aPackage(String name, CharSequence elements) {
    return named("AR-PACKAGE", name, element("ELEMENTS", elements)) + "\n";
  }

  private static String named(String tag, String name, CharSequence rest) {
    return element(tag, element("SHORT-NAME", name) + rest + "\n");
  }

  private static String element(String tag, Object content) {
    return "<" + tag + ">" + content + "</" + tag + ">";
  }

  private static String reference(String tag, String kind, String path) {
    return "<%s DEST=\"%s\">%s</%s>".formatted(tag, kind, path, tag);
  }
}
