package dev.eventchain.diagnostics;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32;

/**
 * SHA-256 of the contents of files. A run hashes the same contents at each of its stages, and the
 * Java compiler of short runs has no instructions for SHA-256: in a program that runs project after
 * project, it took a quarter of the time of Java's code. So contents are remembered with their
 * hash, and an equal one is found by its checksum and compared byte for byte.
 */
public final class ContentHash {

  /** Roughly what an entry takes beside its content, so that many small contents count, too. */
  private static final int OVERHEAD = 200;

  private static final ContentHash SHARED = new ContentHash(16 << 20);

  private final long capacity;
  private final Map<Key, Entry> recent = new LinkedHashMap<>(16, 0.75f, true);
  private long size;

  private record Key(int length, long checksum) {}

  private static final class Entry {
    private final byte[] content;
    private final String hash;

    Entry(byte[] content, String hash) {
      this.content = content.clone();
      this.hash = hash;
    }
  }

  /**
   * Creates an empty memory.
   *
   * @param capacity how many bytes are remembered; a content of more than a sixteenth of that is
   *     hashed each time
   */
  ContentHash(long capacity) {
    this.capacity = capacity;
  }

  /** Returns the 64 lower-case hexadecimal digits of a content's hash. */
  public static String hex(byte[] content) {
    return SHARED.of(content);
  }

  synchronized String of(byte[] content) {
    if (content.length > capacity / 16) {
      return new Sha256().add(content).hex();
    }
    CRC32 checksum = new CRC32();
    checksum.update(content);
    Key key = new Key(content.length, checksum.getValue());
    Entry known = recent.get(key);
    if (known != null && Arrays.equals(known.content, content)) {
      return known.hash;
    }
    String hash = new Sha256().add(content).hex();
    remember(key, new Entry(content, hash));
    return hash;
  }

  private void remember(Key key, Entry entry) {
    if (recent.put(key, entry) == null) {
      size += key.length() + OVERHEAD;
    }
    var oldest = recent.keySet().iterator();
    while (size > capacity) {
      size -= oldest.next().length() + OVERHEAD;
      oldest.remove();
    }
  }

  /** Returns roughly how many bytes are remembered. */
  synchronized long size() {
    return size;
  }
}
