package dev.eventchain.pipeline.report;

import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.generate.GeneratedLines;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.RequirementOutcome.Outcome;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.results.Validated;
import dev.eventchain.pipeline.results.Validation;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Maps each requirement and design rule to its implementation, with the generated lines, and to its
 * proofs: scenarios that name a requirement, and constraints whose comment names a design rule.
 */
final class Traceability {

  private final RunContext run;
  private final Optional<ChainSnapshot> model;
  private final GeneratedLines generated;
  private final Map<Stage, StageOutcome> outcomes;

  Traceability(RunContext run, Optional<ChainSnapshot> model, Map<Stage, StageOutcome> outcomes) {
    this.run = run;
    this.model = model;
    this.generated = GeneratedLines.of(run);
    this.outcomes = outcomes;
  }

  /**
   * A requirement or design rule.
   *
   * @param source its file and line
   * @param parents the ids of the requirements that it is derived from
   * @param components the components that satisfy it
   * @param files the files that implement it
   * @param generated the lines generated for these components; empty for a design rule
   * @param strength the strength of a requirement, if it was measured
   * @param proved true if there are proofs, all of them passed, and nothing says that they do not
   *     test it
   */
  record Row(
      String id,
      String text,
      String source,
      List<String> parents,
      List<String> components,
      List<String> files,
      Optional<List<GeneratedLines.Made>> generated,
      List<Proof> proofs,
      Optional<RequirementOutcome.Strength> strength,
      boolean proved) {}

  /** A scenario or constraint that tests a requirement or design rule. */
  record Proof(String kind, String name, boolean tested, boolean passed) {}

  List<Row> table() {
    List<Row> table = new ArrayList<>();
    try {
      for (WrittenRequirement item : run.requirements().items()) {
        table.add(requirement(item));
      }
      for (WrittenRequirement item : run.designRules().map(Requirements::items).orElse(List.of())) {
        table.add(designRule(item));
      }
    } catch (DiagnosticException e) {
      // The file's problems are reported by the stage that needs it.
      return table;
    }
    return table;
  }

  private Row requirement(WrittenRequirement item) {
    List<SoftwareNode> satisfying =
        model.map(it -> it.chain().getSoftware()).stream()
            .flatMap(List::stream)
            .filter(node -> node.getSatisfies().stream().anyMatch(r -> item.id().equals(r.getId())))
            .toList();
    List<Proof> proofs = new ArrayList<>();
    for (SimulatedScenario scenario : simulated().map(Simulated::scenarios).orElse(List.of())) {
      if (scenario.requirements().contains(item.id())) {
        proofs.add(proof(scenario, item.id()));
      }
    }
    proofs.addAll(checks(item));
    Optional<RequirementOutcome> outcome = outcome(item);
    return new Row(
        item.id(),
        item.text(),
        run.project().placeOf(item.location()),
        item.parentIds(),
        satisfying.stream().map(SoftwareNode::getName).toList(),
        satisfying.stream().map(this::file).toList(),
        Optional.of(
            satisfying.stream()
                .flatMap(node -> generated.madeFor(node, model.orElseThrow()::locate).stream())
                .toList()),
        proofs,
        outcome.flatMap(RequirementOutcome::strength),
        proved(proofs) && !isUntested(outcome));
  }

  /** Returns what the criteria of a scenario say about one of its requirements. */
  private static Proof proof(SimulatedScenario scenario, String requirement) {
    List<Criterion> about =
        scenario.criteria().stream()
            .filter(each -> each.requirements().map(it -> it.contains(requirement)).orElse(true))
            .toList();
    boolean failed = about.stream().anyMatch(each -> each.tested() && !each.passed());
    boolean tested = failed || (!about.isEmpty() && about.stream().allMatch(Criterion::tested));
    boolean passed = !about.isEmpty() && about.stream().allMatch(Criterion::passed);
    return new Proof("scenario", scenario.name(), tested, passed);
  }

  private Row designRule(WrittenRequirement item) {
    List<Proof> proofs = checks(item);
    return new Row(
        item.id(),
        item.text(),
        run.project().placeOf(item.location()),
        List.of(),
        List.of(),
        proofs.isEmpty() ? List.of() : List.of(ProjectFolder.GENERATED),
        Optional.empty(),
        proofs,
        Optional.empty(),
        proved(proofs));
  }

  /** Returns the outcome of a requirement in the simulation of all scenarios. */
  private Optional<RequirementOutcome> outcome(WrittenRequirement item) {
    return simulated().map(Simulated::requirements).orElse(List.of()).stream()
        .filter(each -> each.id().equals(item.id()))
        .findFirst();
  }

  private static boolean isUntested(Optional<RequirementOutcome> outcome) {
    return outcome.map(RequirementOutcome::outcome).filter(Outcome.NOT_TESTED::equals).isPresent();
  }

  private static boolean proved(List<Proof> proofs) {
    return !proofs.isEmpty() && proofs.stream().allMatch(Proof::passed);
  }

  /**
   * Returns the results of the constraints that implement a requirement or design rule. The
   * measured model extends the designed one: constraints on its additional elements are tested by
   * it alone.
   */
  private List<Proof> checks(WrittenRequirement item) {
    Optional<Validation> designed =
        outcomes.get(Stage.VALIDATE).report(Validated.class).map(Validated::validation);
    Optional<Validation> measured = simulated().map(Simulated::validation);
    List<String> untested = simulated().map(Simulated::untested).orElse(List.of());
    List<Proof> proofs = new ArrayList<>();
    for (OclConstraint constraint : ProjectChecks.constraints(run).standingFor(item.id())) {
      String name = constraint.qualifiedName();
      boolean violated =
          Stream.of(designed, measured)
              .flatMap(Optional::stream)
              .anyMatch(validation -> validation.violated().contains(name));
      boolean tested =
          measured.isPresent()
              && measured.get().evaluated().contains(name)
              && !untested.contains(name);
      proofs.add(new Proof("check", constraint.name(), tested || violated, tested && !violated));
    }
    return proofs;
  }

  private Optional<Simulated> simulated() {
    return outcomes.get(Stage.SIMULATE).report(Simulated.class);
  }

  private String file(SoftwareNode node) {
    return run.softwareBase()
        .find(node.getName())
        .map(component -> run.project().folder().relativize(component.file()).toString())
        .orElse("components/" + node.getName() + ".py");
  }
}
