package dev.eventchain.eclipse.ui.wizards;

import java.util.Locale;

/** The names of chains: a lower-case letter, then such letters, digits and underscores. */
final class ChainNames {

  private ChainNames() {}

  /** The name that is nearest to a project's or file's: {@code Radar AEB} is {@code radar_aeb}. */
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
