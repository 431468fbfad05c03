package dev.eventchain.benchmarks;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.Simulation;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Measurements;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Measures the real-time factor of the AEB example, simulated in lock-step for two minutes, with
 * lidar scans of about 4,000 and about 2,000 points at 20 Hz: generated nodes, real confined
 * processes.
 */
public final class LockstepBenchmark {

  private static final int ROUNDS = 6;

  private LockstepBenchmark() {}

  /**
   * Prints a line for each round; the first rounds warm up.
   *
   * @param arguments the folder of the repository; then perhaps the number of rounds
   * @throws IOException if a file cannot be read or written
   * @throws InterruptedException if it is interrupted
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    Path repository = Path.of(arguments[0]).normalize();
    Path folder = Files.createTempDirectory("eventchain-benchmark");
    try {
      run(repository, folder, arguments.length > 1 ? Integer.parseInt(arguments[1]) : ROUNDS);
    } finally {
      delete(folder);
    }
  }

  private static void run(Path repository, Path folder, int rounds)
      throws IOException, InterruptedException {
    Path scenarios = repository.resolve("tests/benchmarks").resolve("src/main/resources/lockstep");
    Path project = generate(repository, folder);
    PythonEnvironment python = PythonEnvironment.ensure(System.out::println);
    System.out.println("scenario    processes  simulated s  wall s  x real time, one process");
    for (Scenario scenario : Scenario.readFolder(scenarios, Bench.carla(), warning -> {})) {
      SimulationRequest request = request(project, scenario);
      for (int round = 0; round < rounds; round++) {
        SimulationResult result = Simulation.run(request, python, verdict -> {});
        print(scenario, result.host());
        if (round == rounds - 1) {
          result.measurements().nodes().forEach(LockstepBenchmark::print);
        }
      }
    }
  }

  private static void print(Scenario scenario, SimulationResult.Host host) {
    System.out.printf(
        Locale.ROOT,
        "%-10s  %9d  %11.1f  %6.2f  %24.0f%n",
        scenario.name(),
        host.processes(),
        host.simulatedSeconds(),
        host.wallSeconds(),
        host.realTimeFactor());
  }

  private static void print(Measurements.Node node) {
    node.hostExecutionTime()
        .ifPresent(
            time ->
                System.out.printf(
                    Locale.ROOT,
                    "  %-24s median %6.1f us, 99 %% %6.1f us%n",
                    node.name(),
                    time.median() * 1000,
                    time.percentile99() * 1000));
  }

  /** Generates the nodes of the example, with the components of its recordings. */
  private static Path generate(Path repository, Path folder)
      throws IOException, InterruptedException {
    Path project = folder.resolve("aeb");
    copy(repository.resolve("examples/aeb"), project);
    Process run =
        new ProcessBuilder(
                repository.resolve("eventchain").toString(),
                "run",
                project.toString(),
                "--to",
                "generate")
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    if (run.waitFor() != 0) {
      throw new IllegalStateException("the example's nodes could not be generated");
    }
    return project;
  }

  private static SimulationRequest request(Path project, Scenario scenario) {
    Path out = project.resolve("out");
    Path generated = out.resolve("ros2/aeb");
    return SimulationRequest.of(
        (EventChain)
            EventChainMetamodel.store(out)
                .load(out.resolve("chain.xmi"))
                .resource()
                .getContents()
                .get(0),
        generated,
        NodeManifest.read(SourceText.read(generated.resolve(NodeManifest.FILE))),
        MessageCatalog.of(List.of(project.resolve("software-base/msg"))),
        Bench.carla(),
        List.of(scenario));
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.filter(each -> !each.startsWith(from.resolve("out"))).toList()) {
        Files.copy(file, to.resolve(from.relativize(file).toString()));
      }
    }
  }
}
