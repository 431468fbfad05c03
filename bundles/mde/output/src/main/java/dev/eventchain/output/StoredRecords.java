package dev.eventchain.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The records of an output folder as earlier runs left them. Names that lead out of the folder are
 * passed over.
 *
 * @param content the bytes of the records; empty if there are none
 * @param absent whether there is no journal, either: nothing was written, or both were removed
 * @param hashes the hash of each file's content outside protected areas; where the records are
 *     damaged, those before the damage
 * @param damaged whether the records are unreadable from some place on
 * @param journal the hashes of contents that a killed run was about to write
 * @param journalIsCut whether the last line of the journal has no end
 */
record StoredRecords(
    Optional<byte[]> content,
    boolean absent,
    Map<String, String> hashes,
    boolean damaged,
    Map<String, Set<String>> journal,
    boolean journalIsCut) {

  static final String RECORDS = OutputPath.RESERVED + "/files.json";
  static final String JOURNAL = OutputPath.RESERVED + "/files.journal";

  private static final int HASH_LENGTH = 64;
  private static final JsonFactory JSON = new JsonFactory();

  static StoredRecords of(OutputStorage storage) throws IOException {
    return of(storage.read(RECORDS), storage.read(JOURNAL));
  }

  /** Reads the records below a folder, in which another run may be writing. */
  static StoredRecords below(Path folder) throws IOException {
    return of(read(folder.resolve(RECORDS)), read(folder.resolve(JOURNAL)));
  }

  private static Optional<byte[]> read(Path file) throws IOException {
    try {
      return Optional.of(Files.readAllBytes(file));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    }
  }

  private static StoredRecords of(Optional<byte[]> records, Optional<byte[]> journal) {
    Map<String, String> hashes = new TreeMap<>();
    boolean damaged = records.isPresent() && !parse(records.get(), hashes);
    String lines = journal.map(it -> new String(it, StandardCharsets.UTF_8)).orElse("");
    // A full disk may have truncated the last line.
    boolean isCut = !lines.isEmpty() && !lines.endsWith("\n");
    boolean absent = records.isEmpty() && journal.isEmpty();
    return new StoredRecords(records, absent, hashes, damaged, announced(lines), isCut);
  }

  /** Returns whether the content is readable to its end. */
  private static boolean parse(byte[] content, Map<String, String> hashes) {
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

  private static Map<String, Set<String>> announced(String lines) {
    Map<String, Set<String>> journal = new HashMap<>();
    lines
        .lines()
        .filter(line -> line.indexOf(' ') == HASH_LENGTH)
        .filter(line -> !OutputPath.of(line.substring(HASH_LENGTH + 1)).refused())
        .forEach(
            line ->
                journal
                    .computeIfAbsent(line.substring(HASH_LENGTH + 1), path -> new TreeSet<>())
                    .add(line.substring(0, HASH_LENGTH)));
    return journal;
  }

  /** Returns the files that were written, sorted. */
  Set<String> files() {
    Set<String> files = new TreeSet<>(hashes.keySet());
    files.addAll(journal.keySet());
    return files;
  }
}
