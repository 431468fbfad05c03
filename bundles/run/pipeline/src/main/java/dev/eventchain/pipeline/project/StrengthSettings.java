package dev.eventchain.pipeline.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.simulation.verdict.StrengthBudget;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The section {@code strength} of a project: how many of the standard faults of its components are
 * driven, and the part of these that each requirement has to notice.
 *
 * @param extent whether all of them are driven, a sample, or none
 * @param budget the simulated time that a sample may take, in s
 * @param minimum the least part for each requirement, in percent; 0 asks for one fault only
 * @param own the least part for some requirements, in percent, by identifier
 */
public record StrengthSettings(
    StrengthExtent extent, double budget, double minimum, SortedMap<String, Double> own) {

  /** The settings of a project that states none. */
  public static final StrengthSettings DEFAULT = of(StrengthExtent.SAMPLE);

  private static final String KEY = "strength";
  private static final String EXTENT = "extent";
  private static final NumberRange PERCENT = NumberRange.of(0, 100);
  private static final NumberRange SECONDS = NumberRange.above(0);

  /** Copies the map. */
  public StrengthSettings {
    own = new TreeMap<>(own);
  }

  private static StrengthSettings of(StrengthExtent extent) {
    return new StrengthSettings(extent, StrengthBudget.USUAL, 0, new TreeMap<>());
  }

  static StrengthSettings read(ObjectReader settings) {
    Optional<StrengthExtent> extent = settings.value(KEY).flatMap(StrengthSettings::extent);
    return extent.isPresent()
        ? of(extent.get())
        : settings.object(KEY).map(StrengthSettings::section).orElse(DEFAULT);
  }

  private static Optional<StrengthExtent> extent(JsonNode value) {
    boolean isOn = value.isBoolean() ? value.asBoolean() : value.asText().equals("on");
    if (isOn) {
      return Optional.of(StrengthExtent.SAMPLE);
    }
    return value.isBoolean() ? Optional.of(StrengthExtent.OFF) : StrengthExtent.of(value.asText());
  }

  private static StrengthSettings section(ObjectReader section) {
    StrengthExtent extent = section.has(EXTENT) ? driven(section) : StrengthExtent.SAMPLE;
    double budget = section.number("budget_s", SECONDS).orElse(StrengthBudget.USUAL);
    double minimum = section.number("minimum_percent", PERCENT).orElse(0);
    SortedMap<String, Double> own = new TreeMap<>();
    section
        .object("requirements")
        .ifPresent(
            each -> each.names().forEach(id -> own.put(id, each.requiredNumber(id, PERCENT))));
    section.refuseOthers();
    return new StrengthSettings(extent, budget, minimum, own);
  }

  /** Reads the extent of a section, which says what is asked of the measurement. */
  private static StrengthExtent driven(ObjectReader section) {
    String word = section.requiredText(EXTENT);
    Optional<StrengthExtent> extent =
        StrengthExtent.of(word).filter(each -> each != StrengthExtent.OFF);
    if (extent.isEmpty() && !word.isEmpty()) {
      section.find(
          ProjectSettings.RULES.range(),
          "'extent' is 'whole' or 'sample', not '" + word + "'.",
          section.at(EXTENT));
    }
    return extent.orElse(StrengthExtent.SAMPLE);
  }

  /** Returns the least part that a requirement has to notice, in percent. */
  public double minimumOf(String requirement) {
    return own.getOrDefault(requirement, minimum);
  }

  /** Returns the budget of a measurement to an extent; infinite for all faults. */
  public StrengthBudget budget(StrengthExtent wanted) {
    double seconds = wanted == StrengthExtent.WHOLE ? Double.POSITIVE_INFINITY : budget;
    return new StrengthBudget(seconds, this::minimumOf);
  }

  /** Returns the settings as a value for fingerprints. */
  public Map<String, Object> asValue() {
    return new TreeMap<>(
        Map.of("extent", extent, "budget", budget, "minimum", minimum, "requirements", own));
  }
}
