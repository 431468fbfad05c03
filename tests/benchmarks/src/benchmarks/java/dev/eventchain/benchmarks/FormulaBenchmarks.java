package dev.eventchain.benchmarks;

import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/** Times formulas on a million samples, and prints a comparison with handwritten Java. */
public final class FormulaBenchmarks {

  private FormulaBenchmarks() {}

  /** Prints the table. */
  public static void main(String[] arguments) throws RunnerException {
    Map<String, Map<String, Double>> table = new TreeMap<>();
    for (RunResult result :
        new Runner(new OptionsBuilder().include("FormulaBenchmark").build()).run()) {
      String name = result.getParams().getBenchmark();
      table
          .computeIfAbsent(result.getParams().getParam("judged"), judged -> new TreeMap<>())
          .put(name.substring(name.lastIndexOf('.') + 1), result.getPrimaryResult().getScore());
    }
    System.out.printf("%nms for a million samples%n");
    table.forEach(
        (judged, times) ->
            System.out.printf(
                Locale.ROOT,
                "%-10s eventchain %7.1f   by hand %7.1f   %5.1f times%n",
                judged,
                times.get("eventchain"),
                times.get("javaByHand"),
                times.get("eventchain") / times.get("javaByHand")));
  }
}
