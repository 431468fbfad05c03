package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.YamlLayout;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.PlayedScenario;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.engine.PipelineRun;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.simulate.SimulationChecks;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * Environment in which the cases of a campaign file are simulated: the generated nodes and the
 * scenario.
 */
final class CampaignScene {

  private final RunContext run;
  private final CampaignPlan plan;
  private final Optional<Path> file;
  private final Fingerprint inputs;
  private final List<Scenario> scenarios;
  private final Scenario scenario;
  private final ScenarioTemplate template;
  private Optional<CaseSimulation> simulation = Optional.empty();
  private boolean wasChanged;

  private CampaignScene(
      RunContext run,
      CampaignPlan plan,
      Optional<Path> file,
      Fingerprint inputs,
      List<Scenario> scenarios) {
    this.run = run;
    this.plan = plan;
    this.file = file;
    this.inputs = inputs;
    this.scenarios = scenarios;
    this.scenario =
        file.map(it -> Scenario.read(it, run.chain().bench(), run::find))
            .orElseGet(() -> CampaignWorld.find(scenarios, plan));
    this.template =
        new ScenarioTemplate(
            CampaignWorld.of(run), plan, file.orElseGet(() -> Path.of(scenario.location().file())));
  }

  /**
   * Generates the nodes of a project, as far as something has changed, and works with them.
   *
   * @param settings options of the run up to the generation, in lock-step
   * @param file the campaign file
   * @param reader reads it
   * @param work with its campaigns; it is not done if the nodes cannot be generated
   * @throws DiagnosticException for failures caused by the project, the campaign file or this
   *     machine
   */
  static CampaignOutcome of(
      Project project,
      RunOptions settings,
      Path file,
      Function<Path, List<CampaignPlan>> reader,
      Progress progress,
      Function<List<CampaignScene>, CampaignOutcome> work) {
    String read = Fingerprint.contentOf(file);
    List<CampaignPlan> plans = reader.apply(file);
    RunResult generated = PipelineRun.run(project, settings, progress, Optional.empty()).result();
    if (generated.failure().isPresent() || Diagnostic.anyError(generated.diagnostics())) {
      return new CampaignOutcome(Outcome.of(generated), "");
    }
    try (OutputFolder output = OutputFolder.open(settings.output())) {
      RunContext run = new RunContext(project, settings, output, progress, Optional.empty());
      generated.diagnostics().forEach(run::find);
      if (!Fingerprint.contentOf(file).equals(read)) {
        throw changed(file);
      }
      return work.apply(scenes(run, plans));
    }
  }

  private static List<CampaignScene> scenes(RunContext run, List<CampaignPlan> plans) {
    // Before anything is read, so that later changes are noticed.
    List<Optional<Path>> files = plans.stream().map(plan -> file(run, plan)).toList();
    List<Fingerprint> inputs =
        IntStream.range(0, plans.size())
            .mapToObj(i -> fingerprint(run, plans.get(i), files.get(i)))
            .toList();
    List<Scenario> scenarios =
        Scenario.readFolder(run.project().scenarios(), run.chain().bench(), run::find);
    return IntStream.range(0, plans.size())
        .mapToObj(i -> new CampaignScene(run, plans.get(i), files.get(i), inputs.get(i), scenarios))
        .toList();
  }

  /** Returns the file of a scenario that is not one of the project's; one may have to be made. */
  private static Optional<Path> file(RunContext run, CampaignPlan plan) {
    if (plan.played().isEmpty()) {
      return plan.scenarioFile();
    }
    PlayedScenario played = plan.played().get();
    String name = OpenScenarioCampaigns.FOLDER + "/" + plan.name() + "-scenario.yaml";
    Path file = run.file(name);
    String path = ScenarioTemplate.path(file.getParent(), played.varied().scenario());
    ObjectNode written = played.written(path, plan.paths());
    String text = YamlLayout.of(new CriteriaOfCases(plan).withThoseOfAll(written));
    run.writeResult(name, text.getBytes(StandardCharsets.UTF_8));
    return Optional.of(file);
  }

  RunContext run() {
    return run;
  }

  CampaignPlan plan() {
    return plan;
  }

  /** Returns all scenarios of the project. */
  List<Scenario> scenarios() {
    return scenarios;
  }

  /** Returns the one whose cases are simulated. */
  Scenario scenario() {
    return scenario;
  }

  ScenarioTemplate template() {
    return template;
  }

  /**
   * Checks what can be checked before a case is simulated.
   *
   * @param scenes those of all campaigns of a file, of which there is at least one
   * @param purpose which of their cases are checked
   * @throws DiagnosticException (INPUT) with every problem
   */
  static void requireSound(List<CampaignScene> scenes, Purpose purpose) {
    List<Diagnostic> problems =
        scenes.stream().flatMap(scene -> scene.template.check(purpose).stream()).toList();
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    RunContext run = scenes.get(0).run;
    List<Scenario> scenarios = scenes.stream().map(CampaignScene::scenario).distinct().toList();
    SimulationChecks.requireSound(run, scenarios).forEach(run::find);
  }

  /** Returns where findings about its cases belong: the file, and the campaign of several. */
  SourceLocation place() {
    SourceLocation file = SourceLocation.of(plan.file());
    return plan.part().map(file::withElement).orElse(file);
  }

  /**
   * Returns a hash of all files that a result depends on, as they were at first: what a simulation
   * does, and the campaign.
   */
  Fingerprint inputs() {
    return inputs;
  }

  private static Fingerprint fingerprint(RunContext run, CampaignPlan plan, Optional<Path> file) {
    Fingerprint fingerprint = new Fingerprint(run);
    new SimulateStage().fingerprint(run, fingerprint);
    fingerprint.addFile(plan.file());
    plan.part().ifPresent(fingerprint::add);
    file.map(it -> files(plan, it)).ifPresent(fingerprint::addFiles);
    plan.factors().forEach(factor -> fingerprint.add(factor.levels()));
    return fingerprint;
  }

  /**
   * Returns the files that a scenario consists of. One that was made says where its file is from
   * the output folder, which parts of a campaign have different ones of.
   */
  private static List<Path> files(CampaignPlan plan, Path scenario) {
    List<Path> files = new ArrayList<>(Scenario.filesOf(scenario));
    plan.played()
        .ifPresent(
            played -> {
              files.remove(scenario);
              files.add(played.file());
            });
    return files;
  }

  /**
   * Returns no cases of the present inputs.
   *
   * @param platform the versions of what simulates; empty for those of this machine
   */
  CampaignStore.Cases cases(Optional<String> platform, Shard shard) {
    return new CampaignStore.Cases(
        plan.name(), inputs().value(), platform.orElseGet(this::platform), shard, false, List.of());
  }

  /** Returns what simulates here, which no file of the project says. */
  private String platform() {
    return String.format(
        Locale.ROOT,
        "Python %s, Java %d, %s, %s",
        run.python(Stage.SIMULATE).version(),
        Runtime.version().feature(),
        System.getProperty("os.arch"),
        Confinement.detect().name().toLowerCase(Locale.ROOT).replace('_', '-'));
  }

  /** Returns whether all files that a result depends on have always been as at first. */
  synchronized boolean isUnchanged() {
    wasChanged |= !fingerprint(run, plan, file).value().equals(inputs.value());
    return !wasChanged;
  }

  /**
   * Drops the results if some of them may be of other files than the others.
   *
   * @throws DiagnosticException (INPUT) if a file is, or was, another one than at first
   */
  void requireUnchanged(CampaignStore store) {
    if (!isUnchanged()) {
      store.discard();
      throw changed(plan.file());
    }
  }

  private static DiagnosticException changed(Path file) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
                CampaignRules.INPUTS_CHANGED,
                "Files of the project or the campaign were changed while it ran.",
                SourceLocation.of(file))
            .withHint("Nobody can say which cases are of which state. Run it again."));
  }

  /** Returns the simulation of cases, on all processors. */
  CaseSimulation simulation() {
    if (simulation.isEmpty()) {
      int processes = Runtime.getRuntime().availableProcessors();
      simulation =
          Optional.of(
              new CaseSimulation(
                  SimulateStage.request(run, List.of(scenario))
                      .with(it -> it.withProcesses(processes)),
                  run.python(Stage.SIMULATE)));
    }
    return simulation.get();
  }
}
