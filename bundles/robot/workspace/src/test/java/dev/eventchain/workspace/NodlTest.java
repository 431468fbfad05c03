package dev.eventchain.workspace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.messages.MessageCatalog;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class NodlTest {

  private static final Path DOCUMENTS = Path.of("src/test/resources/nodl");

  /** A question stands for each thing that a chain has no counterpart for. */
  @Test
  void documentsAreASoftwareBase() throws IOException {
    FoundSoftware found = Nodl.read(List.of(DOCUMENTS.resolve("front__tracker.nodl.yaml")));
    Map<String, String> files = SoftwareBaseFiles.of(found, MessageCatalog.of(List.of()));
    for (String name : List.of("components", "questions")) {
      String file = name + ".json";
      ExpectedFile.check(DOCUMENTS.resolve("expected").resolve(file), files.get(file));
    }
  }

  @Test
  void whatIsNoDocumentIsRefusedWithItsPlaces() throws IOException {
    Path bad = DOCUMENTS.resolve("bad/node.nodl.yaml");
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> Nodl.read(List.of(bad)));
    ExpectedFile.check(
        DOCUMENTS.resolve("bad/expected.txt"), DiagnosticFormat.TEXT.render(refused.diagnostics()));
    Path unnamed = DOCUMENTS.resolve("schema/no-name.nodl.yaml");
    DiagnosticException noName =
        assertThrows(DiagnosticException.class, () -> Nodl.read(List.of(unnamed)));
    assertEquals("workspace.nodl", noName.diagnostics().get(0).id());
  }
}
