package dev.eventchain.benchmarks;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.eclipse.emf.ecore.EPackage;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The paper's two constraints, which hold, on a model in memory. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class PaperBenchmark {

  /** Number of software nodes in the model; each has two inputs and two outputs. */
  @Param({"1000", "10000", "100000"})
  public int nodes;

  private EventChain chain;
  private OclRules rules;
  private StockRules stock;
  private EpsilonRules epsilon;
  private EpsilonRules epsilonParallel;

  /** Creates the model and parses the rules. */
  @Setup
  public void prepare() throws Exception {
    EPackage.Registry.INSTANCE.put(EventchainPackage.eNS_URI, EventchainPackage.eINSTANCE);
    chain = ChainModels.sound(nodes);
    rules = RuleFiles.ocl("paper.ocl");
    stock = new StockRules("paper.ocl");
    epsilon = new EpsilonRules(chain, false);
    epsilonParallel = new EpsilonRules(chain, true);
  }

  /** Checks all elements with handwritten Java. */
  @Benchmark
  public Object javaByHand() {
    return PaperRules.check(chain);
  }

  /** Checks only the list of nodes with handwritten Java. */
  @Benchmark
  public Object javaOverTheList() {
    return PaperRules.checkNodes(chain);
  }

  /** Checks with this project. */
  @Benchmark
  public Object eventchain() {
    return OclValidator.validate(rules, List.of(chain), element -> SourceLocation.NONE);
  }

  /** Checks with stock Eclipse OCL. */
  @Benchmark
  public Object stockOcl() {
    return stock.check(chain);
  }

  /** Checks with Epsilon's ordinary module. */
  @Benchmark
  public int epsilonEvl() throws Exception {
    return epsilon.check();
  }

  /** Checks with Epsilon's module for several threads. */
  @Benchmark
  public int epsilonEvlParallel() throws Exception {
    return epsilonParallel.check();
  }
}
