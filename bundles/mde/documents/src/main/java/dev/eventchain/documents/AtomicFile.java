package dev.eventchain.documents;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Arrays;
import java.util.Set;
import java.util.UUID;

/**
 * Writes files completely or not at all, and leaves files with the same content untouched. Who may
 * read, write and execute an earlier file stays as it was.
 */
public final class AtomicFile {

  private AtomicFile() {}

  /**
   * Writes a text in UTF-8, and creates the folders above the file.
   *
   * @throws IOException if it cannot be written; an earlier file then stays
   */
  public static void write(Path file, String text) throws IOException {
    write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Writes bytes, and creates the folders above the file.
   *
   * @throws IOException if they cannot be written; an earlier file then stays
   */
  public static void write(Path file, byte[] content) throws IOException {
    if (Files.exists(file) && Arrays.equals(Files.readAllBytes(file), content)) {
      return;
    }
    Files.createDirectories(file.toAbsolutePath().getParent());
    // Not createTempFile: its files are private to their owner, but these are shared.
    Path temporary = file.resolveSibling("." + file.getFileName() + "." + UUID.randomUUID());
    try {
      try (OutputStream out = Files.newOutputStream(temporary, StandardOpenOption.CREATE_NEW)) {
        if (Files.exists(file)) {
          keepPermissions(file, temporary); // before anything of a private file can be read
        }
        out.write(content);
      }
      Files.move(
          temporary, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  /**
   * Nothing is asked of the file store: Java finds none where its mount is not listed, as in
   * chroot.
   */
  private static void keepPermissions(Path file, Path temporary) throws IOException {
    PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
    if (view != null) {
      Set<PosixFilePermission> permissions = view.readAttributes().permissions();
      if (!permissions.equals(Files.getPosixFilePermissions(temporary))) {
        Files.setPosixFilePermissions(temporary, permissions);
      }
    }
  }
}
