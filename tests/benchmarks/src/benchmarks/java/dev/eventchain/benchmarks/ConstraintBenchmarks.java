package dev.eventchain.benchmarks;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * Times constraints on one processor and on all, and prints a comparison of the implementations.
 */
public final class ConstraintBenchmarks {

  private static final String OURS = "eventchain";
  private static final int TWENTY_ON_NODES = 11;

  private ConstraintBenchmarks() {}

  /**
   * Prints the tables.
   *
   * @param arguments nothing, or a pattern of benchmarks to run
   */
  public static void main(String[] arguments) throws RunnerException {
    String pattern = arguments.length == 0 ? "(Paper|Twenty)Benchmark" : arguments[0];
    Map<String, Collection<RunResult>> results = new LinkedHashMap<>();
    results.put("one processor", run(pattern, "-XX:ActiveProcessorCount=1"));
    results.put("all processors", run(pattern));
    results.forEach(ConstraintBenchmarks::print);
  }

  private static Collection<RunResult> run(String pattern, String... more) throws RunnerException {
    Options options =
        new OptionsBuilder()
            .include(pattern)
            .forks(1)
            .warmupIterations(3)
            .warmupTime(TimeValue.seconds(1))
            .measurementIterations(3)
            .measurementTime(TimeValue.seconds(1))
            .jvmArgs("-Xmx2g")
            .jvmArgsAppend(more)
            .build();
    return new Runner(options).run();
  }

  /**
   * Prints a line for each implementation, with a pair of columns for each size: million checks a
   * second, and ratio.
   */
  private static void print(String processors, Collection<RunResult> results) {
    Map<String, Map<Integer, Double>> table = new TreeMap<>();
    for (RunResult result : results) {
      int nodes = Integer.parseInt(result.getParams().getParam("nodes"));
      String[] name = result.getParams().getBenchmark().split("\\.", -1);
      String row = name[name.length - 2] + " " + name[name.length - 1];
      double rate = checks(row, nodes) / result.getPrimaryResult().getScore();
      table.computeIfAbsent(row, r -> new TreeMap<>()).put(nodes, rate);
    }
    Set<Integer> sizes = new TreeSet<>();
    table.values().forEach(row -> sizes.addAll(row.keySet()));
    System.out.printf(
        "%n%s: million checks a second, and how many times ours is faster%n", processors);
    System.out.printf("%-36s", "");
    sizes.forEach(size -> System.out.printf("%12d nodes        ", size));
    System.out.println();
    table.forEach(
        (row, rates) -> {
          System.out.printf("%-36s", row);
          Map<Integer, Double> ours = table.get(row.substring(0, row.indexOf(' ') + 1) + OURS);
          for (int size : sizes) {
            Double rate = rates.get(size);
            if (rate != null) {
              System.out.printf(Locale.ROOT, "%12.3f %8.2f x   ", rate, ours.get(size) / rate);
            }
          }
          System.out.println();
        });
  }

  /** Returns the number of times that a rule is evaluated on an element. */
  private static double checks(String row, int nodes) {
    return row.startsWith("Paper")
        ? 2.0 * nodes
        : 6.0 + TWENTY_ON_NODES * nodes + 2.0 * 4 * nodes + nodes / 10.0;
  }
}
