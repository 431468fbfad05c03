package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.model.WrittenRequirement;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests of archives of ReqIF, which come from elsewhere. */
class ReqIfArchiveTest {

  private static final Path GOOD = Path.of("src/test/resources/cases/sources/reqif/radar.reqif");

  @TempDir Path folder;
  private Path archive;

  @BeforeEach
  void createAProject() throws IOException {
    archive = folder.resolve("radar.reqifz");
    Files.writeString(
        folder.resolve("eventchain.yaml"), "name: radar\nrequirements: radar.reqifz\n");
  }

  @Test
  void theFilesOfAnArchiveAreReadAndNamedInIt() throws IOException {
    pack("pictures/curve.png", new byte[] {1}, "specs/radar.reqif", Files.readAllBytes(GOOD));
    Requirements read = new ProjectFolder(folder).readRequirements();
    assertEquals(
        List.of("RAD-1", "RAD-1.1", "a/b"),
        read.items().stream().map(WrittenRequirement::id).toList());
    String place = read.items().get(0).location().toString();
    assertTrue(place.endsWith("radar.reqifz!/specs/radar.reqif:67:9"), place);
  }

  @Test
  void namesThatLeadOutOfTheArchiveAreRefused() throws IOException {
    for (String name :
        List.of("../radar.reqif", "/radar.reqif", "a/../../b.reqif", "C:\\x.reqif")) {
      pack(name, Files.readAllBytes(GOOD));
      assertTrue(refusal().contains("'" + name + "' leads out of it"), name);
    }
  }

  @Test
  void whatUnpacksToTooMuchIsRefusedBeforeItDoes() throws IOException {
    pack("radar.reqif", new byte[(32 << 20) + 1]);
    assertTrue(Files.size(archive) < 100_000);
    assertTrue(refusal().contains("more than 33554432 bytes"), refusal());
    // Of other files nothing is unpacked.
    pack("radar.reqif", Files.readAllBytes(GOOD), "large.bin", new byte[(32 << 20) + 1]);
    assertEquals(3, new ProjectFolder(folder).readRequirements().items().size());
  }

  @Test
  void whatIsNoArchiveOfReqIfIsAFinding() throws IOException {
    Files.writeString(archive, "PK, but no zip");
    assertTrue(refusal().contains("it is no zip file that can be read"), refusal());
    pack("notes.txt", new byte[0]);
    assertTrue(refusal().contains("it has no .reqif file"), refusal());
    pack("radar.reqif", "<REQ-IF>\u00e4</REQ-IF>".getBytes(StandardCharsets.ISO_8859_1));
    assertTrue(refusal().contains("'radar.reqif' is not UTF-8 text"), refusal());
    pack(
        "radar.reqif",
        "<?xml version='1.0' encoding='UTF-16'?><REQ-IF/>".getBytes(StandardCharsets.UTF_8));
    assertTrue(refusal().contains("its encoding is UTF-16"), refusal());
    Files.delete(archive);
    assertTrue(refusal().contains("file.missing"), refusal());
  }

  private String refusal() {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> new ProjectFolder(folder).readRequirements());
    assertEquals(DiagnosticException.Reason.INPUT, refused.reason());
    return DiagnosticFormat.TEXT.render(refused.diagnostics());
  }

  /** Writes an archive of names, each followed by its content. */
  private void pack(Object... entries) throws IOException {
    try (OutputStream file = Files.newOutputStream(archive);
        ZipOutputStream zip = new ZipOutputStream(file)) {
      for (int i = 0; i < entries.length; i += 2) {
        zip.putNextEntry(new ZipEntry((String) entries[i]));
        zip.write((byte[]) entries[i + 1]);
      }
    }
  }
}
