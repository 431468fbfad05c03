package dev.eventchain.eclipse.ui.wizards;

import java.util.Locale;

/** Names of chains: a lower-case letter, then lower-case letters, digits and underscores. */
final class ChainNames {

  private ChainNames() {}

  /**
   * Returns the valid name closest to that of a project or file: {@code radar_aeb} for {@code Radar
   * AEB}.
   */
  static String of(String name) {
    String plain =
        name.toLowerCase(Locale.ROOT)
            .replaceAll("[^a-z0-9]+", "_")
            .replaceAll("^[^a-z]+", "")
            .replaceAll("_+$", "");
    return plain.isEmpty() ? "chain" : plain;
  }

  static boolean isValid(String name) {
    return name.matches("[a-z][a-z0-9_]*");
  }
}
