package dev.eventchain.pipeline.simulate;

import dev.eventchain.check.ChainModel;
import dev.eventchain.check.Constraints;
import dev.eventchain.constraints.OclResult;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.design.VerdictCorrection;
import dev.eventchain.pipeline.generate.GeneratedPackage;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.BoundedLatency;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.AcceptedTexts;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.simulation.Simulation;
import dev.eventchain.simulation.SimulationDriver;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.SimulationSettings;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.node.DdsAttachment;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.xmi.Origins;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/**
 * Simulates the generated nodes in the closed loop: verdicts, measurements, and the measured model.
 */
public final class SimulateStage implements StageWork {

  public static final String MEASUREMENTS = "measurements.json";
  public static final String MEASUREMENTS_TABLE = "measurements.csv";
  public static final String LATENCY_BOUNDS = "latency-bounds.json";
  public static final String VERDICT = "verdict.json";
  public static final String MEASURED_MODEL = "chain.measured.xmi";

  /** The folder of the curves of each scenario. */
  private static final String CURVES = "curves";

  /** Results of all scenarios, which must not be replaced by results of some. */
  private static final List<String> RESULTS =
      List.of(MEASUREMENTS, MEASUREMENTS_TABLE, LATENCY_BOUNDS, VERDICT, MEASURED_MODEL);

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    Project project = run.project();
    fingerprint.add(run.options().driver()).add(Confinement.demanded());
    fingerprint.add(RequirementStrength.extent(run));
    fingerprint.addSetting("strength", project.configuration().strength().asValue());
    run.options().faults().ifPresent(fingerprint::addFile);
    fingerprint.addFile(run.model());
    Path scenarios = project.scenarios().toAbsolutePath().normalize();
    for (Path file : Scenario.filesIn(project.scenarios())) {
      Path known = scenarios.relativize(file.toAbsolutePath().normalize());
      fingerprint.add(known).addFile(file);
    }
    project.bench().ifPresent(fingerprint::addFile);
    fingerprint.addFiles(project.softwareBaseFiles()).addNode();
    fingerprint.addFiles(project.ownConstraints());
    fingerprint.addFile(run.file(ProjectFolder.GENERATED));
    fingerprint.addFiles(ProjectFolder.below(run.file(GeneratedPackage.required(run).folder())));
    fingerprint.addMessages();
    RuleEvidence.ids(run).forEach(fingerprint::add);
    run.writtenRequirements().forEach(item -> fingerprint.add(texts(item)));
    if (run.project().accepted().isPresent()) {
      fingerprint.addFile(run.project().acceptedFile());
    }
  }

  private static String texts(WrittenRequirement item) {
    return item.id() + " " + AcceptedTexts.fingerprint(item.text());
  }

  @Override
  public StageResult execute(RunContext run) {
    EventChain chain = run.chain().chain();
    List<Scenario> scenarios = ProjectScenarios.selected(run);
    List<Diagnostic> found = SimulationChecks.inputs(run, scenarios);
    SimulationResult result = simulate(run, chain, scenarios, found);
    EventChain measured = result.measuredModel(chain);
    Function<EObject, SourceLocation> locator = new Origins()::locate;
    Coverage ecore = Coverage.NONE;
    if (!run.options().isPartial()) {
      writeMeasurements(run, chain, result, measured);
      ChainModel reread = run.loadChain(run.file(MEASURED_MODEL));
      measured = reread.chain();
      locator = reread::locate;
      found.addAll(reread.ecore().diagnostics());
      ecore = reread.ecore().coverage();
    }
    OclResult validation = ProjectChecks.constraints(run).check(measured, locator);
    RuleEvidence evidence = RuleEvidence.of(run, measured, validation);
    found.addAll(evidence.findings());
    List<BoundedLatency> latencies = latencies(run, scenarios, result, found);
    List<RequirementOutcome> outcomes = outcomes(run, chain, scenarios, result, evidence);
    if (!run.options().isPartial()) {
      addUntested(run, chain, scenarios, result, outcomes, found);
      // Last, so that it never exists without the results it refers to.
      run.writeResult(VERDICT, verdict(run, chain, result, found, outcomes));
    }
    Coverage coverage = Constraints.coverage(List.of(measuredFile(run)), validation).and(ecore);
    Simulated report = report(run, result, latencies, validation, outcomes, evidence);
    return new StageResult(details(run, result), results(run, result), found, report, coverage);
  }

  private static void writeMeasurements(
      RunContext run, EventChain chain, SimulationResult result, EventChain measured) {
    run.writeResult(MEASUREMENTS, result.toJson());
    run.writeResult(MEASUREMENTS_TABLE, result.toCsv(chain));
    run.output().removeAll(CURVES);
    result.curves().forEach((scenario, table) -> run.writeResult(curvesOf(scenario), table));
    run.writeResult(MEASURED_MODEL, XmiStore.toBytes(measured));
  }

  /**
   * Returns latencies with their bounds, writes them, and adds what is wrong with them and with the
   * execution times behind them.
   */
  private static List<BoundedLatency> latencies(
      RunContext run, List<Scenario> scenarios, SimulationResult result, List<Diagnostic> found) {
    List<BoundedLatency> latencies = LatencyBounds.of(run, result).report(run, scenarios, found);
    if (!run.options().isPartial()) {
      run.writeResult(LATENCY_BOUNDS, ResultJson.indented(latencies));
      found.addAll(MeasuredTimes.propose(run, result));
    }
    return latencies;
  }

  private static String curvesOf(String scenario) {
    return CURVES + "/" + scenario + ".csv";
  }

  private static List<String> results(RunContext run, SimulationResult result) {
    if (run.options().isPartial()) {
      return List.of();
    }
    Stream<String> curves = result.verdicts().stream().map(verdict -> curvesOf(verdict.scenario()));
    return Stream.concat(RESULTS.stream(), curves).toList();
  }

  private static String measuredFile(RunContext run) {
    return SourceLocation.of(run.file(MEASURED_MODEL)).file();
  }

  private static Simulated report(
      RunContext run,
      SimulationResult result,
      List<BoundedLatency> latencies,
      OclResult validation,
      List<RequirementOutcome> outcomes,
      RuleEvidence evidence) {
    return SimulationReport.of(
        result,
        latencies,
        ProcessorReport.of(run.chain().chain()),
        evidence.untestedConstraints(),
        run.options().isPartial() ? List.of() : outcomes,
        RequirementStrength.limited(run, result),
        ProjectChecks.report(measuredFile(run), validation));
  }

  private static List<RequirementOutcome> outcomes(
      RunContext run,
      EventChain chain,
      List<Scenario> scenarios,
      SimulationResult result,
      RuleEvidence evidence) {
    List<Scenario> judged = RequirementCoverage.judged(scenarios, result);
    Set<String> unproven = new TreeSet<>(RequirementCoverage.unproven(run, chain, judged).keySet());
    unproven.addAll(StaleEvidence.ids(StaleEvidence.of(run)));
    return RequirementOutcomes.of(
        run.writtenRequirements(),
        result.verdicts(),
        unproven,
        evidence,
        RequirementStrength.of(run, result));
  }

  private static void addUntested(
      RunContext run,
      EventChain chain,
      List<Scenario> scenarios,
      SimulationResult result,
      List<RequirementOutcome> outcomes,
      List<Diagnostic> found) {
    List<Scenario> judged = RequirementCoverage.judged(scenarios, result);
    found.addAll(RequirementCoverage.untested(run, chain, judged));
    found.addAll(StaleEvidence.of(run));
    found.addAll(unmeasured(chain, result, run.chain()::locate));
    found.addAll(RequirementCoverage.unlisted(run, outcomes, found));
  }

  /** Returns findings about bounds on times that were never measured, and so were not tested. */
  private static List<Diagnostic> unmeasured(
      EventChain chain, SimulationResult result, Function<EObject, SourceLocation> locator) {
    List<Diagnostic> found = new ArrayList<>();
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      int index = i;
      if (result.verdicts().stream().allMatch(each -> each.latencies().get(index).isEmpty())) {
        SourceLocation place = locator.apply(constraint);
        found.add(
            result.host().attached() ? unseen(constraint, place) : unmeasured(constraint, place));
      }
    }
    return found;
  }

  private static Diagnostic unseen(LatencyConstraint constraint, SourceLocation place) {
    return Diagnostic.of(
            SimulateRules.SIMULATION_LATENCY_UNMEASURED,
            "The latency constraint '%s' was not measured: the nodes were started elsewhere, so it is not known which output is based on which input."
                .formatted(constraint.getName()),
            place)
        .withHint("Simulate with a driver that starts the nodes, or measure it where they run.");
  }

  private static Diagnostic unmeasured(LatencyConstraint constraint, SourceLocation place) {
    return Diagnostic.of(
            SimulateRules.SIMULATION_LATENCY_UNMEASURED,
            "The latency constraint '%s' was not measured in any scenario: nothing that '%s' did was based on an input of '%s'."
                .formatted(
                    constraint.getName(), name(constraint.getLast()), name(constraint.getFirst())),
            place)
        .withHint("Bound the time between two simulated components that are connected by data.");
  }

  private static String name(SoftwareNode node) {
    return node == null ? "?" : node.getName();
  }

  /** Returns the verdict from all findings of the run, so that it is not better than the run. */
  private static byte[] verdict(
      RunContext run,
      EventChain chain,
      SimulationResult result,
      List<Diagnostic> found,
      List<RequirementOutcome> outcomes) {
    return VerdictJson.of(
        chain,
        result,
        outcomes,
        RequirementStrength.limited(run, result),
        run.options().suppressions().part(found));
  }

  private static String details(RunContext run, SimulationResult result) {
    long passed = result.verdicts().stream().filter(ScenarioVerdict::passed).count();
    return String.format(
        Locale.ROOT,
        "%d of %d scenarios passed,%s%s %s",
        passed,
        result.verdicts().size(),
        RequirementStrength.details(run, result),
        result.faults().isEmpty() ? "" : " " + result.faults().size() + " runs with faults,",
        result.host().attached() ? result.host().driver() : how(result.host()));
  }

  private static String how(SimulationResult.Host host) {
    return String.format(
        Locale.ROOT, "%.0f times real time, %s", host.realTimeFactor(), host.confinement());
  }

  /** Simulates and adds the findings. */
  private static SimulationResult simulate(
      RunContext run, EventChain chain, List<Scenario> scenarios, List<Diagnostic> found) {
    found.addAll(ComponentCopies.requireSame(run, chain, GeneratedPackage.required(run)));
    SimulationResult result = simulate(run, chain, scenarios);
    run.models().simulated(result);
    found.addAll(result.diagnostics());
    result.verdicts().forEach(verdict -> found.addAll(verdict.diagnostics()));
    result.faults().forEach(fault -> found.addAll(fault.diagnostics()));
    found.addAll(RequirementStrength.of(run, result).findings());
    return result;
  }

  private static SimulationResult simulate(
      RunContext run, EventChain chain, List<Scenario> scenarios) {
    GeneratedPackage generated = GeneratedPackage.required(run);
    FaultPlan faults = ProjectFaults.selected(run, chain, scenarios);
    Recordings recordings = new Recordings(run, scenarios, faults);
    SimulationRequest request =
        recordings.begin(request(run, scenarios).with(it -> it.withFaults(faults)));
    int all = scenarios.size() + faults.size();
    AtomicInteger done = new AtomicInteger();
    try {
      return Simulation.run(
          request,
          run.python(Stage.SIMULATE),
          name ->
              run.progress()
                  .step(Stage.SIMULATE, counted(done.incrementAndGet(), all) + ": " + name));
    } catch (DiagnosticException e) {
      throw new DiagnosticException(
          e.reason(),
          e.diagnostics().stream().map(found -> atSource(found, run, chain, generated)).toList());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      String message = "The simulation was interrupted.";
      throw new DiagnosticException(
          DiagnosticException.Reason.FINDINGS,
          Diagnostic.of(SimulateRules.SIMULATION_INTERRUPTED, message, SourceLocation.NONE));
    } finally {
      recordings.keep();
    }
  }

  /** Returns the number of a run; those with standard faults come after all others. */
  private static String counted(int count, int all) {
    return count <= all ? count + " of " + all : "fault " + (count - all);
  }

  /**
   * Returns the request for the simulation of a project without faults.
   *
   * @throws DiagnosticException INPUT if nothing was generated, or a scenario cannot be read
   */
  public static SimulationRequest request(RunContext run) {
    return request(run, ProjectScenarios.selected(run));
  }

  /** Returns the request to simulate other scenarios than the project's likewise. */
  public static SimulationRequest request(RunContext run, List<Scenario> scenarios) {
    EventChain chain = run.chain().chain();
    GeneratedPackage generated = GeneratedPackage.required(run);
    return SimulationRequest.of(
            chain,
            run.file(generated.folder()),
            generated.manifest(),
            run.messages(),
            run.chain().bench(),
            scenarios)
        .with(settings -> settings(run, chain, settings));
  }

  private static SimulationSettings settings(
      RunContext run, EventChain chain, SimulationSettings usual) {
    Set<String> written = written(run, chain);
    SimulationSettings settings =
        usual
            .withGenerated(written)
            .withAccepted(run.options().suppressions()::accepts)
            .ofAllScenarios(!run.options().isPartial())
            .withSamples(!written.isEmpty() && VerdictCorrection.mayFollow(run.options()))
            .withStrength(RequirementStrength.budget(run));
    return switch (run.options().driver()) {
      case LOCKSTEP -> settings;
      case DDS -> settings.withDriver(SimulationDriver.DDS);
      case DDS_IN_REAL_TIME -> settings.withDriver(SimulationDriver.DDS_IN_REAL_TIME);
      case DDS_ATTACHED -> settings.withAttachment(DdsAttachment.of(System.getenv()));
    };
  }

  /** Returns the components of a language model: those that the software base does not have. */
  private static Set<String> written(RunContext run, EventChain chain) {
    return run.softwareBase().missing(chain).stream()
        .map(SoftwareNode::getName)
        .collect(Collectors.toSet());
  }

  /** Relocates a finding in the generated package's copy of a component to the original file. */
  private static Diagnostic atSource(
      Diagnostic found, RunContext run, EventChain chain, GeneratedPackage generated) {
    SourceLocation place = found.location();
    return ComponentCopies.of(run, chain, generated).entrySet().stream()
        .filter(copy -> SourceLocation.of(copy.getKey()).file().equals(place.file()))
        .findFirst()
        .map(copy -> found.withLocation(place.inFile(copy.getValue())))
        .orElse(found);
  }
}
