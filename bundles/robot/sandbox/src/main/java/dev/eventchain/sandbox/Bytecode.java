package dev.eventchain.sandbox;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * Compiles our own Python sources ahead of time, since a confined process cannot store byte code.
 * This only speeds up the start; failures are ignored.
 */
final class Bytecode {

  private static final Set<Path> SEEN = ConcurrentHashMap.newKeySet();

  private Bytecode() {}

  static void compile(PythonEnvironment environment, Path folder) {
    if (SEEN.add(folder) && Files.isWritable(folder) && isStale(environment, folder)) {
      run(environment, folder);
    }
  }

  private static boolean isStale(PythonEnvironment environment, Path folder) {
    String[] version = environment.version().split("\\.", -1);
    String suffix = ".cpython-" + version[0] + version[1] + ".pyc";
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().endsWith(".py"))
          .anyMatch(file -> isStaleFile(file, suffix));
    } catch (IOException | UncheckedIOException e) {
      return false;
    }
  }

  private static boolean isStaleFile(Path file, String suffix) {
    String name = file.getFileName().toString();
    Path compiled =
        file.resolveSibling("__pycache__").resolve(name.substring(0, name.length() - 3) + suffix);
    try {
      return Files.getLastModifiedTime(compiled).compareTo(Files.getLastModifiedTime(file)) < 0;
    } catch (IOException e) {
      return true;
    }
  }

  private static void run(PythonEnvironment environment, Path folder) {
    ProcessBuilder builder =
        new ProcessBuilder(
            environment.executable().toString(),
            "-I",
            "-m",
            "compileall",
            "-qq",
            folder.toString());
    builder.redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD);
    try {
      builder.start().waitFor();
    } catch (IOException e) {
      return;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
