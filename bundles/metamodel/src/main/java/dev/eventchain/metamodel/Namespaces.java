package dev.eventchain.metamodel;

import dev.eventchain.diagnostics.NearestName;
import java.util.Collection;
import java.util.List;
import java.util.regex.Pattern;

/** What to do about a namespace that no loaded metamodel has. */
final class Namespaces {

  /** A version as people write it into a namespace: {@code 1.0}, {@code v2}, {@code 2024}. */
  private static final Pattern VERSION = Pattern.compile("[vV]?[0-9]+([._-][0-9]+)*");

  private static final String LOAD = "Name its metamodel with --metamodel FILE.ecore.";

  private Namespaces() {}

  /** Names the loaded version of the same metamodel, else the nearest namespace. */
  static String hint(String unknown, Collection<String> known) {
    String name = withoutVersion(unknown);
    List<String> versions =
        known.stream().filter(uri -> withoutVersion(uri).equals(name)).sorted().toList();
    if (!versions.isEmpty()) {
      return "The file was written for another version: `%s` is loaded. %s"
          .formatted(
              String.join("`, `", versions),
              "Migrate the file, or name its own metamodel with --metamodel FILE.ecore.");
    }
    String nearest = NearestName.hint(unknown, known);
    return nearest.isEmpty() ? LOAD : nearest + " " + LOAD;
  }

  private static String withoutVersion(String uri) {
    return VERSION.matcher(uri).replaceAll("#");
  }
}
