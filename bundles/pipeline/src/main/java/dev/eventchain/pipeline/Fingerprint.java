package dev.eventchain.pipeline;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collection;
import java.util.HexFormat;

/** A hash of everything that a stage reads: values, files, and the program itself. */
final class Fingerprint {

  private final MessageDigest digest;

  Fingerprint() {
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
    program();
  }

  /** Adds a value. */
  Fingerprint add(Object value) {
    byte[] bytes = String.valueOf(value).getBytes(StandardCharsets.UTF_8);
    digest.update(Integer.toString(bytes.length).getBytes(StandardCharsets.US_ASCII));
    digest.update((byte) ':');
    digest.update(bytes);
    return this;
  }

  /** Adds a file's name and content; a missing file is content of its own kind. */
  Fingerprint addFile(Path file) {
    add(file.getFileName());
    try {
      if (!Files.isRegularFile(file)) {
        return add("absent");
      }
      byte[] bytes = Files.readAllBytes(file);
      add(bytes.length);
      digest.update(bytes);
      return this;
    } catch (IOException e) {
      throw Project.unreadable(file, e);
    }
  }

  /** Adds files, which the caller has put into a fixed order. */
  Fingerprint addFiles(Collection<Path> files) {
    add(files.size());
    files.forEach(this::addFile);
    return this;
  }

  /** The hash in hexadecimal. No more can be added. */
  String value() {
    return HexFormat.of().formatHex(digest.digest());
  }

  /** Another build of this program may do another thing with the same files. */
  private void program() {
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      File file = new File(entry);
      add(file.getName());
      if (file.isFile()) {
        add(file.length());
        add(file.lastModified());
      }
    }
  }
}
