package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.arxml.ArxmlLimits.NoNumberException;
import dev.eventchain.catalogue.signal.CatalogueUnits;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The texts of units: their display names, or what follows from their physical dimensions. */
final class ArxmlUnits {

  private static final Map<String, String> SYMBOLS =
      Map.of(
          "LENGTH-EXP", "m",
          "MASS-EXP", "kg",
          "TIME-EXP", "s",
          "CURRENT-EXP", "A",
          "TEMPERATURE-EXP", "K",
          "LUMINOUS-INTENSITY-EXP", "cd");

  /** Symbols in the order in which units have them. */
  private static final List<String> EXPONENTS =
      List.of(
          "MASS-EXP",
          "LENGTH-EXP",
          "TIME-EXP",
          "CURRENT-EXP",
          "TEMPERATURE-EXP",
          "LUMINOUS-INTENSITY-EXP");

  /** Units by the unit of the SI, the factor from that one on, and the offset after it. */
  private static final Map<String, String> OTHERS =
      Map.of(
          "m.s-1 3.6 0", "km/h",
          "s 1000 0", "ms",
          "m 1000 0", "mm",
          "m 100 0", "cm",
          "m 0.001 0", "km",
          "K 1 -273.15", "degC");

  private final ArxmlTree tree;
  private final ArxmlUnread unread;

  ArxmlUnits(ArxmlTree tree, ArxmlUnread unread) {
    this.tree = tree;
    this.unread = unread;
  }

  /**
   * Returns the text of the unit to which the first reference leads; empty without one, and for one
   * that stands for none.
   */
  Optional<String> of(ArxmlElement properties) throws NoNumberException {
    Optional<ArxmlElement> unit = tree.follow(properties, Set.of("UNIT"), "UNIT-REF");
    return unit.isEmpty()
        ? Optional.empty()
        : Optional.of(text(unit.get())).filter(it -> !CatalogueUnits.isNone(it));
  }

  private String text(ArxmlElement unit) throws NoNumberException {
    Optional<String> display = unit.text("DISPLAY-NAME");
    if (display.isPresent()) {
      return display.get();
    }
    Optional<String> derived = derived(unit);
    if (derived.isEmpty()) {
      unread.note(ArxmlUnread.Kind.UNIT, unit.path(), unit.location());
    }
    return derived.orElse("");
  }

  private Optional<String> derived(ArxmlElement unit) throws NoNumberException {
    Optional<ArxmlElement> dimension =
        tree.follow(unit, Set.of("PHYSICAL-DIMENSION"), "PHYSICAL-DIMENSION-REF");
    if (dimension.isEmpty() || dimension.get().first("MOLAR-AMOUNT-EXP").isPresent()) {
      return Optional.empty();
    }
    List<String> parts = new ArrayList<>();
    for (String exponent : EXPONENTS) {
      BigDecimal power = number(dimension.get(), exponent, BigDecimal.ZERO);
      if (power.signum() != 0) {
        String written = power.compareTo(BigDecimal.ONE) == 0 ? "" : power.toPlainString();
        parts.add(SYMBOLS.get(exponent) + written);
      }
    }
    String base = String.join(".", parts);
    BigDecimal factor = number(unit, "FACTOR-SI-TO-UNIT", BigDecimal.ONE);
    BigDecimal offset = number(unit, "OFFSET-SI-TO-UNIT", BigDecimal.ZERO);
    String scale = factor.toPlainString() + " " + offset.toPlainString();
    return scale.equals("1 0") && !base.isEmpty()
        ? Optional.of(base)
        : Optional.ofNullable(OTHERS.get(base + " " + scale));
  }

  private static BigDecimal number(ArxmlElement element, String tag, BigDecimal otherwise)
      throws NoNumberException {
    Optional<ArxmlElement> number = element.first(tag);
    return number.isEmpty() ? otherwise : ArxmlScaling.trimmed(ArxmlLimits.number(number.get()));
  }
}
