package dev.eventchain.workspace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordingTest {

  private static final Path RECORDINGS = Path.of("src/test/resources/recordings");

  /**
   * peer.mcap and sqlite-with-definitions were written by other libraries (write.py,
   * write_sqlite.py), with compressed chunks, and with a definition that is longer than pages.
   */
  @ParameterizedTest
  @CsvSource({
    "peer.mcap, mcap, 2",
    "bag, bag, 2",
    "sqlite, sqlite, 0",
    "sqlite-with-definitions, sqlite-with-definitions, 6"
  })
  void aRecordingIsASoftwareBase(String name, String expected, int definitions) throws IOException {
    Map<String, String> files = RecordedSignals.of(Recording.read(RECORDINGS.resolve(name)));
    Path folder = RECORDINGS.resolve("expected");
    for (String kind : new String[] {"signals", "questions"}) {
      ExpectedFile.check(
          folder.resolve(expected + "." + kind + ".json"), files.get(kind + ".json"));
    }
    assertEquals("[ ]\n", files.get("components.json"));
    assertEquals(
        definitions, files.keySet().stream().filter(file -> file.endsWith(".msg")).count());
  }

  @Test
  void whatIsNoRecordingIsRefused(@TempDir Path folder) throws IOException {
    assertEquals("workspace.recording", refusal(folder));
    Path file = folder.resolve("file.mcap");
    assertEquals("workspace.recording", refusal(file));
    Files.writeString(file, "no recording");
    assertEquals("workspace.recording", refusal(file));
    Files.writeString(folder.resolve("metadata.yaml"), "rosbag2_bagfile_information: {}\n");
    assertEquals("workspace.recording", refusal(folder));
  }

  /** A file that is cut off or damaged is refused, or read as far as its summary is sound. */
  @Test
  void damagedFilesAreRefusedOrRead(@TempDir Path folder) throws IOException {
    byte[] whole = Files.readAllBytes(RECORDINGS.resolve("peer.mcap"));
    Path file = folder.resolve("damaged.mcap");
    for (int length = 0; length < whole.length; length += 97) {
      Files.write(file, Arrays.copyOf(whole, length));
      assertEquals("workspace.recording", refusal(file));
    }
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 300; i++) {
      byte[] damaged = whole.clone();
      int summary = whole.length / 2;
      damaged[summary + random.nextInt(whole.length - summary)] = (byte) random.nextInt(256);
      Files.write(file, damaged);
      try {
        RecordedSignals.of(Recording.read(file));
      } catch (DiagnosticException e) {
        assertEquals("workspace.recording", e.diagnostics().get(0).id());
      }
    }
  }

  /** Bytes of a file in SQLite that are damaged are noticed, or are not those of definitions. */
  @Test
  void damagedDefinitionsAreRefusedOrRead(@TempDir Path folder) throws IOException {
    Path bag = RECORDINGS.resolve("sqlite-with-definitions");
    Files.copy(bag.resolve("metadata.yaml"), folder.resolve("metadata.yaml"));
    byte[] whole = Files.readAllBytes(bag.resolve("sqlite-with-definitions.db3"));
    Path file = folder.resolve("sqlite-with-definitions.db3");
    Files.write(file, Arrays.copyOf(whole, whole.length / 2));
    assertEquals("workspace.recording", refusal(folder));
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 300; i++) {
      byte[] damaged = whole.clone();
      for (int k = 0; k < 20; k++) {
        damaged[random.nextInt(whole.length)] = (byte) random.nextInt(256);
      }
      Files.write(file, damaged);
      try {
        RecordedSignals.of(Recording.read(folder));
      } catch (DiagnosticException e) {
        assertEquals("workspace.recording", e.diagnostics().get(0).id());
      }
    }
  }

  /** Small files may describe many rows, each of them large, by pointers to one cell. */
  @ParameterizedTest
  @CsvSource({
    "16000, 33000, 0, a row of it has too many values",
    "16000, 1, 0, a table of it has too many rows",
    "9999, 1, 33000, its rows are too long"
  })
  void whatWouldNotFitIntoMemoryIsRefused(
      int rows, int values, int length, String reason, @TempDir Path folder) throws IOException {
    Path bag = RECORDINGS.resolve("sqlite-with-definitions");
    Files.copy(bag.resolve("metadata.yaml"), folder.resolve("metadata.yaml"));
    Files.write(folder.resolve("sqlite-with-definitions.db3"), repeated(rows, values, length));
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> Recording.read(folder));
    String message = refused.diagnostics().get(0).message();
    assertTrue(message.contains(reason), message);
  }

  /**
   * Returns a file of a page of 64 KiB, whose rows are all the same.
   *
   * @param values how many values each has: texts, or nothing if they have no length
   */
  private static byte[] repeated(int rows, int values, int length) {
    ByteBuffer header = ByteBuffer.allocate(values * 3);
    for (int i = 0; i < values; i++) {
      header.put(length == 0 ? new byte[1] : varint(13 + 2 * length));
    }
    ByteBuffer page = ByteBuffer.allocate(1 << 16);
    page.put("SQLite format 3\0".getBytes(StandardCharsets.US_ASCII)).putShort(16, (short) 1);
    int cell = 108 + 2 * rows;
    page.put(100, (byte) 13).putShort(103, (short) rows);
    for (int i = 0; i < rows; i++) {
      page.putShort(108 + 2 * i, (short) cell);
    }
    int size = 3 + header.position();
    // The length of the payload, the number of the row, and the length of the header.
    page.position(cell).put(varint(size + values * length)).put(varint(1)).put(varint(size));
    return page.put(header.flip()).array();
  }

  private static byte[] varint(int value) {
    int high = value >> 14;
    return new byte[] {(byte) (high | 0x80), (byte) (value >> 7 | 0x80), (byte) (value & 0x7F)};
  }

  @Test
  void aPartOfABagIsToldFromTheBag() {
    Path part = RECORDINGS.resolve("sqlite-with-definitions/sqlite-with-definitions.db3");
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> Recording.read(part));
    assertTrue(refused.diagnostics().get(0).hint().startsWith("Name its folder."));
  }

  private static String refusal(Path path) {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> RecordedSignals.of(Recording.read(path)));
    return refused.diagnostics().get(0).id();
  }
}
