package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.design.TestFiles;
import dev.eventchain.pipeline.engine.PipelineRun;
import dev.eventchain.pipeline.generate.HostedNodes;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.sandbox.ComponentMutator;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * Mutation testing of a project: small defects are made in its components, one at a time, and the
 * tests of the component and the scenarios should notice each.
 */
public final class MutationTesting {

  /** Results after which they are written, so that an interrupted command can continue. */
  private static final int KEPT_TOGETHER = 5;

  private final RunContext run;
  private final MutationOptions options;
  private final AcceptedMutants accepted;
  private final Map<String, MutantResult> results = new LinkedHashMap<>();
  private final List<Diagnostic> ends = new ArrayList<>();
  private String inputs = "";
  private int tried;

  private MutationTesting(RunContext run, MutationOptions options, AcceptedMutants accepted) {
    this.run = run;
    this.options = options;
    this.accepted = accepted;
  }

  /**
   * Runs a project to its verdict, as far as something has changed, and then tries the mutants of
   * its components. Results with the same inputs are not obtained again.
   *
   * @param settings options of the run, for all stages in lock-step
   * @throws DiagnosticException for failures caused by the project or this machine
   */
  public static MutationOutcome run(
      Project project, RunOptions settings, MutationOptions options, Progress progress) {
    AcceptedMutants accepted = AcceptedMutants.of(project);
    RunResult verdict = PipelineRun.run(project, settings, progress, Optional.empty()).result();
    if (verdict.verdict() != RunResult.Verdict.PASSED) {
      Outcome unproved = Outcome.of(Coverage.NONE, List.of(unproved(project, settings)), List.of());
      return new MutationOutcome(Outcome.of(verdict).and(unproved), "");
    }
    try (OutputFolder output = OutputFolder.open(settings.output())) {
      RunContext run = new RunContext(project, settings, output, progress, Optional.empty());
      return new MutationTesting(run, options, accepted).run();
    }
  }

  private static Diagnostic unproved(Project project, RunOptions settings) {
    return Diagnostic.of(
            MutationRules.MUTATION_UNPROVED,
            "No mutant was tried, since the project itself has not passed.",
            SourceLocation.of(project.folder()))
        .withHint("Run '" + project.command(settings.output(), "") + "' until it passes.");
  }

  private MutationOutcome run() {
    long start = System.nanoTime();
    requireComponents();
    run.progress().step(Stage.SIMULATE, "listing mutants");
    List<Mutant> all = ProjectMutants.of(run, new ComponentMutator(run.python(Stage.SIMULATE)));
    inputs = inputs();
    List<MutantResult> earlier = MutantsFile.recall(run, inputs);
    all.forEach(mutant -> results.put(key(mutant), MutantResult.notTried(mutant)));
    earlier.forEach(each -> results.replace(key(each), each));
    List<Mutant> chosen = all.stream().filter(chosen()).toList();
    List<Mutant> open = chosen.stream().filter(this::isNotTried).toList();
    tryAll(open, chosen.size() - open.size());
    MutationOutcome outcome = outcome(all, chosen);
    Duration duration = Duration.ofNanos(System.nanoTime() - start);
    run.progress()
        .ended(
            Stage.SIMULATE,
            open.isEmpty() ? Progress.Status.UNCHANGED : Progress.Status.DONE,
            duration,
            Coverage.counted(chosen.size(), "mutant")
                + " in "
                + run.file(ProjectLayout.MUTANT_RESULTS));
    return outcome;
  }

  private void requireComponents() {
    List<String> known = ProjectMutants.nodes(run).stream().map(SoftwareNode::getName).toList();
    List<Diagnostic> unknown =
        options.components().stream()
            .filter(name -> !known.contains(name))
            .map(name -> unknown(name, known))
            .toList();
    if (!unknown.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, unknown);
    }
  }

  private Diagnostic unknown(String name, List<String> known) {
    return Diagnostic.of(
            MutationRules.MUTATION_NONE,
            "The chain executes no component '" + name + "'.",
            SourceLocation.of(run.model()))
        .withHint(NearestName.hint(name, known));
  }

  private Predicate<Mutant> chosen() {
    Optional<ChangedLines> changed =
        options.since().map(revision -> new ChangedLines(run.project(), revision));
    return mutant ->
        mutant.users().stream().anyMatch(this::isChosen)
            && changed.map(lines -> lines.hold(mutant)).orElse(true);
  }

  private boolean isChosen(String component) {
    return options.components().isEmpty() || options.components().contains(component);
  }

  /** Returns a hash of all that a result depends on: what a simulation does, and the tests. */
  private String inputs() {
    Fingerprint fingerprint = new Fingerprint(run);
    new SimulateStage().fingerprint(run, fingerprint);
    fingerprint.addFiles(TestFiles.all(run));
    for (SoftwareNode node : ProjectMutants.nodes(run)) {
      Path folder = ComponentFiles.of(run, node).toAbsolutePath().getParent();
      fingerprint.add(node.getName()).addFiles(Project.existingBelow(folder));
    }
    fingerprint.addFiles(HostedNodes.copies(run).values());
    return fingerprint.value();
  }

  private void tryAll(List<Mutant> open, int known) {
    if (open.isEmpty()) {
      write();
      return;
    }
    int all = open.size() + known;
    try (MutantTrials trials = new MutantTrials(run, result -> ended(result, known, all))) {
      trials.tryAll(open);
      ends.addAll(trials.ends());
      if (open.stream().anyMatch(this::isNotTried)) {
        throw new IllegalStateException("a mutant was not tried");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("nobody interrupts mutation testing", e);
    } finally {
      write();
    }
  }

  private void ended(MutantResult result, int known, int all) {
    results.put(key(result), result);
    tried++;
    if (tried % KEPT_TOGETHER == 0) {
      write();
    }
    run.progress()
        .step(
            Stage.SIMULATE,
            String.format(
                Locale.ROOT, "mutant %d of %d: %s", known + tried, all, result.component()));
  }

  private void write() {
    new MutantsFile(run.chain().chain().getName(), inputs, List.copyOf(results.values()))
        .write(run);
  }

  private MutationOutcome outcome(List<Mutant> all, List<Mutant> chosen) {
    List<Diagnostic> found = new ArrayList<>(run.takeFindings());
    found.addAll(ends);
    for (Mutant mutant : chosen) {
      MutantResult result = result(mutant);
      if (result.survives() && accepted.find(result, options.today()).isEmpty()) {
        found.add(SurvivorFindings.of(mutant, result));
      }
      if (result.outcome() == MutantResult.Outcome.UNPROVED) {
        found.add(SurvivorFindings.unproved(mutant, result));
      }
    }
    found.addAll(leftOut(all));
    if (chosen.isEmpty()) {
      found.add(none());
    }
    found.addAll(accepted.warnings(List.copyOf(results.values()), options.today()));
    Suppressions.Parted parted = run.options().suppressions().part(found);
    Predicate<MutantResult> explained = each -> accepted.find(each, options.today()).isPresent();
    String table =
        chosen.isEmpty()
            ? ""
            : MutationTable.of(chosen.stream().map(this::result).toList(), explained);
    return new MutationOutcome(
        Outcome.of(Coverage.NONE, parted.remaining(), parted.suppressed()), table);
  }

  /** Returns the findings about code that the chosen components run, and that has no mutants. */
  private List<Diagnostic> leftOut(List<Mutant> all) {
    Set<Path> mutated = all.stream().map(Mutant::file).collect(Collectors.toSet());
    Set<String> users =
        all.stream().flatMap(each -> each.users().stream()).collect(Collectors.toSet());
    List<Diagnostic> found = new ArrayList<>();
    ProjectMutants.hosted(run).stream()
        .filter(node -> isChosen(node.getName()) && !users.contains(node.getName()))
        .filter(node -> !mutated.contains(ComponentFiles.of(run, node)))
        .forEach(node -> found.add(leftOut(node)));
    ImportedModules modules = ProjectMutants.modules(run);
    for (Path file : modules.files()) {
      boolean chosen = modules.users(file).stream().anyMatch(user -> isChosen(user.name()));
      if (chosen && !mutated.contains(file) && !SourceText.read(file).text().isBlank()) {
        found.add(leftOut(file));
      }
    }
    return found;
  }

  private static Diagnostic leftOut(Path module) {
    return Diagnostic.of(
            MutationRules.MUTATION_LEFT_OUT,
            "No mutants were made of this module, which components import: what these name in it"
                + " holds nothing that could have a small defect.",
            SourceLocation.of(module))
        .withSeverity(Severity.WARNING)
        .withHint("Test the module by itself, if it decides something.");
  }

  private Diagnostic leftOut(SoftwareNode node) {
    return Diagnostic.of(
            MutationRules.MUTATION_LEFT_OUT,
            "No mutants were made of '"
                + node.getName()
                + "', whose file and modules hold nothing that could have a small defect: nobody"
                + " knows which of its defects would be noticed.",
            SourceLocation.of(ComponentFiles.of(run, node)).withElement(node.getName()))
        .withHint("Name the file in which it calculates, or move that into this one.");
  }

  /** Returns the finding that nothing was tried, which a change elsewhere may be the reason for. */
  private Diagnostic none() {
    SourceLocation place = SourceLocation.of(run.project().folder());
    if (options.since().isPresent()) {
      String message =
          "No mutant is in a line that has changed since " + options.since().get() + ".";
      return Diagnostic.of(MutationRules.MUTATION_NONE, message, place)
          .withSeverity(Severity.WARNING)
          .withHint("Leave out --since to try the mutants of all lines.");
    }
    return Diagnostic.of(
            MutationRules.MUTATION_NONE,
            "There is no mutant of these components, so nothing is known about their tests.",
            place)
        .withHint("Try all components, or those that calculate and decide something.");
  }

  private boolean isNotTried(Mutant mutant) {
    return result(mutant).outcome() == MutantResult.Outcome.NOT_TRIED;
  }

  private MutantResult result(Mutant mutant) {
    return results.get(key(mutant));
  }

  private static String key(Mutant mutant) {
    return mutant.component() + "\n" + mutant.id();
  }

  private static String key(MutantResult result) {
    return result.component() + "\n" + result.mutant();
  }
}
