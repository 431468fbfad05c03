package dev.eventchain.pipeline.campaign;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The files whose numbers the factors of campaigns replace: the scenarios and the bench of a
 * project; and the nodes of its chain.
 *
 * @param benches reads other texts of the bench
 * @param nodes the names of the nodes
 * @param scenarios the folder of the scenarios
 */
record CampaignWorld(
    Bench bench,
    Function<SourceText, Bench> benches,
    Optional<Path> benchFile,
    List<String> nodes,
    Path scenarios) {

  /** Returns that of a run, whose nodes are generated. */
  static CampaignWorld of(RunContext run) {
    return new CampaignWorld(
        run.chain().bench(),
        run.benches(),
        run.project().bench(),
        nodes(run.chain().chain()),
        run.project().scenarios());
  }

  private static List<String> nodes(EventChain chain) {
    return chain.getSoftware().stream().map(SoftwareNode::getName).toList();
  }

  /**
   * Returns that of a project as its files are now; empty without a chain, or if one of the files
   * cannot be read, which is a finding of the project.
   */
  static Optional<CampaignWorld> of(Path folder) {
    try {
      Project project = Project.open(folder);
      Path output = project.defaultOutput();
      FileReads.note(output.resolve(ProjectFolder.MODEL));
      Optional<Path> model = project.model(output);
      if (model.isEmpty()) {
        return Optional.empty();
      }
      Path file = model.get();
      EventChain chain =
          ChainModel.chainOf(EventChainMetamodel.store(file.resolveSibling("")).load(file), file);
      List<Signal> signals = project.readSoftwareBase().signals().orElse(List.of());
      MessageCatalog messages = project.readMessages();
      Bench bench = Bench.read(project.bench(), signals, messages).withOutputsOf(chain);
      return Optional.of(
          new CampaignWorld(
              bench,
              text -> Bench.parse(text, signals, messages).withOutputsOf(chain),
              project.bench(),
              nodes(chain),
              project.scenarios()));
    } catch (DiagnosticException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns what is wrong with the scenarios and the factors of campaigns, as {@code campaign} and
   * {@code search} report it; nothing about scenarios that cannot be read, or come from elsewhere.
   */
  List<Diagnostic> check(List<CampaignPlan> plans) {
    try {
      List<Scenario> all = Scenario.readFolder(scenarios, bench, finding -> {});
      return Stream.concat(
              plans.stream()
                  .filter(plan -> plan.played().isEmpty())
                  .flatMap(plan -> check(all, plan).stream()),
              CriteriaOfCases.withoutCase(plans, plans).stream())
          .toList();
    } catch (DiagnosticException e) {
      return List.of();
    }
  }

  private List<Diagnostic> check(List<Scenario> all, CampaignPlan plan) {
    Path file;
    try {
      file = plan.scenarioFile().orElseGet(() -> Path.of(find(all, plan).location().file()));
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
    Purpose purpose = plan.isListed() ? Purpose.CAMPAIGN : Purpose.SEARCH;
    return new ScenarioTemplate(this, plan, file).check(purpose);
  }

  /** Returns the scenario that a campaign names. */
  static Scenario find(List<Scenario> scenarios, CampaignPlan plan) {
    List<String> names = scenarios.stream().map(Scenario::name).toList();
    int index = names.indexOf(plan.scenario());
    if (index < 0) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  CampaignRules.FACTOR,
                  "The project has no scenario '" + plan.scenario() + "'.",
                  SourceLocation.of(plan.file()))
              .withHint(NearestName.hint(plan.scenario(), names)));
    }
    return scenarios.get(index);
  }
}
