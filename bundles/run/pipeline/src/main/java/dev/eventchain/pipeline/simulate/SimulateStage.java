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
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.design.VerdictCorrection;
import dev.eventchain.pipeline.generate.GeneratedPackage;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.BoundedLatency;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.AcceptedTexts;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.simulation.Simulation;
import dev.eventchain.simulation.SimulationDriver;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.SimulationSettings;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.node.DdsAttachment;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.xmi.Origins;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;

/**
 * Simulates the generated nodes in the closed loop: verdicts, measurements, and the measured model.
 */
public final class SimulateStage implements StageWork {

  public static final String MEASUREMENTS = "measurements.json";
  public static final String MEASUREMENTS_TABLE = "measurements.csv";

  public static final String LATENCY_BOUNDS = "latency-bounds.json";
  public static final String MEASURED_MODEL = "chain.measured.xmi";

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    Project project = run.project();
    fingerprint.add(run.options().simulation().driver()).add(Confinement.demanded());
    fingerprint.add(RequirementStrength.extent(run));
    fingerprint.addSetting("strength", project.configuration().strength().asValue());
    run.options().simulation().faults().ifPresent(fingerprint::addFile);
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
    List<Scenario> scenarios = ProjectScenarios.selected(run);
    List<Diagnostic> found = SimulationChecks.inputs(run, scenarios);
    SimulationResult result = simulate(run, run.chain().chain(), scenarios, found);
    FinishedSimulation finished = new FinishedSimulation(run, scenarios, result);
    EventChain measured = result.measuredModel(run.chain().chain());
    Function<EObject, SourceLocation> locator = new Origins()::locate;
    Coverage ecore = Coverage.NONE;
    if (!run.options().isPartial()) {
      finished.writeMeasurements(measured);
      ChainModel reread = run.loadChain(run.file(MEASURED_MODEL));
      measured = reread.chain();
      locator = reread::locate;
      found.addAll(reread.ecore().diagnostics());
      ecore = reread.ecore().coverage();
    }
    OclResult validation = ProjectChecks.constraints(run).check(measured, locator);
    RuleEvidence evidence = RuleEvidence.of(run, measured, validation);
    found.addAll(evidence.findings());
    List<BoundedLatency> latencies = finished.latencies(found);
    List<RequirementOutcome> outcomes = finished.outcomes(evidence);
    if (!run.options().isPartial()) {
      finished.addUntested(outcomes, found);
      // Last, so that it never exists without the results it refers to.
      run.writeResult(ProjectLayout.VERDICT, finished.verdict(outcomes, found));
    }
    Simulated report = finished.report(latencies, validation, outcomes, evidence);
    Coverage rules = Constraints.coverage(List.of(finished.measuredFile()), validation);
    return new StageResult(finished.details(), finished.results(), found, report, rules.and(ecore));
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
    found.addAll(UnshownSignals.of(result).findings());
    return result;
  }

  private static SimulationResult simulate(
      RunContext run, EventChain chain, List<Scenario> scenarios) {
    GeneratedPackage generated = GeneratedPackage.required(run);
    FaultPlan faults = ProjectFaults.selected(run, chain, scenarios);
    Recordings recordings = new Recordings(run, scenarios, faults);
    SimulationRequest request =
        recordings.begin(request(run, scenarios).with(it -> whole(run, it.withFaults(faults))));
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

  /** Returns settings that record what scenarios show, if they are all of the project. */
  private static SimulationSettings whole(RunContext run, SimulationSettings settings) {
    return settings.withCoverage(!run.options().isPartial());
  }

  /**
   * Returns the report of scenarios that are not the project's, such as a case of a campaign.
   *
   * @param measured the model with what was measured
   * @param found receives findings about latencies
   */
  public static Simulated report(
      RunContext run,
      List<Scenario> scenarios,
      SimulationResult result,
      EventChain measured,
      List<Diagnostic> found) {
    OclResult validation = ProjectChecks.constraints(run).check(measured, new Origins()::locate);
    return SimulationReport.of(
        result,
        LatencyBounds.of(run, result).report(run, scenarios, found),
        ProcessorReport.of(measured),
        List.of(),
        List.of(),
        Optional.empty(),
        ProjectChecks.report(SourceLocation.of(run.model()).file(), validation));
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
    return switch (run.options().simulation().driver()) {
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
