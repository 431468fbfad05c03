package dev.eventchain.output;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

/** Storage in memory for tests, which edit the map as a user edits files. */
record MemoryStorage(Map<String, byte[]> files) implements OutputStorage {
  @Override
  public Optional<byte[]> read(String path) {
    return Optional.ofNullable(files.get(path)).map(byte[]::clone);
  }

  @Override
  public void replace(String path, byte[] content) {
    files.put(path, content.clone());
  }

  @Override
  public void append(String path, byte[] content) {
    byte[] before = files.getOrDefault(path, new byte[0]);
    byte[] after = java.util.Arrays.copyOf(before, before.length + content.length);
    System.arraycopy(content, 0, after, before.length, content.length);
    files.put(path, after);
  }

  @Override
  public void delete(String path) {
    files.remove(path);
  }

  @Override
  public Path scratch() {
    throw new UnsupportedOperationException("large files are on a disk");
  }

  @Override
  public void move(Path finished, String path) {
    throw new UnsupportedOperationException("large files are on a disk");
  }

  @Override
  public Optional<Path> find(String path) {
    return Optional.empty();
  }

  @Override
  public String shown(String path) {
    return path;
  }

  @Override
  public void close() {}
}
