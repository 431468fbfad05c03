package dev.eventchain.simulation;

import java.util.ArrayList;
import java.util.List;

/** Reads the section {@code accept} of a scenario. */
final class CriteriaReader {

  private CriteriaReader() {}

  /** The criteria in the order of the file, then those that every scenario has. */
  static List<Criterion> read(YamlSection section) {
    Criterion.Tolerances usual = Criterion.Tolerances.USUAL;
    Criterion.Tolerances tolerances =
        new Criterion.Tolerances(
            section.number("tolerance_ttc_s", usual.timeToCollision(), 0, 10),
            section.number("tolerance_reaction_s", usual.reaction(), 0, 10));
    List<Criterion> criteria = new ArrayList<>();
    for (CriterionKind kind : CriterionKind.values()) {
      if (kind.always() || section.has(kind.key())) {
        criteria.add(criterion(section, kind, tolerances));
      }
    }
    if (criteria.stream().allMatch(criterion -> criterion.kind().always())) {
      section.missing("Nothing is asked of the software in this scenario.");
    }
    section.finish();
    return criteria;
  }

  private static Criterion criterion(
      YamlSection section, CriterionKind kind, Criterion.Tolerances tolerances) {
    if (kind.always()) {
      return new Criterion(kind, 0, tolerances, section.location());
    }
    double limit = 0;
    if (kind.hasLimit()) {
      limit = section.requiredNumber(kind.key(), 0, 1000) * kind.unit();
    } else {
      section.requireTrue(kind.key());
    }
    return new Criterion(kind, limit, tolerances, section.location(kind.key()));
  }
}
