package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;

/** Writer of SARIF locations. */
final class SarifPlaces {

  /** Base of relative file names: the working folder of the program. */
  static final String BASE = "SRCROOT";

  private static final int LONGEST_SNIPPET = 200;
  private static final String PLAIN =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";

  private SarifPlaces() {}

  /** Writes the members of a location. */
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

  /** Writes the members of an artifact location. */
  static void artifact(String file, JsonText json) throws IOException {
    String name = nameOf(file);
    json.text("uri", uri(name));
    if (!name.startsWith("/")) {
      json.text("uriBaseId", BASE);
    }
  }

  /**
   * Returns the name of a file: relative inside the working folder, otherwise absolute. Viewers
   * show nothing for a relative name that leaves its base.
   */
  private static String nameOf(String file) {
    String workingFolder = SourceLocation.nameOf(Path.of("").toAbsolutePath());
    String base = workingFolder.endsWith("/") ? workingFolder : workingFolder + "/";
    boolean absolute = file.startsWith("/");
    if (!absolute && !(file + "/").startsWith("../")) {
      return file;
    }
    Deque<String> steps = new ArrayDeque<>();
    for (String step : (absolute ? file : base + file).split("/", -1)) {
      if (step.equals("..")) {
        steps.pollLast();
      } else if (!step.isEmpty() && !step.equals(".")) {
        steps.add(step);
      }
    }
    String name = "/" + String.join("/", steps);
    if ((name + "/").equals(base)) {
      return ".";
    }
    return name.startsWith(base) ? name.substring(base.length()) : name;
  }

  /**
   * Returns a file name for fingerprints, relative where possible, so that it is the same on every
   * machine.
   */
  static String fingerprintOf(String file) {
    String name = nameOf(file);
    return uri(name.startsWith("/") ? file : name);
  }

  private static void region(SourceLocation place, JsonText json) throws IOException {
    // Viewers require a line; a finding about a whole file gets the first.
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

  /** Returns a file name as a URI, absolute if the name is. */
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
