package dev.eventchain.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** Where an {@link OutputFolder} keeps bytes. Names are normalised {@link OutputPath}s. */
interface OutputStorage {
  /** The content of a file, or nothing when there is none. */
  Optional<byte[]> read(String path) throws IOException;

  /** Puts a file in place atomically: readers see the old content or the new one, never a part. */
  void replace(String path, byte[] content) throws IOException;

  /** Adds to the end of a file, creating it. */
  void append(String path, byte[] content) throws IOException;

  /** Removes a file if it exists, and the folders that this leaves empty. */
  void delete(String path) throws IOException;

  /**
   * A folder for files that are too large to be given as bytes. It is empty when the storage is
   * opened.
   */
  Path scratch() throws IOException;

  /** Puts a file of {@link #scratch} in place atomically, as {@link #replace} does. */
  void move(Path finished, String path) throws IOException;

  /** The file itself, to be read in pieces; nothing when there is none. */
  Optional<Path> find(String path) throws IOException;

  /** The name to show for a file. */
  String shown(String path);

  /** Gives the storage back; another process may open it then. */
  void close() throws IOException;
}
