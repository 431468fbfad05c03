package dev.eventchain.simulation.measure;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about measurements. */
public final class MeasureRules {

  public static final Rule INPUT_TOO_OLD = Rule.warning("simulation.input.too-old");
  public static final Rule INPUT_RANGE = Rule.warning("simulation.input.range");
  public static final Rule OUTPUT_RANGE =
      Rule.error("simulation.output.range", CommonTrait.UNTESTED);
  public static final Rule VALUE_LATE = Rule.warning("simulation.value.late");
  public static final Rule NODE_SILENT = Rule.error("simulation.node.silent", CommonTrait.UNTESTED);

  private MeasureRules() {}
}
