package dev.eventchain.benchmarks;

import java.util.Locale;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.util.Statistics;

/** Times the codec, and messages over Cyclone DDS. */
public final class WireBenchmarks {

  private WireBenchmarks() {}

  /** Prints the table. */
  public static void main(String[] arguments) throws RunnerException {
    for (RunResult result :
        new Runner(
                new OptionsBuilder()
                    .include("CodecBenchmark")
                    .include("RoundTripBenchmark")
                    .build())
            .run()) {
      String name = result.getParams().getBenchmark().replaceFirst(".*benchmarks\\.", "");
      Statistics statistics = result.getPrimaryResult().getStatistics();
      System.out.printf(
          Locale.ROOT,
          "%-30s mean %8.2f   p50 %8.2f   p99 %8.2f %s%n",
          name,
          statistics.getMean(),
          statistics.getPercentile(50),
          statistics.getPercentile(99),
          result.getPrimaryResult().getScoreUnit());
    }
  }
}
