package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.SplittableRandom;

/** Makes the cases of a campaign: the same ones for the same file. */
public final class CaseList {

  private static final long MOST = 1_000_000;
  private static final long MOST_PAIRS = 20_000;
  private static final int[] PRIMES = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};

  private final CampaignPlan plan;
  private final Conditions conditions;

  public CaseList(CampaignPlan plan) {
    this.plan = plan;
    this.conditions = new Conditions(plan, plan.conditions());
  }

  /**
   * Returns the cases, in the order of their values.
   *
   * @throws DiagnosticException (INPUT) if there are none, or too many, or if points cannot be
   *     counted for one
   */
  public List<CampaignCase> cases() {
    requireFew();
    Set<List<BigDecimal>> combinations =
        switch (plan.sampling().kind()) {
          case GRID -> grid();
          case ROWS -> rows();
          case PAIRS -> new PairsOfValues(plan, values -> keep(values)).cover();
          default -> drawn();
        };
    List<CampaignCase> cases = new ArrayList<>();
    for (List<BigDecimal> values : combinations) {
      for (int repetition = 1; repetition <= plan.repetitions(); repetition++) {
        cases.add(new CampaignCase(values, repetition));
      }
    }
    if (cases.isEmpty()) {
      throw refused(
          Diagnostic.of(
                  CampaignRules.EMPTY,
                  "No combination of the factors' values is left by the conditions.",
                  SourceLocation.of(plan.file()))
              .withHint("Loosen a condition under 'where', or add values."));
    }
    cases.sort(CampaignCase.ORDER);
    cases.forEach(plan::requirePoints);
    return cases;
  }

  /** Refuses what takes too much memory or time before anything is simulated. */
  private void requireFew() {
    Sampling.Kind kind = plan.sampling().kind();
    double drawn = (double) plan.sampling().cases() * plan.repetitions();
    if (kind.isDrawn() && drawn > MOST) {
      throw tooMany(
          String.format(Locale.ROOT, "These are %.3g cases", drawn), "Draw or repeat fewer.");
    }
    if (kind == Sampling.Kind.ROWS && (double) rowCount() * plan.repetitions() > MOST) {
      throw tooMany("The table has too many rows for these repetitions", "Repeat fewer times.");
    }
    if (kind == Sampling.Kind.HALTON && plan.factors().size() > PRIMES.length) {
      throw tooMany(
          String.format(
              Locale.ROOT, "A Halton sequence has at most %d factors here", PRIMES.length),
          "Use `sampling: {latin_hypercube: 1000}`.");
    }
    if (kind == Sampling.Kind.PAIRS && pairs() > MOST_PAIRS) {
      throw tooMany(
          String.format(Locale.ROOT, "There are %.3g pairs of values", pairs()),
          "Use fewer values.");
    }
  }

  private int rowCount() {
    return plan.factors().stream()
        .mapToInt(factor -> factor.levels() instanceof Levels.Column it ? it.cells().size() : 0)
        .max()
        .orElse(0);
  }

  private double pairs() {
    double pairs = 0;
    double before = 0;
    for (Factor factor : plan.factors()) {
      int values = factor.levels().checked().size();
      pairs += before * values;
      before += values;
    }
    return pairs;
  }

  private DiagnosticException tooMany(String what, String hint) {
    return refused(
        Diagnostic.of(CampaignRules.SIZE, what + ".", SourceLocation.of(plan.file()))
            .withHint(hint));
  }

  private boolean keep(List<BigDecimal> values) {
    return conditions.keep(new CampaignCase(values, 1));
  }

  private Set<List<BigDecimal>> grid() {
    double all = plan.repetitions();
    for (Factor factor : plan.factors()) {
      all *= factor.levels().checked().size();
    }
    if (all > MOST) {
      throw tooMany(
          String.format(
              Locale.ROOT, "The grid has %.3g cases, and at most %d can be simulated", all, MOST),
          "Draw some of them: `sampling: {latin_hypercube: 1000}`.");
    }
    Set<List<BigDecimal>> combinations = new LinkedHashSet<>(List.of(List.of()));
    for (Factor factor : plan.factors()) {
      Set<List<BigDecimal>> longer = new LinkedHashSet<>();
      for (List<BigDecimal> before : combinations) {
        for (BigDecimal value : factor.levels().checked()) {
          List<BigDecimal> values = new ArrayList<>(before);
          values.add(value);
          longer.add(values);
        }
      }
      combinations = longer;
    }
    combinations.removeIf(values -> !keep(values));
    return combinations;
  }

  /** Returns the rows of the table that all factors are columns of. */
  private Set<List<BigDecimal>> rows() {
    List<List<BigDecimal>> columns =
        plan.factors().stream().map(factor -> ((Levels.Column) factor.levels()).cells()).toList();
    Set<List<BigDecimal>> rows = new LinkedHashSet<>();
    for (int i = 0; i < columns.get(0).size(); i++) {
      int row = i;
      rows.add(columns.stream().map(column -> column.get(row)).toList());
    }
    rows.removeIf(values -> !keep(values));
    return rows;
  }

  /** Returns whether the conditions keep a case. */
  public boolean keeps(CampaignCase each) {
    return conditions.keep(each);
  }

  /** Draws combinations; those that the conditions refuse are not drawn again. */
  private Set<List<BigDecimal>> drawn() {
    int cases = plan.sampling().cases();
    SplittableRandom random = new SplittableRandom(plan.seed());
    List<double[]> shares = new ArrayList<>();
    for (int i = 0; i < plan.factors().size(); i++) {
      shares.add(
          switch (plan.sampling().kind()) {
            case HALTON -> halton(cases, PRIMES[i % PRIMES.length]);
            case LATIN_HYPERCUBE -> strata(cases, random);
            default -> random.doubles(cases).toArray();
          });
    }
    Set<List<BigDecimal>> combinations = new LinkedHashSet<>();
    for (int k = 0; k < cases; k++) {
      List<BigDecimal> values = new ArrayList<>();
      for (int i = 0; i < shares.size(); i++) {
        values.add(plan.factors().get(i).levels().at(shares.get(i)[k]));
      }
      if (keep(values)) {
        combinations.add(values);
      }
    }
    return combinations;
  }

  /** Returns one share in each of equal parts, in random order. */
  public static double[] strata(int cases, SplittableRandom random) {
    double[] shares = new double[cases];
    for (int k = 0; k < cases; k++) {
      int other = random.nextInt(k + 1);
      shares[k] = shares[other];
      shares[other] = k;
    }
    for (int k = 0; k < cases; k++) {
      shares[k] = Math.min((shares[k] + random.nextDouble()) / cases, Math.nextDown(1.0));
    }
    return shares;
  }

  /** Returns the beginning of the van der Corput sequence of a base, without its 0. */
  private static double[] halton(int cases, int base) {
    double[] shares = new double[cases];
    for (int k = 0; k < cases; k++) {
      double digit = 1.0 / base;
      for (int rest = k + 1; rest > 0; rest /= base) {
        shares[k] += rest % base * digit;
        digit /= base;
      }
    }
    return shares;
  }

  private static DiagnosticException refused(Diagnostic finding) {
    return new DiagnosticException(DiagnosticException.Reason.INPUT, finding);
  }
}
