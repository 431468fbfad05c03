package dev.eventchain.eclipse.install;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A copy of the workbench, for a test to change.
 *
 * @param home the folder of the copy
 * @param scratch the folder for its other output
 */
record Installation(Path home, Path scratch) {

  /** Time limit in seconds for the slowest machines; only ends processes that hang. */
  private static final long LONGEST_SECONDS = 900;

  static Installation copy(Path scratch) throws IOException {
    Path home = scratch.resolve("workbench");
    try (Stream<Path> files = Files.walk(Built.WORKBENCH)) {
      for (Path file : (Iterable<Path>) files::iterator) {
        Files.copy(file, home.resolve(Built.WORKBENCH.relativize(file).toString()));
      }
    }
    return new Installation(home, scratch);
  }

  /** Returns the locations of the installed bundles, by symbolic name. */
  SortedMap<String, Path> bundles() throws IOException {
    SortedMap<String, Path> bundles = new TreeMap<>();
    for (String line : Files.readAllLines(bundlesInfo())) {
      String[] columns = line.split(",", -1);
      if (!line.startsWith("#")) {
        bundles.put(columns[0], Path.of(home.toUri().resolve(URI.create(columns[2]))));
      }
    }
    return bundles;
  }

  /** Adds a bundle that is started with the workbench, without p2. */
  void add(String name, Path jar) throws IOException {
    String line = String.join(",", name, "1.0.0", jar.toUri().toString(), "4", "true\n");
    Files.writeString(bundlesInfo(), line, StandardOpenOption.APPEND);
  }

  /** Installs or removes a feature with p2's director, which has to succeed. */
  void direct(String... arguments) throws IOException, InterruptedException {
    List<String> all =
        new ArrayList<>(List.of("-application", "org.eclipse.equinox.p2.director", "-consoleLog"));
    all.addAll(List.of(arguments));
    Path printed = scratch.resolve("director.txt");
    Process process = start(scratch.resolve("director"), printed, Map.of(), all);
    int code = end(process, printed);
    assertEquals(0, code, () -> all + "\n" + read(printed));
  }

  /** Starts the workbench by its script. */
  Process start(Path workspace, Path printed, Map<String, String> variables, List<String> arguments)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.add(home.resolve("eventchain-workbench").toString());
    command.addAll(List.of("-nosplash", "-data", workspace.toString()));
    command.addAll(arguments);
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    builder.environment().putAll(variables);
    return builder.redirectErrorStream(true).redirectOutput(printed.toFile()).start();
  }

  /** Waits until a process has ended and returns its exit code. */
  static int end(Process process, Path printed) throws InterruptedException {
    if (!process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly().waitFor();
      throw new AssertionError("still running:\n" + read(printed));
    }
    return process.exitValue();
  }

  /** Waits until a process has written a file; fails if it ends before. */
  static void await(Path file, Process process, Path printed) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LONGEST_SECONDS);
    while (!Files.exists(file)) {
      if (!process.isAlive() || System.nanoTime() > end) {
        process.destroyForcibly().waitFor();
        throw new AssertionError("there never was " + file + "\n" + read(printed));
      }
      Thread.sleep(50);
    }
  }

  static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "not readable: " + e;
    }
  }

  private Path bundlesInfo() {
    return home.resolve("configuration/org.eclipse.equinox.simpleconfigurator/bundles.info");
  }
}
