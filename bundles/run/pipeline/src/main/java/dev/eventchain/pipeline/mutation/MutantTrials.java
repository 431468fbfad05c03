package dev.eventchain.pipeline.mutation;

import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.design.TestFiles;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.sandbox.WorkFolder;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.VariantSimulation;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.node.Replacements;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.verdict.VariantReaction;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Trials of mutants: each by the tests of its component, and then by the scenarios, until something
 * notices it. Copies of the components as they are take the same way first, and must pass.
 */
final class MutantTrials implements AutoCloseable {

  /** A mutant may loop; the component as it is needs far less for a call. */
  private static final NodeLimits LIMITS =
      new NodeLimits(Duration.ofSeconds(2), Duration.ofMinutes(1), Duration.ofHours(100));

  private final RunContext run;
  private final PythonEnvironment python;
  private final Consumer<MutantResult> ended;
  private final int processes = Runtime.getRuntime().availableProcessors();
  private final WorkFolder folder = WorkFolder.create();
  private final Map<String, ComponentTester> tests = new TreeMap<>();
  private final Map<String, Path> originals = new LinkedHashMap<>();
  private final ImportedModules modules;
  private final OriginalTests original = new OriginalTests(this::test);
  private final List<Diagnostic> ends = new ArrayList<>();
  private int copies;

  /**
   * Prepares trials.
   *
   * @param ended receives each result, one at a time, in an order that depends on the machine
   */
  MutantTrials(RunContext run, Consumer<MutantResult> ended) {
    this.run = run;
    this.python = run.python(Stage.SIMULATE);
    this.ended = ended;
    this.modules = ProjectMutants.modules(run);
    TestFiles files =
        new TestFiles(run, SourceText.read(run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN)));
    List<SoftwareNode> components = new ArrayList<>(ProjectMutants.nodes(run));
    components.removeAll(ProjectMutants.hosted(run));
    for (SoftwareNode node : components) {
      if (TestFiles.hasTests(run, node.getName())) {
        tests.put(node.getName(), files.standing(node.getName()));
      }
    }
  }

  /**
   * Tries mutants.
   *
   * @throws DiagnosticException FINDINGS, {@code mutation.unproved}: the components as they are do
   *     not pass
   * @throws InterruptedException if the calling thread was interrupted
   */
  void tryAll(List<Mutant> mutants) throws InterruptedException {
    List<Replacements> same = new ArrayList<>();
    for (SoftwareNode node : ProjectMutants.nodes(run)) {
      Path file = ComponentFiles.of(run, node);
      Path copy = copy(file, SourceText.read(file).text());
      originals.put(node.getName(), copy);
      same.add(Replacements.of(node.getName(), copy));
    }
    List<Mutant> left = untested(mutants);
    List<Replacements> variants = left.stream().map(this::variant).toList();
    if (variants.isEmpty()) {
      return;
    }
    SimulationRequest request =
        SimulateStage.request(run)
            // A mutant need not follow the rules for generated code, which the component does.
            .with(it -> it.withGenerated(Set.of()).withLimits(LIMITS).withProcesses(processes));
    VariantSimulation.Original found =
        new VariantSimulation(request, python, folder.path())
            .run(same, variants, (number, each) -> ended.accept(result(left.get(number), each)));
    if (!found.failed().isEmpty()) {
      throw TestFailure.withoutDefect(found.failed().get(0));
    }
    found.ended().forEach(each -> ends.add(SurvivorFindings.ofOriginal(each)));
  }

  /** Returns the findings that processes end without a defect, so that something tells nothing. */
  List<Diagnostic> ends() {
    List<Diagnostic> all = new ArrayList<>(original.ends());
    all.addAll(ends);
    return all;
  }

  private Replacements variant(Mutant mutant) {
    if (mutant.kind() != Mutant.Kind.MODULE) {
      return Replacements.of(mutant.component(), copy(mutant.file(), mutant.text()));
    }
    Path alone = write(ownFolder(), mutant.file(), mutant.text());
    Map<String, Path> folders = new TreeMap<>();
    for (SoftwareBase.Component user : modules.users(mutant.file())) {
      if (user.node().isEmpty()) {
        folders.put(user.name(), alone.getParent());
      }
    }
    Map<String, Path> copied = new TreeMap<>();
    modules.copy(mutant.file()).ifPresent(copy -> copied.put(copy, alone));
    return new Replacements(Map.of(), folders, copied);
  }

  /** Returns the mutants that pass the tests of their components, or have none. */
  private List<Mutant> untested(List<Mutant> mutants) throws InterruptedException {
    testOriginals(mutants);
    List<Mutant> left = new ArrayList<>();
    ExecutorService workers = Executors.newFixedThreadPool(processes);
    try {
      Map<Mutant, Future<Optional<TestFailure>>> begun = new LinkedHashMap<>();
      for (Mutant mutant : mutants) {
        begun.put(mutant, workers.submit(() -> test(mutant)));
      }
      for (var each : begun.entrySet()) {
        Optional<TestFailure> failed = each.getValue().get();
        failed.ifPresent(failure -> ended.accept(failed(each.getKey(), failure)));
        if (failed.isEmpty()) {
          left.add(each.getKey());
        }
      }
    } catch (ExecutionException e) {
      throw e.getCause() instanceof RuntimeException known
          ? known
          : new IllegalStateException(e.getCause());
    } finally {
      workers.shutdownNow();
    }
    return left;
  }

  /** Runs the tests of the components that run one of some mutants, without a defect. */
  private void testOriginals(List<Mutant> mutants) {
    for (SoftwareNode node : ProjectMutants.nodes(run)) {
      String name = node.getName();
      if (mutants.stream().anyMatch(mutant -> mutant.users().contains(name))) {
        SourceLocation place = SourceLocation.of(ComponentFiles.of(run, node));
        original.run(name, originals.get(name), place);
      }
    }
  }

  /** Runs the tests of the components that run a mutant, until one fails. */
  private Optional<TestFailure> test(Mutant mutant) {
    for (String user : mutant.users()) {
      if (tests.containsKey(user) && original.tells(user)) {
        Optional<TestFailure> failure = test(user, mutated(user, mutant));
        if (failure.isPresent()) {
          return failure;
        }
      }
    }
    return Optional.empty();
  }

  /** Returns the file of a component with a mutant, in a folder with all that is beside it. */
  private Path mutated(String component, Mutant mutant) {
    if (mutant.kind() != Mutant.Kind.MODULE) {
      return copy(mutant.file(), mutant.text());
    }
    Path original = run.softwareBase().find(component).orElseThrow().file();
    Path copy = copy(original, SourceText.read(original).text());
    write(copy.getParent(), mutant.file(), mutant.text());
    return copy;
  }

  private Optional<TestFailure> test(String component, Path file) {
    if (!tests.containsKey(component)) {
      return Optional.empty();
    }
    ComponentTester.Trial trial =
        tests.get(component).trial(new ComponentProbe(python).ofExisting(), file);
    return trial.findings().stream()
        .filter(finding -> finding.severity() == Severity.ERROR)
        .findFirst()
        .map(finding -> new TestFailure(component, finding, trial.ended()));
  }

  private MutantResult failed(Mutant mutant, TestFailure failure) {
    boolean proved = !failure.ended() || failsAgain(mutant, failure);
    return MutantResult.of(
        mutant,
        proved ? MutantResult.Outcome.TEST : MutantResult.Outcome.UNPROVED,
        Optional.empty(),
        Optional.of(failure.finding().message()),
        Optional.empty());
  }

  private boolean failsAgain(Mutant mutant, TestFailure failure) {
    String component = failure.component();
    return failure.comesAgain(
        VariantSimulation.REPETITIONS,
        () -> test(component, originals.get(component)),
        () -> test(mutant));
  }

  private MutantResult result(Mutant mutant, VariantReaction reaction) {
    Optional<String> untold = original.untold(mutant.users());
    if (untold.isPresent() && !reaction.kind().isNoticed()) {
      return MutantResult.of(
          mutant, MutantResult.Outcome.UNPROVED, Optional.empty(), untold, Optional.empty());
    }
    MutantResult.Outcome outcome =
        switch (reaction.kind()) {
          case CRITERION -> MutantResult.Outcome.CRITERION;
          case UNTESTED -> MutantResult.Outcome.UNTESTED;
          case RAISED -> MutantResult.Outcome.RAISED;
          case ENDED -> MutantResult.Outcome.ENDED;
          case UNPROVED -> MutantResult.Outcome.UNPROVED;
          case UNNOTICED -> MutantResult.Outcome.UNNOTICED;
          case UNCHANGED -> MutantResult.Outcome.UNCHANGED;
        };
    return MutantResult.of(
        mutant,
        outcome,
        Optional.of(reaction.scenario()).filter(text -> !text.isEmpty()),
        Optional.of(reaction.words()).filter(text -> !text.isEmpty()),
        reaction.margin().map(MutantTrials::words));
  }

  private static String words(Margin margin) {
    String unit = margin.unit().equals("1") ? "" : " " + margin.unit();
    return String.format(Locale.ROOT, "%.3g%s", margin.value(), unit);
  }

  /** Writes a version of a component into a folder of its own, with the modules next to it. */
  private Path copy(Path file, String text) {
    Path own = ownFolder();
    try {
      try (Stream<Path> beside = Files.list(file.toAbsolutePath().getParent())) {
        for (Path module : beside.filter(each -> each.toString().endsWith(".py")).toList()) {
          Files.copy(module, own.resolve(module.getFileName()));
        }
      }
      return Files.writeString(own.resolve(file.getFileName()), text);
    } catch (IOException e) {
      throw folder.unwritable(e);
    }
  }

  /** Writes the text of a module into a folder; it may be there already, without the defect. */
  private Path write(Path into, Path file, String text) {
    try {
      return Files.writeString(into.resolve(file.getFileName()), text);
    } catch (IOException e) {
      throw folder.unwritable(e);
    }
  }

  private Path ownFolder() {
    try {
      return Files.createDirectory(folder.path().resolve("copy-" + nextCopy()));
    } catch (IOException e) {
      throw folder.unwritable(e);
    }
  }

  private synchronized int nextCopy() {
    return ++copies;
  }

  @Override
  public void close() {
    folder.close();
  }
}
