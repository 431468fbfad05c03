package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.report.ReportPage;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.Simulation;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Simulates one case of a campaign again, with a recording and a report, and keeps its scenario.
 */
final class CaseReplay {

  private final RunContext run;
  private final CampaignPlan plan;
  private final ScenarioTemplate template;
  private final CampaignStore store;

  CaseReplay(RunContext run, CampaignPlan plan, ScenarioTemplate template, CampaignStore store) {
    this.run = run;
    this.plan = plan;
    this.template = template;
    this.store = store;
  }

  CampaignOutcome replay(int number) {
    List<CampaignRow> rows = new ArrayList<>(store.rows());
    if (number < 1 || number > rows.size()) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  CampaignRules.VALUE_RANGE,
                  String.format(Locale.ROOT, "There is no case %d of %d.", number, rows.size()),
                  SourceLocation.of(plan.file()))
              .withHint("Run the campaign without --case first: its table has the numbers."));
    }
    CampaignRow row = rows.get(number - 1);
    CampaignCase id = row.id();
    String folder = "case-" + number;
    byte[] text = template.text(id, store.path(folder)).getBytes(StandardCharsets.UTF_8);
    store.write(folder + "/scenario.yaml", text);
    CaseSimulation.Case own = template.of(id);
    SimulationResult result = simulate(own, folder);
    String label = CampaignRow.words(row.result().label()) + " in the campaign";
    String summary = "case %s of %s: %s · %s".formatted(number, plan.name(), id.words(plan), label);
    store.write(
        folder + "/" + ReportPage.FILE,
        new CasePage(run, result).render(own.scenario(), row.result().label(), summary));
    Outcome outcome = Outcome.of(Coverage.NONE, run.takeFindings(), List.of());
    return new CampaignOutcome(outcome, words(number, row, result, store.path(folder)));
  }

  private String words(int number, CampaignRow row, SimulationResult result, Path folder) {
    StringBuilder words = new StringBuilder("case " + number + ": " + row.id().words(plan) + "\n");
    words.append(row.words()).append('\n');
    for (CriterionResult each : result.verdicts().get(0).criteria()) {
      String word = each.tested() ? (each.passed() ? "passed" : "FAILED") : "-";
      words.append("%-6s  %s: %s%n".formatted(word, each.text(), each.measured()));
    }
    words.append("Scenario, recording and report: ").append(folder).append('\n');
    return words.toString();
  }

  private SimulationResult simulate(CaseSimulation.Case each, String folder) {
    try {
      Path scratch = Files.createDirectories(run.output().scratch());
      SimulationRequest request =
          SimulateStage.request(run, List.of(each.scenario()))
              .on(each.bench())
              .with(it -> it.withRecordings(scratch).withStrength(Optional.empty()));
      SimulationResult result = Simulation.run(request, run.python(Stage.SIMULATE), name -> {});
      String name = each.scenario().name() + ".mcap";
      store.write(folder + "/" + name, Files.readAllBytes(scratch.resolve(name)));
      return result;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("nobody interrupts a simulation", e);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
