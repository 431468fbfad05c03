package dev.eventchain.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
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
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Records of the files written to an output folder: for each the hash of its content outside
 * protected areas. A journal line precedes every change, so that the files of a killed run are
 * still recognised as generated.
 */
final class FileRecords {
  private static final int PIECE = 1 << 16;
  private static final JsonFactory JSON = new JsonFactory();

  private final OutputStorage storage;
  private final StoredRecords former;
  private final Map<String, String> hashes;
  private final Map<String, Set<String>> journal;
  private boolean journalIsCut;

  FileRecords(OutputStorage storage) throws IOException {
    this.storage = storage;
    former = StoredRecords.of(storage);
    hashes = new TreeMap<>(former.hashes());
    journal = new HashMap<>(former.journal());
    journalIsCut = former.journalIsCut();
  }

  /** Returns whether there were no records: nothing was written, or the records were removed. */
  boolean absent() {
    return former.absent();
  }

  /** Returns the fingerprint of the content last written to a file; empty if there is none. */
  String written(String path) {
    return hashes.getOrDefault(path, "");
  }

  /**
   * Returns whether the records of earlier runs were unreadable; then only files that were recorded
   * before the damage count as generated.
   */
  boolean damaged() {
    return former.damaged();
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
    storage.append(
        StoredRecords.JOURNAL,
        (journalIsCut ? "\n" + line : line).getBytes(StandardCharsets.UTF_8));
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
    if (former.content().filter(it -> Arrays.equals(content, it)).isEmpty()) {
      storage.replace(StoredRecords.RECORDS, content);
    }
    storage.delete(StoredRecords.JOURNAL);
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
