package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Factor;
import dev.eventchain.pipeline.campaign.plan.Sampling;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The values of factors that no scenario takes. */
final class RefusedValues {

  private static final int MOST_TRIED = 200;

  /** The most cases of which one has to be a case with another value, too. */
  private static final int MOST_CASES = 32;

  private final CampaignPlan plan;
  private final SearchSpace space;
  private final Consumer<CampaignCase> reader;
  private final Function<String, Optional<String>> pointers;

  /**
   * Asks of the cases of a campaign whether they can be read.
   *
   * @param reader reads a case, or ends by a {@link DiagnosticException}
   * @param pointers where a path leads, as in the location of a finding
   */
  RefusedValues(
      CampaignPlan plan,
      Consumer<CampaignCase> reader,
      Function<String, Optional<String>> pointers) {
    this.plan = plan;
    this.space = new SearchSpace(plan);
    this.reader = reader;
    this.pointers = pointers;
  }

  /** Returns a finding for each factor with a value that is refused, or for the first row. */
  List<Diagnostic> findings() {
    return plan.sampling().kind() == Sampling.Kind.ROWS ? rows() : values();
  }

  /**
   * Returns a finding for each factor with a value that no scenario takes, with the others as they
   * are first, as far as that is a case. Of very many values, some are tried, the first and the
   * last among them.
   */
  private List<Diagnostic> values() {
    List<CampaignCase> cases = cases();
    if (cases.isEmpty()) {
      return List.of();
    }
    List<Diagnostic> problems = problems(cases.get(0));
    if (!problems.isEmpty()) {
      return ofFirst(cases.get(0), problems);
    }
    List<Diagnostic> found = new ArrayList<>();
    for (int i = 0; i < plan.factors().size(); i++) {
      Factor factor = plan.factors().get(i);
      for (BigDecimal value : some(factor.levels().checked())) {
        Optional<CampaignCase> with = with(cases, i, value);
        List<Diagnostic> refused = with.map(this::problems).orElse(List.of());
        if (!refused.isEmpty()) {
          boolean first = with.get().equals(cases.get(0).with(i, value));
          String words = first ? words(factor, value) : with.get().words(plan);
          found.add(finding(words, refused.get(0), factor.place()));
          break;
        }
      }
    }
    return found;
  }

  /** Returns some cases that the conditions keep, of which that with the first values is first. */
  private List<CampaignCase> cases() {
    List<BigDecimal> first =
        plan.factors().stream().map(factor -> factor.levels().checked().get(0)).toList();
    CampaignCase usual = new CampaignCase(first, 1);
    if (plan.conditions().isEmpty()) {
      return List.of(usual);
    }
    try {
      return Stream.concat(Stream.of(usual), space.tried().stream())
          .filter(this::isCase)
          .limit(MOST_CASES)
          .toList();
    } catch (DiagnosticException e) {
      return isCase(usual) ? List.of(usual) : List.of(); // a condition has no value
    }
  }

  /** Returns the first of some cases that is one with another value, too. */
  private Optional<CampaignCase> with(List<CampaignCase> cases, int factor, BigDecimal value) {
    return cases.stream().map(each -> each.with(factor, value)).filter(this::isCase).findFirst();
  }

  /** Returns whether the conditions keep it; if they have no value, its problem is that. */
  private boolean isCase(CampaignCase each) {
    try {
      return space.keeps(each);
    } catch (DiagnosticException e) {
      return true;
    }
  }

  /**
   * Returns what is wrong with the first values of all factors, each at those that it is about:
   * every case has the same problem, which is none of the other factors.
   */
  private List<Diagnostic> ofFirst(CampaignCase usual, List<Diagnostic> problems) {
    List<Diagnostic> found = new ArrayList<>();
    for (int i = 0; i < plan.factors().size(); i++) {
      Factor factor = plan.factors().get(i);
      String words = words(factor, usual.values().get(i));
      about(problems, factor.paths())
          .ifPresent(each -> found.add(finding(words, each, factor.place())));
    }
    plan.computed()
        .forEach(
            computed ->
                about(problems, computed.paths())
                    .ifPresent(
                        each -> found.add(finding(usual.words(plan), each, computed.place()))));
    if (found.isEmpty()) {
      SourceLocation place =
          plan.factors().stream()
              .findFirst()
              .map(Factor::place)
              .orElse(SourceLocation.of(plan.file()));
      found.add(finding(usual.words(plan), problems.get(0), place));
    }
    return found;
  }

  /** Returns the first problem at the places of some paths. */
  private Optional<Diagnostic> about(List<Diagnostic> problems, List<String> paths) {
    List<String> places = paths.stream().flatMap(path -> pointers.apply(path).stream()).toList();
    return problems.stream().filter(it -> places.contains(it.location().element())).findFirst();
  }

  /** Returns a finding for the first row that no scenario takes. */
  private List<Diagnostic> rows() {
    for (CampaignCase row : some(new CaseList(plan).cases())) {
      List<Diagnostic> problems = problems(row);
      if (!problems.isEmpty()) {
        return List.of(finding(row.words(plan), problems.get(0), SourceLocation.of(plan.file())));
      }
    }
    return List.of();
  }

  private static String words(Factor factor, BigDecimal value) {
    return factor.name() + " = " + value.toPlainString();
  }

  private static Diagnostic finding(String with, Diagnostic problem, SourceLocation place) {
    return Diagnostic.of(
        CampaignRules.FACTOR,
        "With " + with + ": " + problem.message() + " " + problem.location().element(),
        place);
  }

  private List<Diagnostic> problems(CampaignCase each) {
    try {
      reader.accept(each);
      return List.of();
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
  }

  /** Returns some of very many values, the first and the last among them. */
  static <T> List<T> some(List<T> values) {
    int last = values.size() - 1;
    int most = Math.min(last, MOST_TRIED);
    return IntStream.rangeClosed(0, most)
        .mapToObj(i -> values.get(most == 0 ? 0 : (int) ((long) i * last / most)))
        .toList();
  }
}
