package dev.eventchain.m2t;

import java.io.IOException;
import java.util.Optional;

/** Where an {@link OutputFolder} keeps bytes. Names are normalised {@link OutputPath}s. */
interface OutputStorage {
  /** The content of a file, or nothing when there is none. */
  Optional<byte[]> read(String path) throws IOException;

  /** Puts a file in place at once: readers see the old content or the new one, never a part. */
  void replace(String path, byte[] content) throws IOException;

  /** Adds to the end of a file, creating it. */
  void append(String path, byte[] content) throws IOException;

  /** Removes a file if it exists, and the folders that this leaves empty. */
  void delete(String path) throws IOException;

  /** The name to show for a file. */
  String shown(String path);

  /** Gives the storage back; another process may open it then. */
  void close() throws IOException;
}
