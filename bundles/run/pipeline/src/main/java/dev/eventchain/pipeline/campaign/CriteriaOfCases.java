package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.Document;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.CaseCriteria;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Conditions;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** Criteria that a campaign file gives to the cases of a campaign, put into their scenarios. */
final class CriteriaOfCases {

  private static final String ACCEPT = "accept";

  private final CampaignPlan plan;
  private final Function<String, SourceLocation> places;
  private final List<Some> some = new ArrayList<>();

  /** Source of the finding about two values of the same criterion. */
  private interface Conflict {
    Diagnostic of(String pointer, Map.Entry<String, JsonNode> added, JsonNode before);
  }

  /** Criteria that only some cases have. */
  private record Some(CaseCriteria criteria, Conditions conditions) {}

  /** Creates those of cases whose scenario is in no file. */
  CriteriaOfCases(CampaignPlan plan) {
    this(plan, pointer -> SourceLocation.NONE);
  }

  /**
   * Reads the conditions on the cases that have them.
   *
   * @param places returns the places of values of the scenario by their JSON pointers
   * @throws DiagnosticException (INPUT) if one cannot be read
   */
  CriteriaOfCases(CampaignPlan plan, Function<String, SourceLocation> places) {
    this.plan = plan;
    this.places = places;
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
    List<CaseCriteria> all = ofAll();
    all.forEach(each -> add(scenario, each, all));
    return scenario;
  }

  /** Returns a copy of a scenario with the criteria that only some cases have, among them one. */
  ObjectNode with(ObjectNode scenario, CampaignCase each) {
    ObjectNode copy = scenario.deepCopy();
    List<CaseCriteria> all = new ArrayList<>(ofAll());
    all.addAll(those(each));
    those(each).forEach(criteria -> add(copy, criteria, all));
    return copy;
  }

  private List<CaseCriteria> ofAll() {
    return plan.criteria().stream().filter(CaseCriteria::areOfAll).toList();
  }

  private List<CaseCriteria> those(CampaignCase each) {
    return some.stream().filter(it -> it.conditions().keep(each)).map(Some::criteria).toList();
  }

  /**
   * Adds criteria to a scenario.
   *
   * @param all those that its case has
   */
  private void add(ObjectNode scenario, CaseCriteria criteria, List<CaseCriteria> all) {
    merge(
        scenario.withObject("/" + ACCEPT),
        criteria.accept(),
        "",
        (pointer, added, before) -> {
          String words = "'%s' is %s here, and %s elsewhere for the same cases.";
          return finding(
                  words.formatted(added.getKey(), added.getValue(), before), criteria.place())
              .withRelated(place(pointer, before, all))
              .withHint("Write it in one place, or give each to other cases by 'where'.");
        });
  }

  /** Returns the place of the first criteria that have a value: some of the file, or a scenario. */
  private SourceLocation place(String pointer, JsonNode value, List<CaseCriteria> all) {
    return all.stream()
        .filter(each -> value.equals(each.accept().at(pointer)))
        .map(CaseCriteria::place)
        .findFirst()
        .orElseGet(() -> places.apply("/" + ACCEPT + pointer));
  }

  /**
   * Adds what an object lacks to it, to its arrays and to the objects in it.
   *
   * @param pointer leads to the object
   * @param conflict returns the finding that a value is another one already
   */
  private static void merge(ObjectNode all, ObjectNode added, String pointer, Conflict conflict) {
    for (Map.Entry<String, JsonNode> each : added.properties()) {
      JsonNode before = all.get(each.getKey());
      String here = Document.below(pointer, each.getKey());
      if (before == null) {
        all.set(each.getKey(), each.getValue().deepCopy());
      } else if (before.isArray() && each.getValue().isArray()) {
        each.getValue().forEach(element -> append((ArrayNode) before, element));
      } else if (before.isObject() && each.getValue().isObject()) {
        merge((ObjectNode) before, (ObjectNode) each.getValue(), here, conflict);
      } else if (!isSame(before, each.getValue())) {
        throw new DiagnosticException(
            DiagnosticException.Reason.INPUT, conflict.of(here, each, before));
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

  /** Returns whether a path of a scenario leads to a number of a criterion. */
  static boolean isPath(String path) {
    return path.startsWith(ACCEPT + ".");
  }

  /** Returns whether a finding on the scenario of a case is about criteria. */
  static boolean isAbout(Diagnostic finding) {
    return finding.is(CampaignRules.CRITERIA)
        || finding.location().element().startsWith("/" + ACCEPT);
  }

  static Diagnostic finding(String message, SourceLocation place) {
    return Diagnostic.of(CampaignRules.CRITERIA, message, place);
  }

  /** Returns cases by the criteria that they have. */
  Collection<List<CampaignCase>> kinds(List<CampaignCase> cases) {
    Map<List<CaseCriteria>, List<CampaignCase>> kinds = new LinkedHashMap<>();
    for (CampaignCase each : cases) {
      kinds.computeIfAbsent(those(each), key -> new ArrayList<>()).add(each);
    }
    return kinds.values();
  }

  /**
   * Returns a finding for each kind of cases whose criteria cannot be put together.
   *
   * @param reader returns what is wrong with the criteria of a case
   */
  List<Diagnostic> check(
      List<CampaignCase> cases, Function<CampaignCase, Optional<Diagnostic>> reader) {
    if (plan.criteria().isEmpty()) {
      return List.of();
    }
    return kinds(cases).stream()
        .flatMap(kind -> problem(kind.get(0), reader).stream())
        .distinct()
        .toList();
  }

  /**
   * Returns a finding for each of the criteria of some campaigns that no case has, in none of the
   * campaigns to which the file gives them.
   *
   * @param all the campaigns of the file
   */
  static List<Diagnostic> withoutCase(List<CampaignPlan> some, List<CampaignPlan> all) {
    Set<CaseCriteria> asked = new LinkedHashSet<>();
    some.forEach(plan -> plan.criteria().stream().filter(it -> !it.areOfAll()).forEach(asked::add));
    if (asked.isEmpty()) {
      return List.of();
    }
    all.forEach(plan -> asked.removeAll(met(plan)));
    List<Diagnostic> found = new ArrayList<>();
    for (CaseCriteria each : asked) {
      List<String> names =
          all.stream()
              .filter(plan -> plan.criteria().contains(each))
              .map(plan -> "'" + plan.name() + "'")
              .toList();
      String message = "No case of " + String.join(" or ", names) + " meets these conditions.";
      found.add(finding(message, each.place()));
    }
    return found;
  }

  /** Returns the criteria that cases of a campaign have; all, if nobody can list its cases. */
  private static List<CaseCriteria> met(CampaignPlan plan) {
    if (plan.criteria().isEmpty() || !plan.isListed()) {
      return plan.criteria();
    }
    try {
      List<CampaignCase> cases = new CaseList(plan).cases();
      return new CriteriaOfCases(plan)
          .some.stream()
              .filter(it -> cases.stream().anyMatch(it.conditions()::keep))
              .map(Some::criteria)
              .toList();
    } catch (DiagnosticException e) { // reported where its cases are made
      return plan.criteria();
    }
  }

  /**
   * Returns the cases whose criteria are wrong, those of a kind with the finding on the first one.
   *
   * @param reader returns what is wrong with the criteria of a case
   */
  Map<CampaignCase, Diagnostic> wrong(
      List<CampaignCase> cases, Function<CampaignCase, Optional<Diagnostic>> reader) {
    Map<CampaignCase, Diagnostic> wrong = new LinkedHashMap<>();
    for (List<CampaignCase> kind : kinds(cases)) {
      Optional<Diagnostic> first = Optional.empty();
      for (CampaignCase each : kind) {
        Optional<Diagnostic> problem = problem(each, reader);
        first = first.or(() -> problem);
        if (problem.isPresent()) {
          wrong.put(each, first.get());
        }
      }
    }
    return wrong;
  }

  private Optional<Diagnostic> problem(
      CampaignCase first, Function<CampaignCase, Optional<Diagnostic>> reader) {
    return reader
        .apply(first)
        .map(
            problem ->
                problem.is(CampaignRules.CRITERIA)
                    ? problem
                    : finding("With " + first.words(plan) + ": " + problem.message(), place(first))
                        .withHint(problem.hint()));
  }

  /** Returns the place of the last criteria of a case; without any, that of the campaign file. */
  private SourceLocation place(CampaignCase each) {
    List<CaseCriteria> all = those(each).isEmpty() ? plan.criteria() : those(each);
    return all.isEmpty()
        ? SourceLocation.of(plan.file())
        : all.get(those(each).isEmpty() ? 0 : all.size() - 1).place();
  }
}
