package dev.eventchain.benchmarks;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.python.PythonEnvironment;
import dev.eventchain.simulation.Bench;
import dev.eventchain.simulation.Measurements;
import dev.eventchain.simulation.NodeManifest;
import dev.eventchain.simulation.Scenario;
import dev.eventchain.simulation.Simulation;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.SimulationResult;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/**
 * How much faster than real time the AEB example is simulated in lock-step, with lidar scans of
 * more than 2,000 points at 20 Hz: generated nodes, real confined processes.
 */
public final class LockstepBenchmark {

  private static final int ROUNDS = 6;

  private LockstepBenchmark() {}

  /**
   * Prints a line for each round; the first rounds of a number of processes warm up.
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
    SimulationRequest request = request(repository, folder);
    PythonEnvironment python = PythonEnvironment.ensure(System.out::println);
    System.out.println("processes  simulated s  wall s  x real time  x real time, one process");
    for (int processes : new int[] {1, 2}) {
      for (int round = 0; round < rounds; round++) {
        SimulationResult result =
            Simulation.run(request.withProcesses(processes), python, verdict -> {});
        print(result.host());
        if (round == rounds - 1) {
          result.measurements().nodes().forEach(LockstepBenchmark::print);
        }
      }
    }
  }

  private static void print(SimulationResult.Host host) {
    System.out.printf(
        Locale.ROOT,
        "%9d  %11.1f  %6.2f  %11.0f  %24.0f%n",
        host.processes(),
        host.simulatedSeconds(),
        host.wallSeconds(),
        host.simulatedSeconds() / host.wallSeconds(),
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

  /**
   * Generates the nodes; the components of the language model are those of the simulation's tests.
   */
  private static SimulationRequest request(Path repository, Path folder) throws IOException {
    Path fixture = repository.resolve("bundles/simulation/src/test/resources/aeb");
    Path example = repository.resolve("examples/aeb");
    XmiStore store = new XmiStore(fixture);
    EventChain chain =
        (EventChain) store.load(fixture.resolve("chain.xmi")).resource().getContents().get(0);
    Path template = repository.resolve("templates/ros2-python/main.mtl");
    Map<String, byte[]> files =
        TemplateModule.compile(template, List.of(EventchainPackage.eINSTANCE))
            .generate(List.of(chain), element -> SourceLocation.NONE)
            .files();
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      Path target = folder.resolve(file.getKey());
      Files.createDirectories(target.getParent());
      Files.write(target, file.getValue());
    }
    copy(fixture.resolve("components"), folder.resolve("aeb/aeb/components"));
    copy(example.resolve("software-base/components"), folder.resolve("aeb/aeb/components"));
    return SimulationRequest.of(
        chain,
        folder.resolve("aeb"),
        NodeManifest.read(SourceText.read(folder.resolve("aeb").resolve(NodeManifest.FILE))),
        List.of(example.resolve("software-base/msg")),
        Bench.carla(),
        Scenario.readFolder(example.resolve("scenarios"), Bench.carla(), warning -> {}));
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.list(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.copy(file, to.resolve(file.getFileName()));
      }
    }
  }
}
