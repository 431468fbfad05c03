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
 * Keeps a second run out of an output folder. The lock dies with its process, so that a killed run
 * never has to be cleaned up after; the lock file itself stays and names the last owner.
 */
final class FolderLock {
  /**
   * Locks of this process. Closing any channel on a file drops the process's POSIX locks on it, so
   * a second attempt must be turned away before it opens the file.
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

  /** Another run holds the lock; the message names it. */
  static final class HeldException extends IOException {
    private static final long serialVersionUID = 1L;

    HeldException(String owner) {
      super(owner);
    }
  }
}
