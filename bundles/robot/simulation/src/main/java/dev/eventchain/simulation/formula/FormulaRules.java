package dev.eventchain.simulation.formula;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about formulas in scenarios and benches. */
final class FormulaRules {

  static final Rule BENCH_FORMULA_SIGNAL = Rule.error("bench.formula.signal");
  static final Rule BENCH_FORMULA_SYNTAX =
      Rule.error("bench.formula.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule BENCH_FORMULA_UNIT = Rule.error("bench.formula.unit");
  static final Rule SCENARIO_FORMULA_CONSTANT = Rule.error("scenario.formula.constant");
  static final Rule SCENARIO_FORMULA_SIGNAL = Rule.error("scenario.formula.signal");
  static final Rule SCENARIO_FORMULA_SYNTAX =
      Rule.error("scenario.formula.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule SCENARIO_FORMULA_UNIT = Rule.error("scenario.formula.unit");

  private FormulaRules() {}
}
