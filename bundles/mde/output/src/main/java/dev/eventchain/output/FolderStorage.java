package dev.eventchain.output;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/**
 * Storage of files below a folder. New content is written under {@code .eventchain/} and renamed
 * into place, so that a killed run leaves every file complete. Symbolic links out of the folder are
 * not followed, except those created by others during a run.
 */
final class FolderStorage implements OutputStorage {
  private static final String NEW_FILE = "new-file";
  private static final String LARGE_FILES = "new-files";

  private final Path shownBase;
  private final Path base;
  private final Path records;
  private final FolderLock lock;
  private final Set<Path> checkedFolders = new HashSet<>();

  /** The file last appended to, which stays open. */
  private Path appended;

  private OutputStream appending = OutputStream.nullOutputStream();

  private FolderStorage(Path shownBase, Path base, Path records, FolderLock lock) {
    this.shownBase = shownBase;
    this.base = base;
    this.records = records;
    this.lock = lock;
  }

  static FolderStorage open(Path folder) throws IOException {
    Files.createDirectories(folder);
    Path base = folder.toRealPath();
    Path records = base.resolve(OutputPath.RESERVED);
    refuseLinkLeaving(base, records);
    Files.createDirectories(records);
    FolderLock lock = FolderLock.acquire(records.resolve("lock"));
    try {
      Files.deleteIfExists(records.resolve(NEW_FILE));
      empty(records.resolve(LARGE_FILES));
      return new FolderStorage(folder, base, records, lock);
    } catch (IOException e) {
      lock.release();
      throw e;
    }
  }

  @Override
  public Optional<byte[]> read(String path) throws IOException {
    try {
      return Optional.of(Files.readAllBytes(place(path)));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    }
  }

  @Override
  public void replace(String path, byte[] content) throws IOException {
    Path file = place(path);
    Files.createDirectories(parentOf(file));
    Path fresh = records.resolve(NEW_FILE);
    try {
      Files.write(fresh, content);
      Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      // The incomplete file would only occupy space on a full disk.
      Files.deleteIfExists(fresh);
      throw e;
    }
  }

  /** Deletes the leftovers of a killed run, without following links. */
  private static void empty(Path folder) throws IOException {
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      Files.deleteIfExists(folder);
      return;
    }
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
      for (Path file : files) {
        Files.delete(file);
      }
    }
    Files.delete(folder);
  }

  @Override
  public Path scratch() throws IOException {
    return Files.createDirectories(records.resolve(LARGE_FILES));
  }

  @Override
  public void move(Path finished, String path) throws IOException {
    Path file = place(path);
    Files.createDirectories(parentOf(file));
    Files.move(finished, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  @Override
  public Optional<Path> find(String path) throws IOException {
    return Optional.of(place(path)).filter(Files::isRegularFile);
  }

  @Override
  public void append(String path, byte[] content) throws IOException {
    Path file = place(path);
    if (!file.equals(appended)) {
      stopAppending();
      appending = Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      appended = file;
    }
    appending.write(content);
  }

  private void stopAppending() throws IOException {
    appending.close();
    appending = OutputStream.nullOutputStream();
    appended = null;
  }

  @Override
  public void delete(String path) throws IOException {
    Path file = place(path);
    if (file.equals(appended)) {
      stopAppending();
    }
    Files.deleteIfExists(file);
    for (Path folder = parentOf(file); !folder.equals(base) && isEmpty(folder); ) {
      Files.delete(folder);
      checkedFolders.remove(folder);
      folder = parentOf(folder);
    }
  }

  @Override
  public String shown(String path) {
    return shownBase.resolve(path).normalize().toString();
  }

  @Override
  public void close() throws IOException {
    try {
      stopAppending();
    } finally {
      lock.release();
    }
  }

  private Path place(String path) throws IOException {
    Path file;
    try {
      file = base.resolve(path);
    } catch (InvalidPathException e) {
      throw new FileSystemException(
          path, null, "the name cannot be written in this locale's encoding (set LC_ALL=C.UTF-8)");
    }
    Path folder = base;
    for (Path segment : base.relativize(file)) {
      folder = folder.resolve(segment);
      if (folder.equals(file) || !checkedFolders.contains(folder)) {
        refuseLinkLeaving(base, folder);
        checkedFolders.add(folder);
      }
    }
    return file;
  }

  private static void refuseLinkLeaving(Path base, Path path) throws IOException {
    if (!Files.isSymbolicLink(path)) {
      return;
    }
    boolean inside;
    try {
      inside = path.toRealPath().startsWith(base);
    } catch (IOException e) {
      inside = false;
    }
    if (!inside) {
      throw new LinkLeavesFolderException(path);
    }
  }

  private static boolean isEmpty(Path folder) throws IOException {
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
      return !entries.iterator().hasNext();
    }
  }

  private static Path parentOf(Path file) {
    Path parent = file.getParent();
    return parent == null ? file : parent;
  }

  /** Thrown if a symbolic link below the output folder leads out of it. */
  static final class LinkLeavesFolderException extends FileSystemException {
    private static final long serialVersionUID = 1L;

    LinkLeavesFolderException(Path link) {
      super(link.toString(), null, "is a symbolic link that leaves the output folder");
    }
  }
}
