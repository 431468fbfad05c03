package dev.eventchain.benchmarks;

import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/** Times the template engine, and prints how the ways compare. */
public final class GenerationBenchmarks {

  private static final String OURS = "GenerationBenchmark.eventchain";

  private GenerationBenchmarks() {}

  /**
   * Prints the table.
   *
   * @param arguments nothing, or a pattern of benchmarks to run
   */
  public static void main(String[] arguments) throws RunnerException {
    String pattern =
        arguments.length == 0
            ? "(Generation|ShippedTemplates|Compile)Benchmark\\."
            : arguments[0];
    Options options =
        new OptionsBuilder()
            .include(pattern)
            .forks(1)
            .warmupIterations(5)
            .warmupTime(TimeValue.seconds(2))
            .measurementIterations(5)
            .measurementTime(TimeValue.seconds(2))
            .jvmArgs("-Xmx2g")
            .build();
    print(new Runner(options).run());
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
