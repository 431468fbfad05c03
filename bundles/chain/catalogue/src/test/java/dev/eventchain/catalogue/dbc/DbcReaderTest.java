package dev.eventchain.catalogue.dbc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkSignals;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Broken networks, and those of other encodings. */
class DbcReaderTest {

  private static final String PARTS = "\"@|[](),:;+-0m \nBO_SG_VAL_1e9\\";

  @TempDir private Path folder;

  /** A file with random changes is read or has findings with lines, and ends reading either way. */
  @Property
  void changedNetworksAreReadOrFound(@ForAll long seed) {
    Random random = new Random(seed);
    StringBuilder text = new StringBuilder(RandomNetwork.legal(random));
    for (int i = random.nextInt(4); i >= 0; i--) {
      int at = random.nextInt(text.length());
      int part = random.nextInt(PARTS.length());
      switch (random.nextInt(3)) {
        case 0 -> text.deleteCharAt(at);
        case 1 -> text.insert(at, PARTS.charAt(part));
        default -> text.setCharAt(at, PARTS.charAt(part));
      }
    }
    List<Diagnostic> found = new ArrayList<>();
    Network network = DbcFormat.network(SourceText.of("network.dbc", text.toString()), found::add);
    new NetworkSignals(network, Optional.of("A"), found::add).all();
    found.forEach(it -> assertTrue(it.location().line() > 0, it::message));
  }

  @Test
  void readsWhatToolsWriteOnWindows() throws IOException {
    String text = "BO_ 1 Air: 1 A\n SG_ Temperature : 0|8@1- (1,0) [0|0] \"°C\" A\n";
    for (Charset charset : List.of(StandardCharsets.UTF_8, Charset.forName("windows-1252"))) {
      Path file = Files.write(folder.resolve("air.dbc"), text.getBytes(charset));
      List<Diagnostic> found = new ArrayList<>();
      List<CatalogueSignal> read =
          new DbcFormat().read(new CatalogueSource(file, List.of(), Optional.empty()), found::add);
      assertEquals(List.of(), found);
      assertEquals(List.of("°C"), read.stream().map(CatalogueSignal::unit).toList());
    }
  }

  @Test
  void textsAndMultiplexersAreAboutPhysicalValues() {
    String text =
        """
        BO_ 1 Oil: 8 A
         SG_ Mux M : 0|4@1+ (1,100) [0|0] "" A
         SG_ Temperature m3 : 8|8@1+ (1,-40) [0|0] "degC" A
         SG_ Speed m4 : 8|8@1+ (0.5,0) [0|0] "km/h" A
         SG_ Nested m5M : 24|8@1- (-2,0) [0|0] "" A
         SG_ Level m0 : 16|8@1+ (1,0) [0|0] "" A
        BA_ "SystemSignalLongSymbol" SG_ 1 Nested "Nested_Multiplexer";
        VAL_ 1 Temperature 255 "SNA" 0 "frozen" ;
        VAL_ 1 Speed 255 "invalid" ;
        SG_MUL_VAL_ 1 Speed Mux 4-6, 8-8;
        SG_MUL_VAL_ 1 Level Nested 1-3, 0-0;
        SG_MUL_VAL_ 1 Temperature Gone 1-1;
        """;
    List<String> found = new ArrayList<>();
    List<String> meanings =
        signals(text, it -> found.add(it.message())).stream()
            .map(CatalogueSignal::description)
            .toList();
    assertEquals(
        List.of(
            "",
            "Values: 215 SNA, -40 frozen. Only sent where Mux is 103.",
            "Values: 127.5 invalid. Only sent where Mux is 104-106, 108.",
            "Only sent where Mux is 105.",
            "Only sent where Nested_Multiplexer is -6 to -2, 0."),
        meanings);
    assertEquals(List.of("The message 'Oil' has no signal 'Gone'."), found);
  }

  /** Files usually state the range of measurements, and texts for an error and no measurement. */
  @Test
  void valuesWithATextArePossibleOutsideTheStatedRange() {
    String text =
        """
        BO_ 1 Oil: 32 A
         SG_ Load : 0|8@1+ (1,0) [0|250] "%" A
         SG_ Temperature : 8|8@1+ (1,-40) [-20|200] "degC" A
         SG_ Slip : 16|8@1- (-0.5,0) [-50|50] "" A
         SG_ Gear : 24|3@1+ (1,0) [0|5] "" A
         SG_ Flow : 32|32@1- (1,0) [0|10] "" A
         SG_ Broken : 64|4@1+ (1,0) [20|30] "" A
         SG_ On : 68|1@1+ (1,0) [1|1] "" A
        VAL_ 1 Load 254 "error" 255 "not available" 0 "none" ;
        VAL_ 1 Temperature 0 "frozen" 255 "SNA" ;
        VAL_ 1 Slip 127 "SNA" ;
        VAL_ 1 Gear 6.5 "half" 8 "too much" 5 "reverse" ;
        VAL_ 1 Flow -1 "SNA" ;
        VAL_ 1 Broken 15 "SNA" ;
        VAL_ 1 On 0 "off" ;
        SIG_VALTYPE_ 1 Flow : 1;
        """;
    List<String> meanings = signals(text, it -> {}).stream().map(CatalogueSignal::meaning).toList();
    assertEquals(
        List.of(
            "Values: 0 none. Outside of 0 to 250: 254 error, 255 not available. Range: 0 to 255.",
            "Outside of -20 to 200: -40 frozen, 215 SNA. Range: -40 to 215.",
            "Outside of -50 to 50: -63.5 SNA. Range: -63.5 to 50.",
            "Values: 6.5 half, 8 too much, 5 reverse. Range: 0 to 5.",
            "Outside of 0 to 10: -1 SNA. Range: -1 to 10.",
            "Values: 15 SNA. Range: 0 to 15.",
            "Values: 0 off."),
        meanings);
  }

  private static List<CatalogueSignal> signals(String text, Consumer<Diagnostic> findings) {
    Network network = DbcFormat.network(SourceText.of("network.dbc", text), findings);
    return new NetworkSignals(network, Optional.empty(), findings).all();
  }

  /** Memory goes with the bits that signals have, and not with those of their messages. */
  @Test
  void aLargeMessageWithManyMultiplexedSignalsIsRead() {
    StringBuilder text =
        new StringBuilder("BO_ 1 Large: 65536 A\n SG_ Mux M : 0|16@1+ (1,0) [0|0] \"\" A\n");
    for (int i = 0; i < 4_000; i++) {
      text.append(String.format(Locale.ROOT, " SG_ S%d m%d : 16|8@1+ (1,0) [0|0] \"\" A%n", i, i));
    }
    List<Diagnostic> found = new ArrayList<>();
    assertEquals(4_001, signals(text.toString(), found::add).size());
    assertEquals(List.of(), found);
  }

  @Test
  void aFileThatIsNoTextIsFound() throws IOException {
    Path file = Files.write(folder.resolve("binary.dbc"), new byte[] {'B', 'O', 0, (byte) 0x81});
    List<Diagnostic> found = new ArrayList<>();
    new DbcFormat().read(new CatalogueSource(file, List.of(), Optional.empty()), found::add);
    assertEquals(List.of("file.encoding"), found.stream().map(Diagnostic::id).toList());
  }
}
