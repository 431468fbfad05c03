package dev.eventchain.pipeline.requirements;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.design.TestFiles;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Places of a project that name a requirement: components, scenarios, constraints, component tests.
 */
final class RequirementUses {

  private final List<SoftwareNode> components;
  private final List<Scenario> scenarios;
  private final RunContext run;
  private final Map<String, Set<String>> tests = new TreeMap<>();

  private RequirementUses(RunContext run, List<SoftwareNode> components, List<Scenario> scenarios) {
    this.run = run;
    this.components = components;
    this.scenarios = scenarios;
  }

  /**
   * Reads scenarios, component tests and constraints, and the chain if there is one.
   *
   * @throws DiagnosticException INPUT if one of them cannot be read
   */
  static RequirementUses of(RunContext run) {
    boolean chain = run.project().model(run.options().output()).isPresent();
    RequirementUses uses =
        new RequirementUses(
            run,
            chain ? run.chain().chain().getSoftware() : List.of(),
            Scenario.readFolder(
                run.project().scenarios(),
                chain ? run.chain().bench() : run.bench(),
                warning -> {}));
    TestFiles.ofProject(run.project()).forEach(uses::readTests);
    return uses;
  }

  private void readTests(Path file) {
    List<Diagnostic> problems = new ArrayList<>();
    Document document =
        Document.parse(
            SourceText.read(file), DocumentFormat.YAML, ProjectSettings.RULES, problems::add);
    if (Diagnostic.anyError(problems)) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    String name = run.project().folder().relativize(file).toString();
    for (JsonNode test : document.root().findValues("requirement")) {
      tests.computeIfAbsent(test.asText(), id -> new TreeSet<>()).add(name);
    }
  }

  List<String> components(String requirement) {
    return components.stream()
        .filter(
            node -> node.getSatisfies().stream().anyMatch(each -> requirement.equals(each.getId())))
        .map(SoftwareNode::getName)
        .toList();
  }

  List<String> scenarios(String requirement) {
    return scenarios.stream()
        .filter(each -> each.requirements().contains(requirement))
        .map(Scenario::name)
        .toList();
  }

  /** Returns all that names a requirement, each with its kind. */
  List<String> all(String requirement) {
    List<String> all = new ArrayList<>();
    components(requirement).forEach(name -> all.add("component " + name));
    scenarios(requirement).forEach(name -> all.add("scenario " + name));
    for (OclConstraint each : ProjectChecks.constraints(run).standingFor(requirement)) {
      all.add("constraint " + each.name());
    }
    all.addAll(tests.getOrDefault(requirement, Set.of()));
    return all;
  }
}
