package dev.eventchain.pipeline.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The section {@code strength} of a project: the part of the standard faults of its components that
 * each requirement has to notice.
 *
 * @param measured false if the project does not want strength to be measured
 * @param minimum the least part for each requirement, in percent; 0 asks for one fault only
 * @param own the least part for some requirements, in percent, by identifier
 */
public record StrengthSettings(boolean measured, double minimum, SortedMap<String, Double> own) {

  /** The settings of a project that states none. */
  public static final StrengthSettings DEFAULT = new StrengthSettings(true, 0, new TreeMap<>());

  private static final String KEY = "strength";
  private static final NumberRange PERCENT = NumberRange.of(0, 100);

  /** Copies the map. */
  public StrengthSettings {
    own = new TreeMap<>(own);
  }

  static StrengthSettings read(ObjectReader settings) {
    for (boolean on : new boolean[] {true, false}) {
      if (settings.value(KEY).filter(value -> isSwitch(value, on)).isPresent()) {
        return new StrengthSettings(on, 0, new TreeMap<>());
      }
    }
    return settings.object(KEY).map(StrengthSettings::section).orElse(DEFAULT);
  }

  private static boolean isSwitch(JsonNode value, boolean on) {
    return value.isTextual()
        ? value.asText().equals(on ? "on" : "off")
        : value.isBoolean() && value.asBoolean() == on;
  }

  private static StrengthSettings section(ObjectReader section) {
    double minimum = section.number("minimum_percent", PERCENT).orElse(0);
    SortedMap<String, Double> own = new TreeMap<>();
    section
        .object("requirements")
        .ifPresent(
            each -> each.names().forEach(id -> own.put(id, each.requiredNumber(id, PERCENT))));
    section.refuseOthers();
    return new StrengthSettings(true, minimum, own);
  }

  /** Returns the least part that a requirement has to notice, in percent. */
  public double minimumOf(String requirement) {
    return own.getOrDefault(requirement, minimum);
  }

  /** Returns the settings as a value for fingerprints. */
  public Map<String, Double> asValue() {
    SortedMap<String, Double> all = new TreeMap<>(own);
    all.put("", measured ? minimum : -1);
    return all;
  }
}
