package dev.eventchain.output;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Lock that excludes concurrent runs from an output folder. The operating system releases it when
 * the process ends, so a killed run needs no cleanup. The lock file stays and names the last owner.
 */
final class FolderLock {
  /**
   * Locks of this process. Closing any channel on a file releases the process's POSIX locks on it,
   * so a second attempt must be refused before it opens the file.
   */
  private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

  private final Path file;
  private final FileChannel channel;

  private FolderLock(Path file, FileChannel channel) {
    this.file = file;
    this.channel = channel;
  }

  static FolderLock acquire(Path file) throws IOException {
    if (!HELD.add(file)) {
      throw new HeldException("this process (" + ProcessHandle.current().pid() + ")");
    }
    FileChannel channel = null;
    try {
      channel =
          FileChannel.open(
              file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
      FileLock lock = channel.tryLock();
      if (lock == null) {
        throw new HeldException("process " + ownerIn(file));
      }
      channel.truncate(0);
      channel.write(ByteBuffer.wrap(owner().getBytes(StandardCharsets.UTF_8)));
      return new FolderLock(file, channel);
    } catch (IOException | RuntimeException e) {
      if (channel != null) {
        channel.close();
      }
      HELD.remove(file);
      throw e;
    }
  }

  void release() throws IOException {
    channel.close();
    HELD.remove(file);
  }

  private static String owner() {
    return ProcessHandle.current().pid() + "\n";
  }

  private static String ownerIn(Path file) throws IOException {
    String owner = Files.readString(file).strip();
    return owner.isEmpty() ? "(unknown)" : owner;
  }

  /** Thrown if another run holds the lock; the message names it. */
  static final class HeldException extends IOException {
    private static final long serialVersionUID = 1L;

    HeldException(String owner) {
      super(owner);
    }
  }
}
