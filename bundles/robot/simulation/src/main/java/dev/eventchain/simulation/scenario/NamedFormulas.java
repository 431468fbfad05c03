package dev.eventchain.simulation.scenario;

import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.scenario.FormulaCriterion.Form;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Reads the criteria with keys of their own that are formulas: time gap and lane offset, and
 * settling and overshoot of any signal.
 */
final class NamedFormulas {

  private static final NumberRange TIME_GAP = NumberRange.of(0, 10);
  private static final NumberRange OFFSET = NumberRange.of(0, 10);
  private static final NumberRange SECONDS = NumberRange.of(0, 600);

  private final ObjectReader section;
  private final FormulasReader formulas;
  private final List<Expectation> criteria = new ArrayList<>();

  private NamedFormulas(ObjectReader section, FormulasReader formulas) {
    this.section = section;
    this.formulas = formulas;
  }

  /** Reads the criteria in a section {@code accept}. */
  static List<Expectation> read(ObjectReader section, FormulasReader formulas) {
    NamedFormulas named = new NamedFormulas(section, formulas);
    named.limit(
        "minimal_time_gap_s",
        TIME_GAP,
        Form.WRITTEN,
        "always (ego.speed > 1 m/s implies gap / ego.speed >= %s s)");
    named.limit("maximal_lane_offset_m", OFFSET, Form.GOAL, "always abs(ego.offset) <= %s m");
    section.objects("settles").forEach(named::settles);
    section.objects("overshoots").forEach(named::overshoots);
    return named.criteria;
  }

  private void limit(String key, NumberRange range, Form form, String pattern) {
    OptionalDouble limit = section.number(key, range);
    if (limit.isPresent()) {
      String text = pattern.formatted(BigDecimal.valueOf(limit.getAsDouble()).toPlainString());
      List<String> tested = formulas.requirements().ofKey(section, key);
      formulas.optional().ofKey(section, key);
      formulas.parse(section, key, key, form, text, tested).ifPresent(criteria::add);
    }
  }

  /** Reads the criterion that a signal stays near its target from a time on. */
  private void settles(ObjectReader part) {
    String signal = part.requiredText("signal");
    String target = part.requiredText("at");
    String band = part.requiredText("within");
    double from = part.requiredNumber("from_s", SECONDS);
    List<String> tested = formulas.tested(part, "signal");
    part.refuseOthers();
    add(
        part,
        tested,
        Form.SETTLES,
        "%s settles at %s".formatted(signal, target),
        "always[%s, %s] abs((%s) - (%s)) <= %s"
            .formatted(plain(from), plain(formulas.duration()), signal, target, band));
  }

  /** Reads the criterion that a rising signal reaches its target with limited overshoot. */
  private void overshoots(ObjectReader part) {
    String signal = part.requiredText("signal");
    String target = part.requiredText("at");
    String most = part.requiredText("at_most");
    List<String> tested = formulas.tested(part, "signal");
    part.refuseOthers();
    add(
        part,
        tested,
        Form.WRITTEN,
        "%s overshoots %s by at most %s".formatted(signal, target, most),
        "(eventually abs((%1$s) - (%2$s)) <= %3$s) and (always (%1$s) - (%2$s) <= %3$s)"
            .formatted(signal, target, most));
  }

  private void add(ObjectReader part, List<String> tested, Form form, String name, String text) {
    if (!text.contains("()") && !text.endsWith("<= ") && !text.contains("<= )")) {
      formulas.parse(part, "signal", name, form, text, tested).ifPresent(criteria::add);
    }
  }

  /** Formats a number as a multiple of 10 ms, without an exponent. */
  private static String plain(double number) {
    return BigDecimal.valueOf(number)
        .setScale(2, RoundingMode.DOWN)
        .stripTrailingZeros()
        .toPlainString();
  }
}
