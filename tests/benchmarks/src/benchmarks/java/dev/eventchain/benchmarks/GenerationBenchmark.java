package dev.eventchain.benchmarks;

import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.model.eventchain.EventChain;
import java.util.SortedMap;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.infra.BenchmarkParams;

/** The paper's nodes, generated in memory: a file of about 1.1 kB for each node. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class GenerationBenchmark {

  /** Number of files. */
  @Param({"1000", "10000"})
  public int nodes;

  private EventChain chain;
  private TemplateModule module;
  private EpsilonTemplate epsilon;

  /** Creates the model, compiles the templates, and rejects different outputs. */
  @Setup
  public void prepare(BenchmarkParams benchmark) throws Exception {
    chain = NodeTemplates.chain(nodes);
    module = NodeTemplates.compile();
    epsilon = new EpsilonTemplate(chain);
    SortedMap<String, byte[]> byHand = NodeFiles.of(chain);
    require("eventchain", NodeTemplates.generate(module, chain).files(), byHand);
    if (benchmark.getBenchmark().endsWith(".epsilonEgl")) {
      require("epsilonEgl", epsilon.files(), byHand);
    }
  }

  private static void require(
      String name, SortedMap<String, byte[]> files, SortedMap<String, byte[]> byHand) {
    NodeTemplates.difference(files, byHand)
        .ifPresent(
            file -> {
              throw new IllegalStateException(name + " differs in " + file);
            });
  }

  /** Generates with handwritten Java. */
  @Benchmark
  public Object javaByHand() {
    return NodeFiles.of(chain);
  }

  /** Generates with this project. */
  @Benchmark
  public Object eventchain() {
    return NodeTemplates.generate(module, chain);
  }

  /** Generates with Epsilon EGL. */
  @Benchmark
  public Object epsilonEgl() throws Exception {
    return epsilon.files();
  }
}
