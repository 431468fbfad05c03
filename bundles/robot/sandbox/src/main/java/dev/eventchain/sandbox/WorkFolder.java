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

/**
 * A temporary folder for untrusted code, accessible to its owner only, that is deleted with its
 * contents.
 *
 * <p>Its parent folder also holds a file that this process keeps locked. A killed process cannot
 * delete its folders, but its locks are released. A later process deletes folders without locks
 * when it creates its first one.
 */
public final class WorkFolder implements AutoCloseable {

  private final Path whole;
  private final FileChannel lock;

  private WorkFolder(Path whole, FileChannel lock) {
    this.whole = whole;
    this.lock = lock;
  }

  /**
   * Creates an empty folder below {@code TMPDIR}, or else in Java's folder for temporary files.
   *
   * @throws DiagnosticException {@code temporary.unwritable} with the reason UNAVAILABLE: that
   *     place is full, missing, or may not be written
   */
  public static WorkFolder create() {
    return create(place(System.getenv()));
  }

  static WorkFolder create(Path place) {
    AbandonedFolders.sweepOnce(place);
    try {
      Path whole = Files.createTempDirectory(place, AbandonedFolders.OURS);
      try {
        return fill(whole);
      } catch (IOException e) {
        AbandonedFolders.delete(whole);
        throw e;
      }
    } catch (IOException e) {
      throw unwritable(place, e);
    }
  }

  /** The lock file is named only after it is locked: an unlocked one has no owner. */
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

  /** Returns the folder; the lock is outside, out of reach of code confined to the folder. */
  public Path path() {
    return whole.resolve("work");
  }

  /** Returns the finding for a file in it that cannot be written. */
  public DiagnosticException unwritable(IOException problem) {
    return unwritable(whole.getParent(), problem);
  }

  private static DiagnosticException unwritable(Path place, IOException problem) {
    String message = "The temporary folder cannot be used: " + reason(problem) + ".";
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.of(PythonRules.TEMPORARY_UNWRITABLE, message, SourceLocation.of(place))
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

  /** Deletes it as far as possible; a later process deletes the rest. */
  @Override
  public void close() {
    AbandonedFolders.delete(whole);
    try {
      lock.close();
    } catch (IOException e) {
      // The lock is released with this process.
    }
  }
}
