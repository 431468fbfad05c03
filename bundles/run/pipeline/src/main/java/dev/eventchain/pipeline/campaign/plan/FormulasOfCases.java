package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.scenario.NumberFormulas;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Reads the formulas of a campaign over the factors of a case: what is computed, and points. */
final class FormulasOfCases {

  private final ObjectReader section;
  private final List<Factor> factors;
  private final List<String> known;
  private final List<Computed> computed = new ArrayList<>();
  private boolean complete = true;

  /**
   * The formulas of a campaign, without those that are wrong.
   *
   * @param points empty if there are none
   */
  record Read(List<Computed> computed, Optional<Points> points) {

    Read {
      computed = List.copyOf(computed);
    }
  }

  private FormulasOfCases(ObjectReader section, List<Factor> factors) {
    this.section = section;
    this.factors = factors;
    this.known = new ArrayList<>(factors.stream().map(Factor::name).toList());
  }

  private void all(ObjectReader formulas) {
    for (String name : formulas.names()) {
      CampaignReader.requireName(formulas, name, "A factor");
      if (known.contains(name)) {
        String message = "There is a factor '" + name + "' already.";
        formulas.find(CampaignRules.KEY_DUPLICATE, message, formulas.atKey(name));
      }
      Optional<Computed> read = formulas.object(name).flatMap(part -> computed(name, part));
      read.ifPresent(computed::add);
      complete &= read.isPresent();
      known.add(name);
    }
  }

  private Optional<Computed> computed(String name, ObjectReader part) {
    List<String> paths = CampaignReader.paths(part);
    Optional<NumberFormulas.Quantity> formula = formula(part, "formula", known);
    part.refuseOthers();
    return formula.map(it -> new Computed(name, paths, it, part.location()));
  }

  /**
   * Reads what is computed and how points are counted, and requires a use of all numbers. What is
   * wrong is reported.
   *
   * @param section the campaign
   * @param conditions those of the campaign and of its criteria
   */
  static Read read(ObjectReader section, List<Factor> factors, List<SourceRange> conditions) {
    FormulasOfCases formulas = new FormulasOfCases(section, factors);
    Optional<Points> points = formulas.points(conditions);
    return new Read(formulas.computed, points);
  }

  private Optional<Points> points(List<SourceRange> conditions) {
    section.object("computed").ifPresent(this::all);
    Optional<Points> points = section.object("points").flatMap(this::points);
    Set<String> read = new HashSet<>();
    conditions.forEach(each -> read.addAll(namesOf(each)));
    requireUse(points, read);
    return points;
  }

  /** Returns what a condition reads; one that is wrong is reported when cases are made. */
  private Set<String> namesOf(SourceRange condition) {
    try {
      return new NumberFormulas(known).condition(condition).names();
    } catch (DiagnosticException e) {
      complete = false;
      return Set.of();
    }
  }

  private Optional<Points> points(ObjectReader part) {
    if (known.contains(Points.IMPACT)) {
      String message = "In formulas of points, 'impact' is the impact speed, and it is a factor.";
      part.find(CampaignRules.KEY_DUPLICATE, message, part.location());
    }
    String source = part.requiredText("source");
    Optional<NumberFormulas.Quantity> most = formula(part, "most", known);
    List<String> names = new ArrayList<>(known);
    names.add(Points.IMPACT);
    boolean partial = part.has("at_impact");
    Optional<NumberFormulas.Quantity> share =
        partial ? formula(part, "at_impact", names) : Optional.empty();
    List<String> criteria = criteria(part);
    List<NumberFormulas.Condition> counted = counted(part);
    part.refuseOthers();
    complete &= most.isPresent() && share.isPresent() == partial;
    return most.map(it -> new Points(source, it, share, criteria, counted, part.location()));
  }

  private static List<String> criteria(ObjectReader part) {
    if (part.value(CriteriaByTags.KEY).filter(it -> it.isArray() && it.isEmpty()).isPresent()) {
      String message = "No criterion is named.";
      part.find(CampaignRules.VALUE_RANGE, message, part.at(CriteriaByTags.KEY));
    }
    return part.texts(CriteriaByTags.KEY);
  }

  /** Reads the conditions on the cases for which there are points. */
  private List<NumberFormulas.Condition> counted(ObjectReader part) {
    List<NumberFormulas.Condition> counted = new ArrayList<>();
    for (SourceRange each : CampaignReader.conditions(part)) {
      try {
        counted.add(new NumberFormulas(known).condition(each));
      } catch (DiagnosticException e) {
        part.find(wrong(e, part.at("where")));
        complete = false;
      }
    }
    return counted;
  }

  private static Diagnostic wrong(DiagnosticException e, SourceLocation place) {
    Diagnostic first = e.diagnostics().get(0);
    return Diagnostic.of(CampaignRules.FORMULA, first.message(), place).withHint(first.hint());
  }

  private static Optional<NumberFormulas.Quantity> formula(
      ObjectReader part, String key, List<String> names) {
    String formula =
        part.value(key)
            .filter(JsonNode::isNumber)
            .map(number -> number.decimalValue().toPlainString())
            .orElseGet(() -> part.requiredText(key));
    if (formula.isEmpty()) {
      return Optional.empty();
    }
    try {
      SourceRange range = SourceText.within(part.at(key), formula).whole();
      return Optional.of(new NumberFormulas(names).quantity(range));
    } catch (DiagnosticException e) {
      part.find(wrong(e, part.at(key)));
      return Optional.empty();
    }
  }

  /**
   * Requires of each factor and of what is computed that the scenario or a formula reads it; not
   * where a formula is wrong, of which nobody knows what it reads.
   */
  private void requireUse(Optional<Points> points, Set<String> readByConditions) {
    if (!complete) {
      return;
    }
    Set<String> read = new HashSet<>(readByConditions);
    computed.forEach(each -> read.addAll(each.formula().names()));
    points.ifPresent(it -> read.addAll(it.names()));
    Map<String, SourceLocation> idle = new LinkedHashMap<>();
    factors.stream()
        .filter(each -> each.paths().isEmpty())
        .forEach(each -> idle.put(each.name(), each.place()));
    computed.stream()
        .filter(each -> each.paths().isEmpty())
        .forEach(each -> idle.put(each.name(), each.place()));
    idle.keySet().removeAll(read);
    idle.values()
        .forEach(
            place ->
                section.find(
                    Diagnostic.of(CampaignRules.KEY_MISSING, "'path' is missing.", place)
                        .withHint(
                            "Write the number of the scenario that it is, such as ego.speed_kmh, or"
                                + " read it in a formula under `computed` or a condition.")));
  }
}
