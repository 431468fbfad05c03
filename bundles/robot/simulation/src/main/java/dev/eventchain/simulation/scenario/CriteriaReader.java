package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Reads the section {@code accept} of a scenario. */
public final class CriteriaReader {

  private static final NumberRange TOLERANCE = NumberRange.of(0, 10);
  private static final NumberRange LIMIT = NumberRange.of(0, 1000);

  /** Range of the reaction time, in s; a command that is two seconds late counts as missing. */
  private static final NumberRange REACTION = NumberRange.of(0, 2);

  private CriteriaReader() {}

  /**
   * Reads the criteria in the order of their kinds, including those of every scenario; formulas
   * come last.
   */
  static List<Expectation> read(ObjectReader section, FormulasReader formulas) {
    List<Expectation> all = read(section, formulas, true);
    boolean formulasAreWritten =
        section.value("formulas").filter(JsonNode::isArray).filter(it -> !it.isEmpty()).isPresent();
    if (!formulasAreWritten && all.stream().allMatch(CriteriaReader::isAlwaysAsked)) {
      section.find(
          ScenarioRules.KEY_MISSING,
          "Nothing is asked of the software in this scenario.",
          section.location());
    }
    section.refuseOthers();
    return all;
  }

  private static boolean isAlwaysAsked(Expectation expectation) {
    return expectation instanceof Criterion criterion && criterion.kind().always();
  }

  /**
   * Reads only the criteria that are present, in the same order; there may be none, and other keys.
   */
  public static List<Expectation> readWritten(ObjectReader section, FormulasReader formulas) {
    return read(section, formulas, false);
  }

  private static List<Expectation> read(
      ObjectReader section, FormulasReader formulas, boolean withUsual) {
    Criterion.Tolerances usual = Criterion.Tolerances.USUAL;
    Criterion.Tolerances tolerances =
        new Criterion.Tolerances(
            section.number("tolerance_ttc_s", TOLERANCE).orElse(usual.timeToCollision()),
            section.number("tolerance_reaction_s", REACTION).orElse(usual.reaction()));
    List<Criterion> criteria = new ArrayList<>();
    for (CriterionKind kind : CriterionKind.values()) {
      if (kind.always() ? withUsual : section.has(kind.key())) {
        Criterion criterion = criterion(section, kind, tolerances);
        criteria.add(kind.always() ? criterion : named(section, criterion, formulas));
      }
    }
    List<ObjectReader> written = section.objects("formulas");
    List<Expectation> named = NamedFormulas.read(section, formulas);
    formulas.requirements().refuseOthers(section);
    formulas.optional().refuseOthers(section);
    checkTolerance(section, tolerances, criteria);
    List<Expectation> all = new ArrayList<>(criteria);
    all.addAll(named);
    all.addAll(formulas.read(written));
    return all;
  }

  private static Criterion named(
      ObjectReader section, Criterion criterion, FormulasReader formulas) {
    String key = criterion.kind().key();
    formulas.optional().ofKey(section, key);
    return criterion.testing(formulas.requirements().ofKey(section, key));
  }

  /** Checks that a tolerance is less than its limit, or every command would pass. */
  private static void checkTolerance(
      ObjectReader section, Criterion.Tolerances tolerances, List<Criterion> criteria) {
    criteria.stream()
        .filter(each -> each.kind().comparesTimeToCollision())
        .filter(each -> each.limit() <= tolerances.timeToCollision())
        .findFirst()
        .ifPresent(
            each ->
                section.find(
                    ScenarioRules.VALUE_RANGE,
                    String.format(
                        Locale.ROOT,
                        "A tolerance of %.1f s leaves nothing of the limit of %.1f s.",
                        tolerances.timeToCollision(),
                        each.limit()),
                    section.at("tolerance_ttc_s")));
  }

  private static Criterion criterion(
      ObjectReader section, CriterionKind kind, Criterion.Tolerances tolerances) {
    if (kind.always()) {
      return new Criterion(kind, 0, tolerances, section.location());
    }
    double limit = 0;
    if (kind.hasLimit()) {
      limit = section.requiredNumber(kind.key(), LIMIT) * kind.unit();
    } else {
      section.requireTrue(kind.key());
    }
    return new Criterion(kind, limit, tolerances, section.atKey(kind.key()));
  }
}
