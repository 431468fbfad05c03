package dev.eventchain.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import dev.eventchain.diagnostics.ContentHash;
import dev.eventchain.diagnostics.Sha256;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Records of the files written to an output folder: for each the hash of its content outside
 * protected areas. A journal line precedes every change, so that the files of a killed run are
 * still recognised as generated.
 */
final class FileRecords {
  private static final String RECORDS = OutputPath.RESERVED + "/files.json";
  private static final String JOURNAL = OutputPath.RESERVED + "/files.journal";
  private static final int PIECE = 1 << 16;
  private static final JsonFactory JSON = new JsonFactory();

  private final OutputStorage storage;
  private final Map<String, String> hashes = new TreeMap<>();
  private final Map<String, Set<String>> journal = new HashMap<>();
  private final boolean damaged;
  private final boolean absent;
  private byte[] stored = {};
  private boolean journalIsCut;

  FileRecords(OutputStorage storage) throws IOException {
    this.storage = storage;
    Optional<byte[]> content = storage.read(RECORDS);
    damaged = content.isPresent() && !parse(content.get());
    stored = content.orElse(stored);
    absent = content.isEmpty() && storage.read(JOURNAL).isEmpty();
    readJournal();
  }

  /** Returns whether there were no records: nothing was written, or the records were removed. */
  boolean absent() {
    return absent;
  }

  /** Returns the fingerprint of the content last written to a file; empty if there is none. */
  String written(String path) {
    return hashes.getOrDefault(path, "");
  }

  /**
   * Returns whether the records of earlier runs were unreadable; then no file counts as generated.
   */
  boolean damaged() {
    return damaged;
  }

  /** Returns the files that earlier runs and this one wrote, sorted. */
  Set<String> files() {
    Set<String> files = new TreeSet<>(hashes.keySet());
    files.addAll(journal.keySet());
    return files;
  }

  /** Returns whether the content of a file was generated, apart from protected areas. */
  boolean isOurs(String path, byte[] content) {
    return isOurs(path, fingerprint(content));
  }

  /** Returns whether a content with this fingerprint was generated. */
  boolean isOurs(String path, String hash) {
    return hash.equals(hashes.get(path)) || journal.getOrDefault(path, Set.of()).contains(hash);
  }

  /** Notes in the journal that a content with this fingerprint is about to be written. */
  void announce(String path, String fingerprint) throws IOException {
    String line = fingerprint + " " + path + "\n";
    storage.append(JOURNAL, (journalIsCut ? "\n" + line : line).getBytes(StandardCharsets.UTF_8));
    journalIsCut = false;
  }

  /** Records a content after it was written. */
  void put(String path, String fingerprint) {
    hashes.put(path, fingerprint);
    journal.remove(path);
  }

  /** Forgets a removed file. */
  void remove(String path) {
    hashes.remove(path);
    journal.remove(path);
  }

  /** Writes the records if they changed, and deletes the journal. */
  void save() throws IOException {
    byte[] content = bytes();
    if (!java.util.Arrays.equals(content, stored)) {
      storage.replace(RECORDS, content);
    }
    storage.delete(JOURNAL);
  }

  private boolean parse(byte[] content) {
    try (JsonParser parser = JSON.createParser(content)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        return false;
      }
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        String path = parser.currentName();
        if (parser.nextToken() != JsonToken.VALUE_STRING) {
          return false;
        }
        if (!OutputPath.of(path).refused()) {
          hashes.put(path, parser.getText());
        }
      }
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private void readJournal() throws IOException {
    String lines = storage.read(JOURNAL).map(b -> new String(b, StandardCharsets.UTF_8)).orElse("");
    // A full disk may have truncated the last line.
    journalIsCut = !lines.isEmpty() && !lines.endsWith("\n");
    lines
        .lines()
        .filter(line -> line.indexOf(' ') == 64)
        .filter(line -> !OutputPath.of(line.substring(65)).refused())
        .forEach(
            line ->
                journal
                    .computeIfAbsent(line.substring(65), path -> new TreeSet<>())
                    .add(line.substring(0, 64)));
  }

  private byte[] bytes() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DefaultPrettyPrinter printer = new DefaultPrettyPrinter();
    printer.indentObjectsWith(new DefaultIndenter("  ", "\n"));
    try (JsonGenerator json = JSON.createGenerator(bytes)) {
      json.setPrettyPrinter(printer);
      json.writeStartObject();
      for (Map.Entry<String, String> entry : hashes.entrySet()) {
        json.writeStringField(entry.getKey(), entry.getValue());
      }
      json.writeEndObject();
      json.writeRaw('\n');
    }
    return bytes.toByteArray();
  }

  /** Returns the fingerprint of a content: a hash of the bytes outside its protected areas. */
  static String fingerprint(byte[] content) {
    return ContentHash.hex(ProtectedAreas.withoutAreas(content));
  }

  /** Returns the fingerprint of a large file, which has no protected areas. */
  static String fingerprint(Path file) throws IOException {
    Sha256 hash = new Sha256();
    try (InputStream input = Files.newInputStream(file)) {
      for (byte[] piece = input.readNBytes(PIECE);
          piece.length > 0;
          piece = input.readNBytes(PIECE)) {
        hash.add(piece);
      }
    }
    return hash.hex();
  }
}
