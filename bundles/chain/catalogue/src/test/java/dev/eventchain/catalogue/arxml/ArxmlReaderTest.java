package dev.eventchain.catalogue.arxml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Broken descriptions, and large ones. */
class ArxmlReaderTest {

  private static final int COUNT = Thorough.IS_ON ? 20_000 : 300;
  private static final List<String> PARTS =
      List.of("<", ">", "/", "&", "-", "1e9", "LENGTH", "Signal_1", "\"", " ");

  private static final String LARGE =
      """
      <AUTOSAR><AR-PACKAGES><AR-PACKAGE><SHORT-NAME>P</SHORT-NAME><ELEMENTS>
      <COMPU-METHOD><SHORT-NAME>M</SHORT-NAME><COMPU-INTERNAL-TO-PHYS><COMPU-SCALES>%s</COMPU-SCALES>
      </COMPU-INTERNAL-TO-PHYS></COMPU-METHOD>
      <I-SIGNAL><SHORT-NAME>S</SHORT-NAME><LENGTH>16</LENGTH><NETWORK-REPRESENTATION-PROPS>
      <SW-DATA-DEF-PROPS-VARIANTS><SW-DATA-DEF-PROPS-CONDITIONAL><COMPU-METHOD-REF>/P/M</COMPU-METHOD-REF>
      </SW-DATA-DEF-PROPS-CONDITIONAL></SW-DATA-DEF-PROPS-VARIANTS></NETWORK-REPRESENTATION-PROPS></I-SIGNAL>
      <I-SIGNAL-I-PDU><SHORT-NAME>U</SHORT-NAME><I-SIGNAL-TO-PDU-MAPPINGS>%s</I-SIGNAL-TO-PDU-MAPPINGS></I-SIGNAL-I-PDU>
      <CAN-FRAME><SHORT-NAME>F</SHORT-NAME><FRAME-LENGTH>8</FRAME-LENGTH><PDU-TO-FRAME-MAPPINGS>
      <PDU-TO-FRAME-MAPPING><PDU-REF>/P/U</PDU-REF></PDU-TO-FRAME-MAPPING></PDU-TO-FRAME-MAPPINGS></CAN-FRAME>
      <CAN-CLUSTER><SHORT-NAME>C</SHORT-NAME><CAN-CLUSTER-VARIANTS><CAN-CLUSTER-CONDITIONAL>
      <PHYSICAL-CHANNELS><CAN-PHYSICAL-CHANNEL><SHORT-NAME>H</SHORT-NAME><FRAME-TRIGGERINGS>
      <CAN-FRAME-TRIGGERING><FRAME-REF>/P/F</FRAME-REF></CAN-FRAME-TRIGGERING></FRAME-TRIGGERINGS>
      </CAN-PHYSICAL-CHANNEL></PHYSICAL-CHANNELS></CAN-CLUSTER-CONDITIONAL></CAN-CLUSTER-VARIANTS></CAN-CLUSTER>
      </ELEMENTS></AR-PACKAGE></AR-PACKAGES></AUTOSAR>
      """;

  private static final String MAPPING =
      "<I-SIGNAL-TO-I-PDU-MAPPING><I-SIGNAL-REF>/P/S</I-SIGNAL-REF><START-POSITION>0</START-POSITION></I-SIGNAL-TO-I-PDU-MAPPING>";

  @TempDir private Path folder;

  private List<CatalogueSignal> read(String text, Consumer<Diagnostic> findings)
      throws IOException {
    Path file = Files.writeString(folder.resolve("network.arxml"), text);
    return new ArxmlFormat().read(new CatalogueSource(file, List.of(), Optional.empty()), findings);
  }

  /** A file with random changes is read or has findings with lines, and ends reading either way. */
  @Test
  void changedDescriptionsAreReadOrFound() throws IOException {
    Random random = new Random(Thorough.turn());
    for (int i = 0; i < COUNT; i++) {
      String text =
          i % 2 == 0 ? RandomDescription.legal(random) : RandomDescription.multiplexed(random);
      StringBuilder changed = new StringBuilder(text);
      int at = random.nextInt(text.length());
      String part = PARTS.get(random.nextInt(PARTS.size()));
      changed.replace(at, Math.min(text.length(), at + random.nextInt(3) * 4), part);
      List<Diagnostic> found = new ArrayList<>();
      read(changed.toString(), found::add);
      found.forEach(it -> assertTrue(it.location().line() > 0, it::message));
    }
  }

  /** Each element of a text is left out in turn: nothing that is missing ends the program. */
  @Test
  void descriptionsWithoutAnElementAreReadOrFound() throws IOException {
    String text = RandomDescription.multiplexed(new Random(1));
    int count = 0;
    for (int from = text.indexOf("<AR-PACKAGE>"); from >= 0; from = text.indexOf('<', from + 1)) {
      String tag = text.substring(from + 1, text.indexOf('>', from)).split(" ", 2)[0];
      int to = text.indexOf("</" + tag + ">", from);
      if (!tag.startsWith("/") && to > 0) {
        String without = text.substring(0, from) + text.substring(to + tag.length() + 3);
        List<Diagnostic> found = new ArrayList<>();
        read(without, found::add);
        found.forEach(it -> assertTrue(it.location().line() > 0, it::message));
        count++;
      }
    }
    assertTrue(count > 100, () -> "few elements");
  }

  /** The last text of a table may stand for all numbers from one on. */
  @Test
  void theTextOfARangeWithoutAnEndLeavesTheRangeOpen() throws IOException {
    String scales =
        """
        <COMPU-SCALE><LOWER-LIMIT>0</LOWER-LIMIT><UPPER-LIMIT>0</UPPER-LIMIT><COMPU-CONST><VT>off</VT></COMPU-CONST></COMPU-SCALE>
        <COMPU-SCALE><LOWER-LIMIT>1</LOWER-LIMIT><UPPER-LIMIT INTERVAL-TYPE="INFINITE"/><COMPU-CONST><VT>on</VT></COMPU-CONST></COMPU-SCALE>
        """;
    List<String> found = new ArrayList<>();
    List<CatalogueSignal> read =
        read(LARGE.formatted(scales, MAPPING), it -> found.add(it.message()));
    assertEquals(OptionalDouble.of(0xFFFF), read.get(0).most());
    assertTrue(
        found.contains("A text of more than 256 numbers is not read as their name: '/P/M on'."),
        found::toString);
  }

  /** Texts of ranges, and signals that share a method, multiply each other. */
  @Test
  void textsThatMultiplyEndReading() throws IOException {
    StringBuilder scales = new StringBuilder();
    for (int i = 0; i < 20; i++) {
      scales.append(
          String.format(
              Locale.ROOT,
              "<COMPU-SCALE><LOWER-LIMIT>%d</LOWER-LIMIT><UPPER-LIMIT>%d</UPPER-LIMIT><COMPU-CONST><VT>T</VT></COMPU-CONST></COMPU-SCALE>",
              256 * i,
              256 * i + 255));
    }
    List<String> found = new ArrayList<>();
    Consumer<Diagnostic> sizes =
        it -> Stream.of(it.id()).filter("catalogue.size"::equals).forEach(found::add);
    assertEquals(List.of(), read(LARGE.formatted(scales, MAPPING.repeat(200)), sizes));
    assertEquals(List.of("catalogue.size"), found);
  }
}
