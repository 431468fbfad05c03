package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.CaseCriteria;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Conditions;
import dev.eventchain.pipeline.campaign.plan.Points;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Criteria that a campaign file gives to the cases of a campaign, put into their scenarios. */
final class CriteriaOfCases {

  private static final String ACCEPT = "accept";

  private final CampaignPlan plan;
  private final List<Some> some = new ArrayList<>();

  /** Criteria that only some cases have. */
  private record Some(CaseCriteria criteria, Conditions conditions) {}

  /**
   * Reads the conditions on the cases that have them.
   *
   * @throws DiagnosticException (INPUT) if one cannot be read
   */
  CriteriaOfCases(CampaignPlan plan) {
    this.plan = plan;
    for (CaseCriteria each : plan.criteria()) {
      if (!each.areOfAll()) {
        some.add(new Some(each, new Conditions(plan, each.conditions())));
      }
    }
  }

  /**
   * Adds the criteria that all cases have to a scenario, without those that it has already.
   *
   * @throws DiagnosticException (INPUT) if it says something else
   */
  ObjectNode withThoseOfAll(ObjectNode scenario) {
    plan.criteria().stream().filter(CaseCriteria::areOfAll).forEach(each -> add(scenario, each));
    return scenario;
  }

  /** Returns a copy of a scenario with the criteria that only some cases have, among them one. */
  ObjectNode with(ObjectNode scenario, CampaignCase each) {
    ObjectNode copy = scenario.deepCopy();
    those(each).forEach(criteria -> add(copy, criteria));
    return copy;
  }

  private List<CaseCriteria> those(CampaignCase each) {
    return some.stream().filter(it -> it.conditions().keep(each)).map(Some::criteria).toList();
  }

  private static void add(ObjectNode scenario, CaseCriteria criteria) {
    merge(scenario.withObject("/" + ACCEPT), criteria.accept(), criteria.place());
  }

  /** Adds what an object lacks to it, to its arrays and to the objects in it. */
  private static void merge(ObjectNode all, ObjectNode added, SourceLocation place) {
    for (Map.Entry<String, JsonNode> each : added.properties()) {
      JsonNode before = all.get(each.getKey());
      if (before == null) {
        all.set(each.getKey(), each.getValue().deepCopy());
      } else if (before.isArray() && each.getValue().isArray()) {
        each.getValue().forEach(element -> append((ArrayNode) before, element));
      } else if (before.isObject() && each.getValue().isObject()) {
        merge((ObjectNode) before, (ObjectNode) each.getValue(), place);
      } else if (!isSame(before, each.getValue())) {
        String words = "'%s' is %s here, and %s elsewhere for the same cases.";
        throw new DiagnosticException(
            DiagnosticException.Reason.INPUT,
            finding(words.formatted(each.getKey(), each.getValue(), before), place)
                .withHint("Write it in one place, or give each to other cases by 'where'."));
      }
    }
  }

  private static void append(ArrayNode all, JsonNode element) {
    for (JsonNode each : all) {
      if (each.equals(element)) {
        return;
      }
    }
    all.add(element.deepCopy());
  }

  private static boolean isSame(JsonNode one, JsonNode other) {
    boolean numbers = one.isNumber() && other.isNumber();
    return numbers ? one.decimalValue().compareTo(other.decimalValue()) == 0 : one.equals(other);
  }

  /** Returns a finding for each criterion on which points depend, and that is none of a case. */
  static List<Diagnostic> unknown(Points points, List<String> texts) {
    return points.criteria().stream()
        .filter(named -> texts.stream().noneMatch(text -> text.startsWith(named)))
        .map(
            named ->
                finding("No criterion of the cases begins with '" + named + "'.", points.place())
                    .withHint(NearestName.hint(named, texts)))
        .toList();
  }

  /** Returns whether a finding on the scenario of a case is about criteria. */
  static boolean isAbout(Diagnostic finding) {
    return finding.is(CampaignRules.CRITERIA)
        || finding.location().element().startsWith("/" + ACCEPT);
  }

  private static Diagnostic finding(String message, SourceLocation place) {
    return Diagnostic.of(CampaignRules.CRITERIA, message, place);
  }

  /**
   * Returns a finding for each of the criteria that no case has, and for those that cannot be put
   * together in one.
   *
   * @param reader returns what is wrong with the criteria of a case
   */
  List<Diagnostic> check(Function<CampaignCase, Optional<Diagnostic>> reader) {
    if (plan.criteria().isEmpty()) {
      return List.of();
    }
    Map<List<CaseCriteria>, CampaignCase> kinds = new LinkedHashMap<>();
    for (CampaignCase each : new CaseList(plan).cases()) {
      kinds.putIfAbsent(those(each), each);
    }
    List<Diagnostic> found = new ArrayList<>();
    for (Some each : some) {
      if (kinds.keySet().stream().noneMatch(those -> those.contains(each.criteria()))) {
        String message = "No case of '" + plan.name() + "' meets these conditions.";
        found.add(finding(message, each.criteria().place()));
      }
    }
    kinds.forEach((those, first) -> problem(those, first, reader).ifPresent(found::add));
    return found.stream().distinct().toList();
  }

  private Optional<Diagnostic> problem(
      List<CaseCriteria> those,
      CampaignCase first,
      Function<CampaignCase, Optional<Diagnostic>> reader) {
    CaseCriteria last = those.isEmpty() ? plan.criteria().get(0) : those.get(those.size() - 1);
    return reader
        .apply(first)
        .map(
            problem ->
                problem.is(CampaignRules.CRITERIA)
                    ? problem
                    : finding("With " + first.words(plan) + ": " + problem.message(), last.place())
                        .withHint(problem.hint()));
  }
}
