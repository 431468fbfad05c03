package dev.eventchain.benchmarks;

import dev.eventchain.output.OutputFolder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Times the output step: 10,000 files of 1.1 kB through the guarded folder, written for the first
 * time, changed, and unchanged, beside plain {@code Files.write}. Medians of several rounds in one
 * process; the first rounds are not counted.
 */
public final class OutputBenchmark {

  private static final int FILES = 10_000;
  private static final int SIZE = 1_100;
  private static final int WARM_UP = 3;
  private static final int ROUNDS = 7;

  private final Map<String, double[]> times = new LinkedHashMap<>();
  private int round;

  private OutputBenchmark() {}

  /**
   * Prints milliseconds, and the speed-up over writing with the same guards.
   *
   * @param arguments nothing
   */
  public static void main(String[] arguments) throws IOException {
    new OutputBenchmark().run();
  }

  private void run() throws IOException {
    for (round = -WARM_UP; round < ROUNDS; round++) {
      Path folder = Files.createTempDirectory("output-benchmark");
      try {
        round(folder);
      } finally {
        delete(folder);
      }
    }
    double writing = median(times.get("written for the first time"));
    times.forEach(
        (name, values) ->
            System.out.printf(
                Locale.ROOT,
                "%-32s %9.1f ms %8.2f x%n",
                name,
                median(values),
                writing / median(values)));
  }

  private void round(Path folder) throws IOException {
    SortedMap<String, byte[]> first = files("first");
    SortedMap<String, byte[]> second = files("other");
    Path plain = folder.resolve("plain");
    Path guarded = folder.resolve("guarded");
    timed("by hand, Files.write", () -> writePlainly(plain, first));
    timed("written for the first time", () -> write(guarded, first));
    timed("all changed", () -> write(guarded, second));
    timed("all unchanged", () -> write(guarded, second));
  }

  private interface Work {
    void run() throws IOException;
  }

  private void timed(String name, Work work) throws IOException {
    long start = System.nanoTime();
    work.run();
    double milliseconds = (System.nanoTime() - start) / 1e6;
    if (round >= 0) {
      times.computeIfAbsent(name, n -> new double[ROUNDS])[round] = milliseconds;
    }
  }

  private static void writePlainly(Path folder, SortedMap<String, byte[]> files)
      throws IOException {
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      Path path = folder.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.write(path, file.getValue());
    }
  }

  private static void write(Path folder, SortedMap<String, byte[]> files) {
    try (OutputFolder output = OutputFolder.open(folder)) {
      files.forEach(output::write);
    }
  }

  private static SortedMap<String, byte[]> files(String text) {
    SortedMap<String, byte[]> files = new TreeMap<>();
    for (int i = 0; i < FILES; i++) {
      byte[] content = new byte[SIZE];
      Arrays.fill(content, (byte) '#');
      byte[] start = (text + " " + i + "\n").getBytes(StandardCharsets.UTF_8);
      System.arraycopy(start, 0, content, 0, start.length);
      files.put("package/package/node_" + i + ".py", content);
    }
    return files;
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }
}
