package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import dev.eventchain.modeler.Requirements;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * From each requirement and design rule to what implements it, with the lines that were generated
 * for it, and what proves it: scenarios that name a requirement, and constraints whose comment
 * names a design rule.
 */
final class Traceability {

  /** A comment that begins with the id of a design rule, above the invariant that formalizes it. */
  private static final Pattern RULE_COMMENT = Pattern.compile("\\s*--\\s*([A-Za-z][\\w.-]*):.*");

  private static final Pattern INVARIANT = Pattern.compile("\\s*inv\\s+(\\w+)\\s*:.*");

  private final RunContext run;
  private final Optional<RunContext.LoadedChain> model;
  private final GeneratedLines generated;
  private final Map<Stage, StageOutcome> outcomes;

  Traceability(
      RunContext run, Optional<RunContext.LoadedChain> model, Map<Stage, StageOutcome> outcomes) {
    this.run = run;
    this.model = model;
    this.generated = GeneratedLines.of(run);
    this.outcomes = outcomes;
  }

  ArrayNode table() {
    ArrayNode table = JsonNodeFactory.instance.arrayNode();
    try {
      for (Requirements.Item item : run.requirements().items()) {
        table.add(requirement(item));
      }
      for (Requirements.Item item : run.designRules().map(Requirements::items).orElse(List.of())) {
        table.add(designRule(item));
      }
    } catch (DiagnosticException e) {
      // The file's problems are among the findings of the stage that needed it.
      return table;
    }
    return table;
  }

  private ObjectNode requirement(Requirements.Item item) {
    ObjectNode row = row(item);
    ArrayNode components = row.putArray("components");
    ArrayNode files = row.putArray("files");
    ArrayNode lines = row.putArray("generated");
    if (model.isPresent()) {
      ChainOrigins origins = ChainOrigins.of(run, model.get());
      for (SoftwareNode node : model.get().chain().getSoftware()) {
        if (node.getSatisfies().stream().anyMatch(r -> item.id().equals(r.getId()))) {
          components.add(node.getName());
          files.add(file(node));
          lines.addAll(generated.madeFor(node, origins::locate));
        }
      }
    }
    List<Proof> proofs = new ArrayList<>();
    for (JsonNode scenario : report(Stage.SIMULATE).path("scenarios")) {
      for (JsonNode id : scenario.path("requirements")) {
        if (id.asText().equals(item.id())) {
          proofs.add(
              new Proof(
                  "scenario", scenario.path("name").asText(), scenario.path("passed").asBoolean()));
        }
      }
    }
    return proved(row, proofs);
  }

  private ObjectNode designRule(Requirements.Item item) {
    ObjectNode row = row(item);
    row.putArray("components");
    List<Proof> proofs = new ArrayList<>();
    JsonNode designed = report(Stage.VALIDATE).path("validation");
    JsonNode measured = report(Stage.SIMULATE).path("validation");
    for (String constraint : constraintsOf(item.id())) {
      boolean evaluated = designed.isObject();
      boolean holds =
          evaluated && !violated(designed, constraint) && !violated(measured, constraint);
      proofs.add(new Proof("check", constraint, holds));
    }
    row.putArray("files");
    if (!proofs.isEmpty()) {
      ((ArrayNode) row.get("files")).add(Constraints.GENERATED);
    }
    return proved(row, proofs);
  }

  private record Proof(String kind, String name, boolean passed) {}

  private static ObjectNode row(Requirements.Item item) {
    return JsonNodeFactory.instance.objectNode().put("id", item.id()).put("text", item.text());
  }

  private static ObjectNode proved(ObjectNode row, List<Proof> proofs) {
    ArrayNode array = row.putArray("proofs");
    for (Proof proof : proofs) {
      array
          .addObject()
          .put("kind", proof.kind())
          .put("name", proof.name())
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

  /** The names of the generated constraints under a comment with the rule's id. */
  private Set<String> constraintsOf(String rule) {
    Set<String> names = new TreeSet<>();
    String text =
        run.output()
            .read(Constraints.GENERATED)
            .map(bytes -> new String(bytes, java.nio.charset.StandardCharsets.UTF_8))
            .orElse("");
    String current = "";
    for (String line : text.lines().toList()) {
      Matcher comment = RULE_COMMENT.matcher(line);
      Matcher invariant = INVARIANT.matcher(line);
      if (comment.matches()) {
        current = comment.group(1);
      } else if (invariant.matches() && current.equals(rule)) {
        names.add(invariant.group(1));
      }
    }
    return names;
  }

  private static boolean violated(JsonNode validation, String constraint) {
    for (JsonNode name : validation.path("violated")) {
      if (name.asText().endsWith("::" + constraint)) {
        return true;
      }
    }
    return false;
  }

  private JsonNode report(Stage stage) {
    return outcomes.get(stage).report().orElse(JsonNodeFactory.instance.objectNode());
  }
}
