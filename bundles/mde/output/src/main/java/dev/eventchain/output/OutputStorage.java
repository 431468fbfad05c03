package dev.eventchain.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** Storage of an {@link OutputFolder}. Names are normalised {@link OutputPath}s. */
interface OutputStorage {
  /** Returns the content of a file; empty if there is none. */
  Optional<byte[]> read(String path) throws IOException;

  /** Replaces a file atomically: readers see the old content or the new one, never a part. */
  void replace(String path, byte[] content) throws IOException;

  /** Appends to a file, creating it if needed. */
  void append(String path, byte[] content) throws IOException;

  /** Removes a file if it exists, and folders that become empty. */
  void delete(String path) throws IOException;

  /**
   * Returns a folder for files that are too large for byte arrays. It is empty when the storage is
   * opened.
   */
  Path scratch() throws IOException;

  /** Moves a file from {@link #scratch} into place atomically, as {@link #replace} does. */
  void move(Path finished, String path) throws IOException;

  /** Returns the file itself, to be read in pieces; empty if there is none. */
  Optional<Path> find(String path) throws IOException;

  /** Returns the displayed name of a file. */
  String shown(String path);

  /** Closes the storage; then another process may open it. */
  void close() throws IOException;
}
