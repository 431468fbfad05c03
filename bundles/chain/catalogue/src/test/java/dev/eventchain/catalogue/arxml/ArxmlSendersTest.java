package dev.eventchain.catalogue.arxml;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSignal.Role;
import dev.eventchain.catalogue.signal.CatalogueSource;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which messages an ECU sends. */
class ArxmlSendersTest {

  private static final String PDU =
      """
      <I-SIGNAL><SHORT-NAME>S</SHORT-NAME><LENGTH>16</LENGTH></I-SIGNAL>
      <I-SIGNAL-I-PDU><SHORT-NAME>U</SHORT-NAME><LENGTH>8</LENGTH><I-SIGNAL-TO-PDU-MAPPINGS>
      <I-SIGNAL-TO-I-PDU-MAPPING><I-SIGNAL-REF>/P/S</I-SIGNAL-REF><START-POSITION>0</START-POSITION>
      </I-SIGNAL-TO-I-PDU-MAPPING></I-SIGNAL-TO-PDU-MAPPINGS></I-SIGNAL-I-PDU>
      """;

  /** A frame on a bus of its own, with a container of the PDU, and the ports that refer to it. */
  private static final String BUS =
      """
      <CONTAINER-I-PDU><SHORT-NAME>%1$sBox</SHORT-NAME><CONTAINED-PDU-TRIGGERING-REFS>
      <CONTAINED-PDU-TRIGGERING-REF>/P/%1$s/H/T</CONTAINED-PDU-TRIGGERING-REF>
      </CONTAINED-PDU-TRIGGERING-REFS></CONTAINER-I-PDU>
      <CAN-FRAME><SHORT-NAME>%1$sFrame</SHORT-NAME><FRAME-LENGTH>64</FRAME-LENGTH><PDU-TO-FRAME-MAPPINGS>
      <PDU-TO-FRAME-MAPPING><PDU-REF>/P/%1$sBox</PDU-REF></PDU-TO-FRAME-MAPPING></PDU-TO-FRAME-MAPPINGS></CAN-FRAME>
      <CAN-CLUSTER><SHORT-NAME>%1$s</SHORT-NAME><CAN-CLUSTER-VARIANTS><CAN-CLUSTER-CONDITIONAL>
      <PHYSICAL-CHANNELS><CAN-PHYSICAL-CHANNEL><SHORT-NAME>H</SHORT-NAME><FRAME-TRIGGERINGS>
      <CAN-FRAME-TRIGGERING><FRAME-PORT-REFS>%2$s</FRAME-PORT-REFS><FRAME-REF>/P/%1$sFrame</FRAME-REF></CAN-FRAME-TRIGGERING>
      </FRAME-TRIGGERINGS><PDU-TRIGGERINGS><PDU-TRIGGERING><SHORT-NAME>T</SHORT-NAME><I-PDU-REF>/P/U</I-PDU-REF>
      </PDU-TRIGGERING></PDU-TRIGGERINGS></CAN-PHYSICAL-CHANNEL></PHYSICAL-CHANNELS></CAN-CLUSTER-CONDITIONAL>
      </CAN-CLUSTER-VARIANTS></CAN-CLUSTER>
      """;

  @TempDir private Path folder;

  private List<Role> roles(String node, String... elements) throws IOException {
    String text =
        "<AUTOSAR><AR-PACKAGES><AR-PACKAGE><SHORT-NAME>P</SHORT-NAME><ELEMENTS>"
            + PDU
            + String.join("\n", elements)
            + "</ELEMENTS></AR-PACKAGE></AR-PACKAGES></AUTOSAR>";
    Path file = Files.writeString(folder.resolve("network.arxml"), text);
    CatalogueSource source = new CatalogueSource(file, List.of(), Optional.of(node));
    return new ArxmlFormat().read(source, found -> {}).stream().map(CatalogueSignal::role).toList();
  }

  private static String ecu(String name, String content) {
    return "<ECU-INSTANCE><SHORT-NAME>" + name + "</SHORT-NAME>" + content + "</ECU-INSTANCE>";
  }

  private static String port(String name, String direction) {
    return "<FRAME-PORT><SHORT-NAME>%s</SHORT-NAME><COMMUNICATION-DIRECTION>%s</COMMUNICATION-DIRECTION></FRAME-PORT>"
        .formatted(name, direction);
  }

  private static String bus(String name, String... ports) {
    String references =
        List.of(ports).stream()
            .map(it -> "<FRAME-PORT-REF>/P/" + it + "</FRAME-PORT-REF>")
            .collect(Collectors.joining());
    return BUS.formatted(name, references);
  }

  /** A gateway takes a PDU out of one container, and passes it on in another one. */
  @Test
  void whatAGatewayPassesOnInAnotherContainerIsNotSentByIt() throws IOException {
    String source = ecu("Source", port("Out", "OUT"));
    String gateway = ecu("Gateway", port("In", "IN") + port("Out", "OUT"));
    String first = bus("First", "Source/Out", "Gateway/In");
    String second = bus("Second", "Gateway/Out");
    assertEquals(List.of(Role.COMMAND), roles("Source", source, gateway, second, first));
    assertEquals(List.of(Role.SENSOR), roles("Gateway", source, gateway, second, first));
    assertEquals(List.of(Role.COMMAND), roles("Source", source, gateway, first, second));
  }

  @Test
  void thousandsOfGroupsInEachOtherAreFollowed() throws IOException {
    int last = 20_000;
    String groups =
        IntStream.range(0, last)
            .mapToObj(
                i ->
                    String.format(
                        Locale.ROOT,
                        """
                        <I-SIGNAL-I-PDU-GROUP><SHORT-NAME>G%d</SHORT-NAME><CONTAINED-I-SIGNAL-I-PDU-GROUP-REFS>
                        <CONTAINED-I-SIGNAL-I-PDU-GROUP-REF>/P/G%d</CONTAINED-I-SIGNAL-I-PDU-GROUP-REF>
                        </CONTAINED-I-SIGNAL-I-PDU-GROUP-REFS></I-SIGNAL-I-PDU-GROUP>
                        """,
                        i,
                        i + 1))
            .collect(Collectors.joining());
    String sending =
        String.format(
            Locale.ROOT,
            """
            <I-SIGNAL-I-PDU-GROUP><SHORT-NAME>G%d</SHORT-NAME><COMMUNICATION-DIRECTION>OUT</COMMUNICATION-DIRECTION>
            <I-SIGNAL-I-PDUS><I-SIGNAL-I-PDU-REF-CONDITIONAL><I-SIGNAL-I-PDU-REF>/P/U</I-SIGNAL-I-PDU-REF>
            </I-SIGNAL-I-PDU-REF-CONDITIONAL></I-SIGNAL-I-PDUS></I-SIGNAL-I-PDU-GROUP>
            """,
            last);
    String ecu =
        ecu(
            "E",
            "<ASSOCIATED-COM-I-PDU-GROUP-REFS><ASSOCIATED-COM-I-PDU-GROUP-REF>/P/G0</ASSOCIATED-COM-I-PDU-GROUP-REF></ASSOCIATED-COM-I-PDU-GROUP-REFS>");
    assertEquals(List.of(Role.COMMAND), roles("E", ecu, groups, sending, bus("Bus")));
  }
}
