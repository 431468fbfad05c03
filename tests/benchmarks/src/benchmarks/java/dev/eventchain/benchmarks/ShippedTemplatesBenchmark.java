package dev.eventchain.benchmarks;

import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.model.eventchain.EventChain;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The template set {@code ros2-python} in memory, as users run it. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class ShippedTemplatesBenchmark {

  /** Number of nodes in the chain. */
  @Param({"1000", "10000"})
  public int nodes;

  private EventChain chain;
  private TemplateModule module;

  /** Creates the model and compiles the templates. */
  @Setup
  public void prepare() {
    chain = NodeTemplates.chain(nodes);
    module = TemplateSets.compile("ros2-python");
  }

  /** Generates the files. */
  @Benchmark
  public Object generate() {
    return NodeTemplates.generate(module, chain);
  }

  /** Generates the files with a trace. */
  @Benchmark
  public Object generateWithTrace() {
    return NodeTemplates.trace(module, chain);
  }
}
