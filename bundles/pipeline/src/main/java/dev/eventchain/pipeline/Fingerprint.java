package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Sha256;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;

/** A hash of everything that a stage reads: values, files, and the program itself. */
final class Fingerprint {

  private final Sha256 digest = new Sha256();

  Fingerprint() {
    program();
  }

  /** Adds a value. */
  Fingerprint add(Object value) {
    byte[] bytes = String.valueOf(value).getBytes(StandardCharsets.UTF_8);
    digest.add(bytes.length + ":").add(bytes);
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
      digest.add(bytes);
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
    return digest.hex();
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
