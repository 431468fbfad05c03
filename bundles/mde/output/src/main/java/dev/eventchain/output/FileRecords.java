package dev.eventchain.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
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
 * What an output folder knows of the files that it wrote: for each a hash of its content outside
 * protected areas. A journal line goes ahead of every change, so that the files of a killed run are
 * still known as ours, whether the change arrived or not.
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

  /** Whether there were no records at all: nothing was written here, or somebody removed them. */
  boolean absent() {
    return absent;
  }

  /** The fingerprint of what a file was given last; empty if we gave it nothing. */
  String written(String path) {
    return hashes.getOrDefault(path, "");
  }

  /** Whether the records of earlier runs could not be read; every file is a stranger then. */
  boolean damaged() {
    return damaged;
  }

  /** The files that earlier runs and this one wrote, sorted. */
  Set<String> files() {
    Set<String> files = new TreeSet<>(hashes.keySet());
    files.addAll(journal.keySet());
    return files;
  }

  /** Whether the content of a file is one that we gave it, apart from protected areas. */
  boolean isOurs(String path, byte[] content) {
    return isOurs(path, fingerprint(content));
  }

  /** As above, of a content of this fingerprint. */
  boolean isOurs(String path, String hash) {
    return hash.equals(hashes.get(path)) || journal.getOrDefault(path, Set.of()).contains(hash);
  }

  /** To be called before a file is given a content of this fingerprint. */
  void announce(String path, String fingerprint) throws IOException {
    String line = fingerprint + " " + path + "\n";
    storage.append(JOURNAL, (journalIsCut ? "\n" + line : line).getBytes(StandardCharsets.UTF_8));
    journalIsCut = false;
  }

  /** To be called when a file holds a content that we gave it. */
  void put(String path, String fingerprint) {
    hashes.put(path, fingerprint);
    journal.remove(path);
  }

  /** To be called when a file is gone. */
  void remove(String path) {
    hashes.remove(path);
    journal.remove(path);
  }

  /** Writes the records if they changed, and drops the journal. */
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
    // A full disk may have ended it in the middle of a line.
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

  /** What the records keep of a content: a hash of what is outside its protected areas. */
  static String fingerprint(byte[] content) {
    return new Sha256().add(ProtectedAreas.withoutAreas(content)).hex();
  }

  /** As above, of a large file, which has no protected areas. */
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
