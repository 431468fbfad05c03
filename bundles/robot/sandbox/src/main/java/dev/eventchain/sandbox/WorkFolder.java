package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A temporary folder for foreign code, for its owner only, that is deleted with all that is in it.
 *
 * <p>It is in its own folder next to a file that this process keeps locked. A process that is
 * killed cannot delete anything; but its locks end with it, and the first folder that a later
 * process makes deletes those whose locks are gone.
 */
public final class WorkFolder implements AutoCloseable {

  private static final Set<Path> OURS = ConcurrentHashMap.newKeySet();

  private final Path whole;
  private final FileChannel lock;

  private WorkFolder(Path whole, FileChannel lock) {
    this.whole = whole;
    this.lock = lock;
  }

  /**
   * Makes an empty folder below {@code TMPDIR}, or else where Java puts temporary files.
   *
   * @throws DiagnosticException {@code temporary.unwritable} with the reason UNAVAILABLE: that
   *     place is full, missing, or may not be written
   */
  public static WorkFolder create() {
    return create(place(System.getenv()));
  }

  static WorkFolder create(Path place) {
    AbandonedFolders.sweepOnce(place, OURS);
    try {
      Path whole = Files.createTempDirectory(place, AbandonedFolders.PREFIX);
      OURS.add(whole);
      try {
        return fill(whole);
      } catch (IOException e) {
        AbandonedFolders.delete(whole);
        OURS.remove(whole);
        throw e;
      }
    } catch (IOException e) {
      throw unwritable(place, e);
    }
  }

  /** The lock gets its name once it is held: a lock that nobody holds belongs to nobody. */
  private static WorkFolder fill(Path whole) throws IOException {
    Path unnamed = whole.resolve("being-made");
    FileChannel lock =
        FileChannel.open(unnamed, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    try {
      lock.lock();
      WorkFolder folder = new WorkFolder(whole, lock);
      Files.createDirectory(folder.path());
      Files.move(unnamed, whole.resolve(AbandonedFolders.LOCK), StandardCopyOption.ATOMIC_MOVE);
      return folder;
    } catch (IOException e) {
      lock.close();
      throw e;
    }
  }

  static Path place(Map<String, String> settings) {
    String named = settings.getOrDefault("TMPDIR", "");
    String place = named.isEmpty() ? System.getProperty("java.io.tmpdir") : named;
    return Path.of(place).toAbsolutePath().normalize();
  }

  /** The folder; the lock is outside it, so that what is confined to it cannot reach it. */
  public Path path() {
    return whole.resolve("work");
  }

  /** What to say when a file in it cannot be written. */
  public DiagnosticException unwritable(IOException problem) {
    return unwritable(whole.getParent(), problem);
  }

  private static DiagnosticException unwritable(Path place, IOException problem) {
    String message = "The temporary folder cannot be used: " + reason(problem) + ".";
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.error("temporary.unwritable", message, SourceLocation.of(place))
            .withHint(
                "Free some space in it, or name another folder: TMPDIR=/other/folder eventchain."));
  }

  private static String reason(IOException problem) {
    if (problem instanceof AccessDeniedException) {
      return "this user may not write to it";
    }
    if (problem instanceof NoSuchFileException) {
      return "it does not exist";
    }
    if (problem instanceof NotDirectoryException) {
      return "it is not a folder";
    }
    boolean told = problem instanceof FileSystemException file && file.getReason() != null;
    String reason = told ? ((FileSystemException) problem).getReason() : problem.getMessage();
    return reason == null ? "writing failed" : reason;
  }

  /** Deletes it as far as it can be deleted; a later process tries again with the rest. */
  @Override
  public void close() {
    AbandonedFolders.delete(whole);
    try {
      lock.close();
    } catch (IOException e) {
      // The lock ends with this process.
    }
    OURS.remove(whole);
  }
}
