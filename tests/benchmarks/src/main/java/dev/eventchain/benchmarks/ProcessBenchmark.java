package dev.eventchain.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Prints how long whole processes of the program take, the launcher included: a first run of the
 * AEB example, a run that finds everything unchanged, and a validation.
 */
public final class ProcessBenchmark {

  private static final int ROUNDS = 7;
  private static final double SECOND = 1e9;

  private final Path root;

  private ProcessBenchmark(Path root) {
    this.root = root;
  }

  /**
   * Prints the figures.
   *
   * @param arguments the project's root folder
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    new ProcessBenchmark(Path.of(arguments[0])).run();
  }

  private void run() throws IOException, InterruptedException {
    Path out = Files.createTempDirectory("eventchain-benchmark");
    try {
      start(out, "run", "-o", out.toString());
      System.out.printf("%-44s %9s %9s%n", "whole process, in s", "median", "fastest");
      measure("run examples/aeb, empty output folder", true, out, "run", "-o", out.toString());
      measure("run examples/aeb, everything unchanged", false, out, "run", "-o", out.toString());
      measure("validate examples/aeb", false, out, "validate", "-o", out.toString());
    } finally {
      empty(out);
      Files.delete(out);
    }
  }

  private void measure(String what, boolean fresh, Path out, String... command)
      throws IOException, InterruptedException {
    double[] seconds = new double[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
      if (fresh) {
        empty(out);
      }
      seconds[i] = start(out, command);
    }
    Arrays.sort(seconds);
    System.out.printf(Locale.ROOT, "%-44s %9.2f %9.2f%n", what, seconds[ROUNDS / 2], seconds[0]);
  }

  private double start(Path out, String... command) throws IOException, InterruptedException {
    List<String> line = new ArrayList<>(List.of("./eventchain", command[0], "examples/aeb"));
    line.addAll(Arrays.asList(command).subList(1, command.length));
    long begin = System.nanoTime();
    Process process =
        new ProcessBuilder(line)
            .directory(root.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    int code = process.waitFor();
    double seconds = (System.nanoTime() - begin) / SECOND;
    if (code != 0) {
      throw new IllegalStateException(line + " ended with " + code + "; output in " + out);
    }
    return seconds;
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
