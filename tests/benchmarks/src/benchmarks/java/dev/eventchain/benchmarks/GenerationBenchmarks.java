package dev.eventchain.benchmarks;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/** Times the template engine, and prints a comparison of the implementations. */
public final class GenerationBenchmarks {

  private static final String OURS = "GenerationBenchmark.eventchain";
  private static final String OWN =
      "(Generation|ShippedTemplates|Compile)Benchmark\\.(?!epsilonEgl)";
  private static final String PEER = "GenerationBenchmark\\.epsilonEgl";

  private GenerationBenchmarks() {}

  /**
   * Prints the table.
   *
   * @param arguments nothing, or a pattern of benchmarks to run
   */
  public static void main(String[] arguments) throws RunnerException {
    List<RunResult> results = new ArrayList<>();
    if (arguments.length > 0) {
      results.addAll(new Runner(averages(arguments[0]).build()).run());
    } else {
      results.addAll(new Runner(averages(OWN).build()).run());
      results.addAll(new Runner(single(PEER, "1000", 3).build()).run());
      results.addAll(new Runner(single(PEER, "10000", 1).build()).run());
    }
    print(results);
  }

  private static ChainedOptionsBuilder averages(String pattern) {
    return new OptionsBuilder()
        .include(pattern)
        .forks(1)
        .warmupIterations(3)
        .warmupTime(TimeValue.seconds(2))
        .measurementIterations(3)
        .measurementTime(TimeValue.seconds(2))
        .jvmArgs("-Xmx2g");
  }

  /**
   * Returns options for benchmarks that take seconds, after the warm-up by the comparison of
   * outputs.
   */
  private static ChainedOptionsBuilder single(String pattern, String nodes, int iterations) {
    return new OptionsBuilder()
        .include(pattern)
        .param("nodes", nodes)
        .mode(Mode.SingleShotTime)
        .forks(1)
        .warmupIterations(0)
        .measurementIterations(iterations)
        .jvmArgs("-Xmx2g");
  }

  private static void print(Collection<RunResult> results) {
    Map<String, Double> times = new TreeMap<>();
    for (RunResult result : results) {
      String[] name = result.getParams().getBenchmark().split("\\.", -1);
      String nodes = result.getParams().getParam("nodes");
      String row = name[name.length - 2] + "." + name[name.length - 1];
      times.put(nodes == null ? row : row + " " + nodes, result.getPrimaryResult().getScore());
    }
    System.out.printf("%n%-50s %10s %s%n", "", "ms", "times ours");
    times.forEach(
        (name, time) -> {
          Double ours = times.get(OURS + name.substring(Math.max(0, name.lastIndexOf(' '))));
          boolean compares = ours != null && name.startsWith("GenerationBenchmark");
          String ratio = compares ? String.format(Locale.ROOT, "%8.3f", time / ours) : "";
          System.out.printf(Locale.ROOT, "%-50s %10.2f %s%n", name, time, ratio);
        });
  }
}
