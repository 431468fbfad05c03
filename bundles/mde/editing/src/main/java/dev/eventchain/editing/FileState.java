package dev.eventchain.editing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Instant;

/**
 * State of a file or folder on the disk, which tells its versions apart without reading it.
 *
 * @param isFile true for a regular file, which can be read to its end
 */
public record FileState(Instant modified, long size, boolean isFile) {

  /** The state of what is not there. */
  public static final FileState MISSING = new FileState(Instant.EPOCH, -1, false);

  /** Returns the present state; {@link #MISSING} also if nothing can be known of it. */
  public static FileState of(Path file) {
    try {
      BasicFileAttributes is = Files.readAttributes(file, BasicFileAttributes.class);
      return new FileState(is.lastModifiedTime().toInstant(), is.size(), is.isRegularFile());
    } catch (IOException e) {
      return MISSING;
    }
  }
}
