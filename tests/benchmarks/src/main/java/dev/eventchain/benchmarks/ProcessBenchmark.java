package dev.eventchain.benchmarks;

import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Prints the durations of whole processes of the program, including the launcher, and their peak
 * resident memory: a first run of the AEB example, a run that finds everything unchanged, a
 * validation, and validations of large files with the paper's constraints.
 */
public final class ProcessBenchmark {

  private static final int ROUNDS = 7;
  private static final int ROUNDS_OF_LARGE_FILES = 3;
  private static final double SECOND = 1e9;
  private static final double MEBIBYTE = 1 << 20;
  private static final Pattern PEAK = Pattern.compile("VmHWM:\\s+(\\d+) kB");
  private static final int[] SIZES = {1_000, 10_000, 50_000, 100_000};

  private record Ended(double seconds, long peakKilobytes, int code) {}

  private final Path root;
  private final int rounds;
  private final int roundsOfLargeFiles;

  private ProcessBenchmark(Path root, int mostRounds) {
    this.root = root;
    this.rounds = Math.min(ROUNDS, mostRounds);
    this.roundsOfLargeFiles = Math.min(ROUNDS_OF_LARGE_FILES, mostRounds);
  }

  /**
   * Prints the figures.
   *
   * @param arguments the project's root folder; then perhaps the most rounds of a command
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    int mostRounds = arguments.length > 1 ? Integer.parseInt(arguments[1]) : ROUNDS;
    new ProcessBenchmark(Path.of(arguments[0]), mostRounds).run();
  }

  private void run() throws IOException, InterruptedException {
    Path out = Files.createTempDirectory("eventchain-benchmark");
    try {
      String[] run = {"run", "examples/aeb", "-o", out.toString()};
      start(run);
      System.out.printf("%-60s %9s %9s %9s%n", "whole process", "median s", "fastest", "peak MiB");
      measure("run examples/aeb, empty output folder", rounds, out, run);
      measure("run examples/aeb, everything unchanged", rounds, null, run);
      run[0] = "validate";
      measure("validate examples/aeb", rounds, null, run);
      for (int nodes : SIZES) {
        measureFile(out, nodes);
      }
    } finally {
      empty(out);
      Files.delete(out);
    }
  }

  private void measureFile(Path out, int nodes) throws IOException, InterruptedException {
    Path rules = Files.writeString(out.resolve("paper.ocl"), RuleFiles.text("paper.ocl"));
    Path model = out.resolve("chain" + nodes + ".xmi");
    Files.write(model, XmiStore.toBytes(ChainModels.sound(nodes)));
    String what =
        String.format(
            Locale.ROOT,
            "validate a file of %d nodes, %d data, %.0f MiB",
            nodes,
            4 * nodes,
            Files.size(model) / MEBIBYTE);
    measure(
        what, roundsOfLargeFiles, null, "validate", "--ocl", rules.toString(), model.toString());
  }

  /** Measures a command, with a folder emptied before each round if given. */
  private void measure(String what, int times, Path fresh, String... command)
      throws IOException, InterruptedException {
    double[] seconds = new double[times];
    long peak = 0;
    int code = 0;
    for (int i = 0; i < times; i++) {
      if (fresh != null) {
        empty(fresh);
      }
      Ended ended = start(command);
      seconds[i] = ended.seconds();
      peak = Math.max(peak, ended.peakKilobytes());
      code = Math.max(code, ended.code());
    }
    Arrays.sort(seconds);
    System.out.printf(
        Locale.ROOT,
        "%-60s %9.2f %9.2f %9d%s%n",
        what,
        seconds[times / 2],
        seconds[0],
        peak >> 10,
        code == 0 ? "" : "  (exit code " + code + ")");
  }

  private Ended start(String... command) throws IOException, InterruptedException {
    List<String> line = new ArrayList<>(List.of("./eventchain"));
    line.addAll(Arrays.asList(command));
    long begin = System.nanoTime();
    Process process =
        new ProcessBuilder(line)
            .directory(root.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    long peak = 0;
    while (!process.waitFor(5, TimeUnit.MILLISECONDS)) {
      peak = Math.max(peak, peakOf(process.pid()));
    }
    double seconds = (System.nanoTime() - begin) / SECOND;
    return new Ended(seconds, peak, process.exitValue());
  }

  /** Returns the peak resident memory so far in kB; the launcher becomes the JVM. */
  private static long peakOf(long pid) {
    try {
      Matcher peak = PEAK.matcher(Files.readString(Path.of("/proc/" + pid + "/status")));
      return peak.find() ? Long.parseLong(peak.group(1)) : 0;
    } catch (IOException e) {
      return 0; // The process has ended meanwhile.
    }
  }

  private static void empty(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        if (!file.equals(folder)) {
          Files.delete(file);
        }
      }
    }
  }
}
