package dev.eventchain.pipeline.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.generate.GeneratedLines;
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

  ArrayNode table() {
    ArrayNode table = JsonNodeFactory.instance.arrayNode();
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

  private ObjectNode requirement(WrittenRequirement item) {
    ObjectNode row = row(item);
    ArrayNode components = row.putArray("components");
    ArrayNode files = row.putArray("files");
    ArrayNode lines = row.putArray("generated");
    if (model.isPresent()) {
      for (SoftwareNode node : model.get().chain().getSoftware()) {
        if (node.getSatisfies().stream().anyMatch(r -> item.id().equals(r.getId()))) {
          components.add(node.getName());
          files.add(file(node));
          lines.addAll(generated.madeFor(node, model.get()::locate));
        }
      }
    }
    List<Proof> proofs = new ArrayList<>();
    for (JsonNode scenario : report(Stage.SIMULATE).path("scenarios")) {
      for (JsonNode id : scenario.path("requirements")) {
        if (id.asText().equals(item.id())) {
          proofs.add(
              new Proof(
                  "scenario",
                  scenario.path("name").asText(),
                  scenario.path("tested").asBoolean(),
                  scenario.path("passed").asBoolean()));
        }
      }
    }
    proofs.addAll(checks(item));
    return proved(row, proofs);
  }

  private ObjectNode designRule(WrittenRequirement item) {
    ObjectNode row = row(item);
    row.putArray("components");
    List<Proof> proofs = checks(item);
    row.putArray("files");
    if (!proofs.isEmpty()) {
      ((ArrayNode) row.get("files")).add(ProjectFolder.GENERATED);
    }
    return proved(row, proofs);
  }

  /**
   * Returns the results of the constraints that implement a requirement or design rule. The
   * measured model extends the designed one: constraints on its additional elements are tested by
   * it alone.
   */
  private List<Proof> checks(WrittenRequirement item) {
    JsonNode designed = report(Stage.VALIDATE).path("validation");
    JsonNode measured = report(Stage.SIMULATE).path("validation");
    JsonNode untested = report(Stage.SIMULATE).path("untested");
    List<Proof> proofs = new ArrayList<>();
    for (OclConstraint constraint : ProjectChecks.constraints(run).standingFor(item.id())) {
      String name = constraint.qualifiedName();
      boolean violated =
          has(designed.path("violated"), name) || has(measured.path("violated"), name);
      boolean tested = has(measured.path("evaluated"), name) && !has(untested, name);
      proofs.add(new Proof("check", constraint.name(), tested || violated, tested && !violated));
    }
    return proofs;
  }

  private record Proof(String kind, String name, boolean tested, boolean passed) {}

  private static ObjectNode row(WrittenRequirement item) {
    return JsonNodeFactory.instance.objectNode().put("id", item.id()).put("text", item.text());
  }

  private static ObjectNode proved(ObjectNode row, List<Proof> proofs) {
    ArrayNode array = row.putArray("proofs");
    for (Proof proof : proofs) {
      array
          .addObject()
          .put("kind", proof.kind())
          .put("name", proof.name())
          .put("tested", proof.tested())
          .put("passed", proof.passed());
    }
    return row.put("proved", !proofs.isEmpty() && proofs.stream().allMatch(Proof::passed));
  }

  private String file(SoftwareNode node) {
    return run.softwareBase()
        .find(node.getName())
        .map(component -> run.project().folder().relativize(component.file()).toString())
        .orElse("components/" + node.getName() + ".py");
  }

  private static boolean has(JsonNode names, String constraint) {
    for (JsonNode name : names) {
      if (name.asText().equals(constraint)) {
        return true;
      }
    }
    return false;
  }

  private JsonNode report(Stage stage) {
    return outcomes.get(stage).report().orElse(JsonNodeFactory.instance.objectNode());
  }
}
