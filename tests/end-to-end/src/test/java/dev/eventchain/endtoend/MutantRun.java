package dev.eventchain.endtoend;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.ComponentOrigin;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.Simulation;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Simulates an example whose components change from scenario to scenario. A scenario reads them
 * again, so one simulation is enough for many mutants, without generation or process start for
 * each.
 */
final class MutantRun {

  private static final int PROCESSES = 2;

  private final Path folder;
  private final Path generated;
  private final EventChain chain;
  private final Bench bench;
  private final MessageCatalog messages;
  private final List<Scenario> scenarios;

  /** A mutant and the scenario that has to fail it. */
  record Trial(Mutant mutant, Scenario scenario) {

    @Override
    public String toString() {
      return mutant + " in " + scenario.name();
    }
  }

  private MutantRun(Path folder, Path project) throws IOException {
    this.folder = folder;
    Path out = project.resolve("out");
    Path edited = project.resolve("model/chain.xmi");
    Path model = Files.exists(edited) ? edited : out.resolve("chain.xmi");
    this.generated = manifest(out.resolve("ros2")).getParent();
    this.chain =
        (EventChain) EventChainMetamodel.store(project).load(model).resource().getContents().get(0);
    this.messages = MessageCatalog.of(List.of(project.resolve("software-base/msg")));
    this.bench =
        Bench.read(
                Optional.of(project.resolve(ProjectLayout.BENCH)).filter(Files::exists),
                SoftwareBase.read(project.resolve("software-base")).signals().orElse(List.of()),
                messages)
            .withOutputsOf(chain);
    this.scenarios = Scenario.readFolder(project.resolve("scenarios"), bench, warning -> {});
  }

  /** Generates an example in a folder. */
  static MutantRun of(String example, Path folder) throws IOException {
    Path project = folder.resolve(example);
    Projects.copy(Program.ROOT.resolve("examples").resolve(example), project);
    new Program().run("run", project, "--to", "generate").expect(0);
    return new MutantRun(folder, project);
  }

  private static Path manifest(Path ros2) throws IOException {
    try (Stream<Path> files = Files.walk(ros2)) {
      return files.filter(file -> file.endsWith(NodeManifest.FILE)).findFirst().orElseThrow();
    }
  }

  List<Scenario> scenarios() {
    return scenarios;
  }

  Trial trial(Mutant mutant) {
    Optional<Scenario> scenario =
        scenarios.stream().filter(each -> each.name().equals(mutant.scenario())).findFirst();
    return new Trial(mutant, scenario.orElseThrow());
  }

  /** Checks that all mutants can be put into the components, also those that are not simulated. */
  void requireComponentsOf(List<Mutant> mutants) throws IOException {
    Path components = generated.resolve(chain.getName()).resolve("components");
    for (Mutant mutant : mutants) {
      Path copy = Files.createTempDirectory(folder, "components");
      Projects.copy(components, copy);
      mutant.putInto(copy);
    }
  }

  /** Returns the verdicts, in the order of the trials. */
  List<ScenarioVerdict> simulate(List<Trial> trials) throws IOException {
    int processes = Math.min(PROCESSES, trials.size());
    List<CompletableFuture<List<ScenarioVerdict>>> parts = new ArrayList<>();
    for (int i = 0; i < processes; i++) {
      int turn = i;
      List<Trial> part =
          IntStream.range(0, trials.size())
              .filter(index -> index % processes == turn)
              .mapToObj(trials::get)
              .toList();
      Path copy = Files.createTempDirectory(folder, "package");
      Projects.copy(generated, copy);
      parts.add(CompletableFuture.supplyAsync(() -> simulate(part, copy)));
    }
    List<List<ScenarioVerdict>> verdicts = parts.stream().map(CompletableFuture::join).toList();
    return IntStream.range(0, trials.size())
        .mapToObj(index -> verdicts.get(index % processes).get(index / processes))
        .toList();
  }

  /** With one process, a scenario begins when the previous one has been reported. */
  private List<ScenarioVerdict> simulate(List<Trial> trials, Path copy) {
    List<Scenario> wanted = trials.stream().map(Trial::scenario).toList();
    SimulationRequest request =
        SimulationRequest.of(
                chain,
                copy,
                NodeManifest.read(SourceText.read(copy.resolve(NodeManifest.FILE))),
                messages,
                bench,
                wanted)
            .with(settings -> settings.withProcesses(1).withGenerated(written()));
    int[] next = {0};
    change(trials.get(0), copy);
    try {
      return Simulation.run(
              request,
              PythonEnvironment.ensure(line -> {}),
              name -> {
                if (++next[0] < trials.size()) {
                  change(trials.get(next[0]), copy);
                }
              })
          .verdicts();
    } catch (DiagnosticException e) {
      throw new AssertionError(trials.get(next[0]) + " does not run: " + e.diagnostics(), e);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private Set<String> written() {
    return chain.getSoftware().stream()
        .filter(node -> node.getOrigin() == ComponentOrigin.GENERATED)
        .map(SoftwareNode::getName)
        .collect(Collectors.toSet());
  }

  /** Restores the original components in a copy of the package, and applies the trial's changes. */
  private void change(Trial trial, Path copy) {
    Path components = copy.resolve(chain.getName()).resolve("components");
    try (Stream<Path> files =
        Files.list(generated.resolve(chain.getName()).resolve("components"))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Path target = components.resolve(file.getFileName().toString());
        Files.copy(file, target, StandardCopyOption.REPLACE_EXISTING);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    trial.mutant().putInto(components);
  }
}
