package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.diagnostics.ResourceText;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Treatment of an element, an attribute or a value of the standard.
 *
 * @param name {@code Element}, {@code Element@attribute} or {@code Element@attribute=value}
 * @param reason why it is refused or has no effect; may be empty for what is supported
 */
public record Feature(String name, Support support, String reason) {

  private static final Map<String, Feature> ALL = read();

  /** Degree of support by the storyboard. */
  public enum Support {
    SUPPORTED,
    REFUSED,
    NO_EFFECT
  }

  /** Returns all features by name, in the order of their names. */
  public static Map<String, Feature> all() {
    return ALL;
  }

  /** Returns whether something is refused; what the table does not know is not. */
  static boolean isRefused(String name) {
    Feature feature = ALL.get(name);
    return feature != null && feature.support == Support.REFUSED;
  }

  private static Map<String, Feature> read() {
    Map<String, Feature> all = new LinkedHashMap<>();
    ResourceText.of(Feature.class, "/dev/eventchain/openscenario/storyboard/features.tsv")
        .lines()
        .filter(line -> !line.startsWith("#"))
        .map(line -> line.split("\t", 3))
        .forEach(columns -> all.put(columns[0], feature(columns)));
    return Collections.unmodifiableMap(all);
  }

  private static Feature feature(String[] columns) {
    Support support =
        switch (columns[1]) {
          case "supported" -> Support.SUPPORTED;
          case "refused" -> Support.REFUSED;
          case "no effect" -> Support.NO_EFFECT;
          default -> throw new IllegalArgumentException(columns[1]);
        };
    return new Feature(columns[0], support, columns.length > 2 ? columns[2] : "");
  }
}
