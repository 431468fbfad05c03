package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Sha256;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URL;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collections;
import java.util.Enumeration;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Stream;

/** Provides Python files in resources as files on disk. */
public final class PythonSources {

  /** Copies of folders in jars, by address: a jar does not change while its classes are in use. */
  private static final Map<String, Path> COPIES = new ConcurrentHashMap<>();

  private PythonSources() {}

  /**
   * Returns a folder of resources on disk, or copies it from its jar, once for each content.
   *
   * @param loader the class loader that finds the folder
   * @param resourceRoot the folder, such as {@code dev/eventchain/sandbox}
   * @return the folder itself when it is on disk; else a copy in the user's cache, without class
   *     files, which must not be changed
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code python.unavailable}: the cache
   *     cannot be written
   * @throws IllegalArgumentException if there is no such folder
   */
  public static Path unpack(ClassLoader loader, String resourceRoot) {
    try {
      for (URL root : Collections.list(loader.getResources(resourceRoot))) {
        Optional<Path> found = unpack(root, resourceRoot);
        if (found.isPresent()) {
          return found.get();
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    throw new IllegalArgumentException("no resource folder with Python files: " + resourceRoot);
  }

  /**
   * Keeps files that Python shall read, once for each content.
   *
   * @param files what is in them, by relative paths
   * @return a folder in the user's cache, which must not be changed
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code python.unavailable}: the cache
   *     cannot be written
   */
  public static Path keep(SortedMap<String, byte[]> files) {
    return copy(files);
  }

  /** Empty if the folder has no Python files, as that of a test's classes in the same package. */
  private static Optional<Path> unpack(URL root, String resourceRoot) throws IOException {
    if (root.getProtocol().equals("file")) {
      Path folder = Path.of(URI.create(root.toString()));
      try (Stream<Path> files = Files.walk(folder)) {
        return files.anyMatch(file -> isPython(file.toString()))
            ? Optional.of(folder)
            : Optional.empty();
      }
    }
    Path known = COPIES.get(root.toString());
    if (known != null && Files.isDirectory(known)) {
      return Optional.of(known);
    }
    var files = contents((JarURLConnection) root.openConnection(), resourceRoot + "/");
    boolean hasPython = files.keySet().stream().anyMatch(PythonSources::isPython);
    Optional<Path> folder = hasPython ? Optional.of(copy(files)) : Optional.empty();
    folder.ifPresent(it -> COPIES.put(root.toString(), it));
    return folder;
  }

  private static boolean isPython(String file) {
    return file.endsWith(".py");
  }

  private static SortedMap<String, byte[]> contents(JarURLConnection connection, String prefix)
      throws IOException {
    connection.setUseCaches(false);
    SortedMap<String, byte[]> files = new TreeMap<>();
    try (JarFile jar = connection.getJarFile()) {
      for (Enumeration<JarEntry> entries = jar.entries(); entries.hasMoreElements(); ) {
        JarEntry entry = entries.nextElement();
        String name = entry.getName();
        if (name.startsWith(prefix) && !entry.isDirectory() && !name.endsWith(".class")) {
          try (InputStream input = jar.getInputStream(entry)) {
            files.put(name.substring(prefix.length()), input.readAllBytes());
          }
        }
      }
    }
    return files;
  }

  private static Path copy(SortedMap<String, byte[]> files) {
    Path cache = CacheFolder.of(System.getenv()).resolve("python-sources");
    Path folder = cache.resolve(key(files));
    if (Files.isDirectory(folder)) {
      return folder;
    }
    try {
      Files.createDirectories(cache);
      Path unfinished = Files.createTempDirectory(cache, "unfinished-");
      for (var file : files.entrySet()) {
        Path target = unfinished.resolve(file.getKey());
        Files.createDirectories(target.getParent());
        Files.write(target, file.getValue());
      }
      move(unfinished, folder);
      return folder;
    } catch (IOException e) {
      throw CacheFolder.unwritable(cache, e);
    }
  }

  /** Moves the folder to its place; a folder that another process put there first is equivalent. */
  private static void move(Path unfinished, Path folder) throws IOException {
    try {
      Files.move(unfinished, folder, StandardCopyOption.ATOMIC_MOVE);
    } catch (FileAlreadyExistsException | java.nio.file.DirectoryNotEmptyException e) {
      delete(unfinished);
    } catch (IOException e) {
      delete(unfinished);
      if (!Files.isDirectory(folder)) {
        throw e;
      }
    }
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> found = Files.walk(folder)) {
      for (Path path : found.sorted(java.util.Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }

  private static String key(SortedMap<String, byte[]> files) {
    Sha256 digest = new Sha256();
    files.forEach((name, bytes) -> digest.add(name + "\0" + bytes.length + "\0").add(bytes));
    return digest.abbreviated();
  }
}
