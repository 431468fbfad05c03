package dev.eventchain.output;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * A file name relative to an output folder that cannot lead out of it on any operating system.
 *
 * @param value normalised name, segments separated by {@code /}; empty if the name is refused
 * @param problem the reason for the refusal, as the end of a sentence; empty if there is none
 */
public record OutputPath(String value, String problem) {
  /** Folder for the records of an output folder. */
  static final String RESERVED = ".eventchain";

  private static final int LONGEST_SEGMENT = 255;
  private static final int LONGEST_PATH = 3_000;
  private static final int SHORT_NAME = 200;
  private static final Pattern DRIVE = Pattern.compile("[A-Za-z]:.*", Pattern.DOTALL);

  /** Returns the path of a name from a template or a user. */
  public static OutputPath of(String name) {
    if (isPlain(name)) {
      return new OutputPath(name, "");
    }
    String problem = problemOfWhole(name);
    List<String> segments = new ArrayList<>();
    for (String segment : name.split("/", -1)) {
      if (problem.isEmpty()) {
        problem = problemOfSegment(segment);
      }
      if (!segment.isEmpty() && !segment.equals(".")) {
        segments.add(segment);
      }
    }
    if (problem.isEmpty()) {
      problem = problemOfPlace(name, segments);
    }
    return problem.isEmpty()
        ? new OutputPath(String.join("/", segments), "")
        : new OutputPath("", problem);
  }

  /**
   * Returns whether a name is short and has only ASCII letters, digits, underscores, single dots
   * and single slashes.
   */
  private static boolean isPlain(String name) {
    boolean afterLetter = false;
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      boolean letter =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
      if (!letter && !((c == '.' || c == '/') && afterLetter)) {
        return false;
      }
      afterLetter = letter;
    }
    return afterLetter && name.length() <= SHORT_NAME;
  }

  /** Returns whether the name is invalid in every output folder. */
  public boolean refused() {
    return !problem.isEmpty();
  }

  /**
   * Returns the error {@code output.path.refused} for a refused name, without a location.
   *
   * @param name the original name
   */
  public Diagnostic refusal(String name) {
    return Diagnostic.of(
            OutputRules.OUTPUT_PATH_REFUSED,
            "The file name '" + shown(name) + "' " + problem + ".",
            SourceLocation.NONE)
        .withHint("Files are named relative to the output folder and stay below it.");
  }

  /** Returns the displayed name: control characters as escapes, very long names shortened. */
  public static String shown(String name) {
    StringBuilder shown = new StringBuilder();
    name.codePoints()
        .limit(120)
        .forEach(
            c -> {
              if (Character.isISOControl(c)) {
                shown.append(String.format(Locale.ROOT, "\\u%04x", c));
              } else {
                shown.appendCodePoint(c);
              }
            });
    return name.length() > shown.length() && name.length() > 120 ? shown + "..." : shown.toString();
  }

  private static String problemOfWhole(String name) {
    if (name.isBlank()) {
      return "is empty";
    }
    if (name.startsWith("/") || DRIVE.matcher(name).matches()) {
      return "is absolute";
    }
    if (name.indexOf('\\') >= 0) {
      return "contains a backslash";
    }
    if (name.chars().anyMatch(Character::isISOControl)) {
      return "contains a control character";
    }
    return bytes(name) > LONGEST_PATH ? "is longer than " + LONGEST_PATH + " bytes" : "";
  }

  private static String problemOfSegment(String segment) {
    if (segment.equals("..")) {
      return "contains '..'";
    }
    return bytes(segment) > LONGEST_SEGMENT
        ? "has a part longer than " + LONGEST_SEGMENT + " bytes"
        : "";
  }

  private static String problemOfPlace(String name, List<String> segments) {
    if (segments.isEmpty() || name.endsWith("/")) {
      return "names a folder";
    }
    return segments.get(0).equalsIgnoreCase(RESERVED) ? "is reserved for " + RESERVED : "";
  }

  private static int bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8).length;
  }
}
