package dev.eventchain.sandbox;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.time.Duration;
import java.time.Instant;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Work folders of processes that ended without deleting them. */
final class AbandonedFolders {

  static final String PREFIX = "eventchain-work-";
  static final String LOCK = "lock";

  /**
   * Beginning of the names of this process's folders, whichever class loader made them: opening and
   * closing their lock files would release the locks.
   */
  static final String OURS = PREFIX + ProcessHandle.current().pid() + "-";

  /**
   * Age from which a folder without a lock is abandoned; a younger one may be about to get its
   * lock.
   */
  private static final Duration BEING_MADE = Duration.ofMinutes(5);

  private static final Set<Path> SWEPT = ConcurrentHashMap.newKeySet();

  private AbandonedFolders() {}

  /** Deletes the abandoned folders below a place; once per place and process. */
  static void sweepOnce(Path place) {
    if (SWEPT.add(place.toAbsolutePath())) {
      sweep(place);
    }
  }

  /** Deletes the abandoned folders below a place; those of this process stay. */
  static void sweep(Path place) {
    try (DirectoryStream<Path> found = Files.newDirectoryStream(place, PREFIX + "*")) {
      UserPrincipal me = Files.getOwner(Path.of("/proc/self"));
      for (Path folder : found) {
        if (!folder.getFileName().toString().startsWith(OURS)
            && Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)
            && Files.getOwner(folder, LinkOption.NOFOLLOW_LINKS).equals(me)) {
          deleteIfAbandoned(folder);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      // A folder that cannot be inspected is not deleted.
    }
  }

  private static void deleteIfAbandoned(Path folder) throws IOException {
    Path lock = folder.resolve(LOCK);
    if (!Files.isRegularFile(lock, LinkOption.NOFOLLOW_LINKS)) {
      Instant changed = Files.getLastModifiedTime(folder, LinkOption.NOFOLLOW_LINKS).toInstant();
      if (changed.isBefore(Instant.now().minus(BEING_MADE))) {
        delete(folder);
      }
      return;
    }
    try (FileChannel channel =
        FileChannel.open(lock, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
      if (channel.tryLock() != null) {
        delete(folder);
      }
    } catch (IOException e) {
      // It was deleted meanwhile, or this file system has no locks.
    }
  }

  /** Deletes a folder and its contents as far as possible; does not follow links. */
  static void delete(Path folder) {
    try {
      Files.walkFileTree(folder, new Deletion());
    } catch (IOException e) {
      // The rest stays until the next sweep.
    }
  }

  private static final class Deletion extends SimpleFileVisitor<Path> {

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      return remove(file);
    }

    /** Called first for a folder that its owner may not list. */
    @Override
    public FileVisitResult visitFileFailed(Path file, IOException problem) throws IOException {
      if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS) && open(file)) {
        Files.walkFileTree(file, this);
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      boolean unused = Files.isWritable(folder) || open(folder);
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path folder, IOException problem) {
      return remove(folder);
    }

    /** Makes a folder writable and listable. Returns whether that changed its permissions. */
    private static boolean open(Path folder) {
      try {
        var all = PosixFilePermissions.fromString("rwx------");
        return !Files.getPosixFilePermissions(folder).equals(all)
            && Files.setPosixFilePermissions(folder, all) != null;
      } catch (IOException e) {
        return false;
      }
    }

    private static FileVisitResult remove(Path path) {
      try {
        Files.deleteIfExists(path);
      } catch (IOException e) {
        // A remaining file keeps its parent folders, which the next sweep finds.
      }
      return FileVisitResult.CONTINUE;
    }
  }
}
