package dev.eventchain.diagnostics;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** Places as SARIF has them. */
final class SarifPlaces {

  /** What relative file names are relative to: the folder that the program was started in. */
  static final String BASE = "SRCROOT";

  private static final int LONGEST_SNIPPET = 200;
  private static final String PLAIN =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";

  private SarifPlaces() {}

  /** The members of a location. */
  static void location(SourceLocation place, JsonText json) throws IOException {
    if (!place.file().isEmpty()) {
      json.object("physicalLocation", physical -> physicalLocation(place, physical));
    }
    if (!place.element().isEmpty()) {
      json.array(
          "logicalLocations",
          all ->
              all.object(
                  members -> members.text("fullyQualifiedName", Printable.clean(place.element()))));
    }
  }

  private static void physicalLocation(SourceLocation place, JsonText json) throws IOException {
    json.object("artifactLocation", members -> artifact(place.file(), members));
    json.object("region", region -> region(place, region));
  }

  /** The members of an artifact location. */
  static void artifact(String file, JsonText json) throws IOException {
    json.text("uri", uri(file));
    if (!file.startsWith("/")) {
      json.text("uriBaseId", BASE);
    }
  }

  private static void region(SourceLocation place, JsonText json) throws IOException {
    // Viewers want a line for each finding; one about a whole file is put to the first.
    json.number("startLine", Math.max(1, place.line()));
    json.numberIfKnown("startColumn", place.column());
    String line = place.excerpt();
    int from = Math.min(Math.max(place.column() - 1, 0), line.length());
    int to = Math.min(line.length(), from + LONGEST_SNIPPET);
    if (to < line.length() && Character.isHighSurrogate(line.charAt(to - 1))) {
      to--;
    }
    if (from < to) {
      // Without a start the snippet begins with the line, and so does the region.
      json.number("endColumn", to + 1);
      String snippet = Printable.excerpt(line.substring(from, to));
      json.object("snippet", members -> members.text("text", snippet));
    }
  }

  /** A file's name as a URI, absolute if the name is. */
  static String uri(String file) {
    StringBuilder uri = new StringBuilder(file.startsWith("/") ? "file://" : "");
    for (byte b : file.getBytes(StandardCharsets.UTF_8)) {
      if (PLAIN.indexOf((char) (b & 0xff)) >= 0) {
        uri.append((char) b);
      } else {
        uri.append(String.format(Locale.ROOT, "%%%02X", b & 0xff));
      }
    }
    return uri.toString();
  }
}
