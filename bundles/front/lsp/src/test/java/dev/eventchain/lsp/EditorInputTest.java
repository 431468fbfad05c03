package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.check.WorkspaceFiles;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.lsp.text.ProtocolJson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests of what editors send in more than one way: addresses, settings, folders. */
class EditorInputTest {

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "file:///models/a b/é.ocl",
        "file:///models/a%20b/%C3%A9.ocl",
        "file://localhost/models/a%20b/é.ocl",
        "FILE:/models/x/../a%20b/é.ocl"
      })
  void anAddressNamesAFile(String address) {
    assertEquals(Optional.of(Path.of("/models/a b/é.ocl")), Positions.path(address));
  }

  @ParameterizedTest
  @ValueSource(strings = {"untitled:Untitled-1", "http://host/a.ocl", "file://host/a.ocl", "%"})
  void otherAddressesNameNone(String address) {
    assertEquals(Optional.empty(), Positions.path(address));
  }

  private static JsonNode sent(String text) throws IOException {
    return ProtocolJson.read(text.replace('\'', '"'));
  }

  @Test
  void settingsStayUntilOthersAreSent() throws IOException {
    Settings given = Settings.of(sent("{'eventchain': {'timeLimit': 7}}"), Settings.USUAL);
    assertEquals(Duration.ofSeconds(7), given.timeLimit());
    assertEquals(given, Settings.of(sent("{}"), given));
    assertEquals(given, Settings.of(ProtocolJson.of(null), given));
    assertEquals(Settings.USUAL, Settings.of(sent("{'eventchain': {}}"), given));
  }

  @Test
  void aFolderMayBeALink() throws IOException {
    Path real = Files.createDirectory(folder.resolve("real"));
    Files.writeString(real.resolve("rules.ocl"), "");
    Files.writeString(real.resolve("eventchain.yaml"), "");
    Path link = Files.createSymbolicLink(folder.resolve("link"), real);
    WorkspaceFiles found = WorkspaceFiles.of(List.of(link), Set.of());
    assertEquals(List.of(link.resolve("rules.ocl")), found.all());
    assertEquals(List.of(link), found.projects());
  }
}
