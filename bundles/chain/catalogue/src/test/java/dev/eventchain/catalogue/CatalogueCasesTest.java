package dev.eventchain.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.model.Signal;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Test cases, one per folder: a catalogue {@code vss.*} or {@code network.*} with an {@code
 * overlay.*} and the node of {@code node.txt}; {@code expected.txt} holds the findings and the
 * signals with their topics.
 */
class CatalogueCasesTest {

  private static final Path CASES = Path.of("src/test/resources/cases");
  private static final Path WHOLE = Path.of("../../../examples/child-presence/catalogue/vss.json");

  static Stream<String> cases() throws IOException {
    try (Stream<Path> folders = Files.list(CASES)) {
      return folders.map(it -> it.getFileName().toString()).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("cases")
  void saysWhatIsExpected(String name) throws IOException {
    Path folder = CASES.resolve(name);
    SignalCatalogue read = read(folder);
    String actual =
        DiagnosticFormat.TEXT.render(read.diagnostics()).replace(folder + "/", "")
            + read.signals().stream()
                .map(signal -> described(signal, read))
                .collect(Collectors.joining());
    ExpectedFile.check(folder.resolve("expected.txt"), actual);
  }

  /** What vss-tools export of the files of {@code good-vspec}. */
  @ParameterizedTest
  @ValueSource(strings = {"good-json", "good-yaml", "good-ddsidl"})
  void readsFilesAndTheirExportsAlike(String exported) throws IOException {
    assertEquals(sorted("good-vspec"), sorted(exported));
  }

  private static List<String> sorted(String name) throws IOException {
    SignalCatalogue read = read(CASES.resolve(name));
    return read.signals().stream().map(signal -> described(signal, read)).sorted().toList();
  }

  @Test
  void readsTheWholeCatalogueWithoutAFinding() {
    SignalCatalogue read =
        SignalCatalogue.read(new CatalogueSource(WHOLE, List.of(), Optional.empty()));
    assertEquals(List.of(), read.diagnostics());
    assertEquals(1367, read.signals().size());
    assertEquals(
        List.of(20L, 643L),
        List.of(
            read.signals().stream().filter(it -> read.topics(List.of(it)).isEmpty()).count(),
            read.topics().stream()
                .filter(it -> it.direction() == Signal.Direction.CONSUMED)
                .count()));
  }

  private static SignalCatalogue read(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      List<Path> all = files.sorted().toList();
      List<Path> catalogues = new ArrayList<>(named("vss.", all));
      catalogues.addAll(named("network.", all));
      Path node = folder.resolve("node.txt");
      Optional<String> software =
          Files.exists(node) ? Optional.of(Files.readString(node).strip()) : Optional.empty();
      return SignalCatalogue.read(
          new CatalogueSource(catalogues.get(0), named("overlay.", all), software));
    }
  }

  private static List<Path> named(String start, List<Path> files) {
    return files.stream().filter(it -> it.getFileName().toString().startsWith(start)).toList();
  }

  private static String described(CatalogueSignal signal, SignalCatalogue read) {
    String topics =
        read.topics(List.of(signal)).stream()
            .map(it -> "  %s %s %s%n".formatted(it.topic(), it.messageType(), it.direction()))
            .collect(Collectors.joining());
    String names =
        signal.names().stream()
            .map(it -> "  %s is %s%n".formatted(it.number(), it.name()))
            .collect(Collectors.joining());
    return "%s %s [%s] %s%n"
            .formatted(signal.path(), signal.role(), signal.unit(), signal.meaning())
        + names
        + topics;
  }
}
