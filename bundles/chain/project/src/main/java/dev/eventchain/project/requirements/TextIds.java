package dev.eventchain.project.requirements;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Ids in texts: {@code REQ-001}, {@code SYS_BRAKE_12}, {@code FR1.2}. */
final class TextIds {

  /** Names under which texts say what a requirement comes from. */
  static final List<String> PARENTS =
      List.of("parent", "parents", "derived from", "derives from", "traces to");

  private static final String PARTS = "[A-Za-z][A-Za-z0-9]{0,40}(?:[-_./][A-Za-z0-9]{1,40}){0,8}";
  private static final String ID =
      "(?:"
          + PARTS
          + "[-_./][0-9]{1,20}[A-Za-z]?(?:[-_.][0-9]{1,20}){0,8}|[A-Z]{1,5}[0-9]{1,5}(?:\\.[0-9]{1,20}){0,8})";

  private static final Pattern WHOLE = Pattern.compile(ID);
  private static final Pattern HEADING =
      Pattern.compile("[\\[(*`]*(" + ID + ")(?![A-Za-z0-9_]|-[A-Za-z0-9])[\\])*`]*(.*)");
  private static final Pattern MARK = Pattern.compile("\\s*+(?:[:|]|[-–—](?=\\s))");
  private static final Pattern LINE =
      Pattern.compile(
          "(?:[*`\\[]+("
              + ID
              + ")[:.]?[*`\\]]+\\s*[-:–—]*|("
              + ID
              + ")\\s*(?::|[-–—](?=\\s)))\\s*(.*)");
  private static final Pattern SEVERAL =
      Pattern.compile(
          "\\s*(?:,|&|/|and\\b|to\\b|\\.{2,3}|…|–|-)\\s*[\\[(*`]*(" + ID + ")(?![A-Za-z0-9]).*");
  private static final Pattern FACT =
      Pattern.compile("[:*_\\s]*+([A-Za-z][A-Za-z ]{2,20}?)[*_\\s]*+:[*_\\s]*+(.*)");
  private static final Pattern TAG = Pattern.compile("<[^<>]*+>");
  private static final Pattern ANCHOR = Pattern.compile("\\{#[^{}]*+\\}$");
  private static final Pattern LINK = Pattern.compile("\\[([^\\[\\]]*+)\\](\\([^()]*+\\))?");
  private static final Pattern ROLE = Pattern.compile("(?::[A-Za-z_-]{1,40}){1,3}:`([^`]*+)`");
  private static final Pattern PREFIX =
      Pattern.compile("(.{0,200}?[A-Za-z])[-_./]?[0-9][0-9A-Za-z._-]{0,200}");

  private TextIds() {}

  /** An id, and what follows it. */
  record Named(String id, String text) {}

  /** Returns whether a text is an id. */
  static boolean isId(String text) {
    return WHOLE.matcher(plain(text)).matches();
  }

  /** Returns the id with which a heading begins, and all behind it. */
  static Optional<Named> ofHeading(String text) {
    String named = ANCHOR.matcher(unescaped(text)).replaceFirst("");
    Matcher found = HEADING.matcher(TAG.matcher(named).replaceAll("").strip());
    return found.matches()
        ? Optional.of(new Named(found.group(1), found.group(2)))
        : Optional.empty();
  }

  /** Returns whether a heading sets an id apart: by brackets, emphasis, a colon or a dash. */
  static boolean isMarked(String text, Named heading) {
    return "[(*`".indexOf(text.strip().charAt(0)) >= 0 || MARK.matcher(heading.text()).lookingAt();
  }

  /** Returns the id with which a line begins that goes on with its text. */
  static Optional<Named> ofLine(String text) {
    Matcher found = LINE.matcher(unescaped(text));
    if (!found.matches()) {
      return Optional.empty();
    }
    String id = found.group(1) == null ? found.group(2) : found.group(1);
    return Optional.of(new Named(id, found.group(3).strip()));
  }

  /** Returns whether what follows an id is another one of its kind. */
  static boolean isAnother(Named heading) {
    Matcher other = SEVERAL.matcher(heading.text());
    return other.matches() && prefix(other.group(1)).equals(prefix(heading.id()));
  }

  /** Returns the name and the value of a line such as {@code **Status:** approved}. */
  static Optional<Named> ofFact(String line) {
    Matcher found = FACT.matcher(line);
    return found.matches()
        ? Optional.of(
            new Named(
                found.group(1).strip().toLowerCase(Locale.ROOT), withoutEnd(found.group(2), "*_")))
        : Optional.empty();
  }

  /** Returns the part in front of an id's number; empty if there is none. */
  static Optional<String> prefix(String id) {
    Matcher found = PREFIX.matcher(id);
    return found.matches() ? Optional.of(found.group(1)) : Optional.empty();
  }

  /** Returns a text without the backslashes in front of characters that ids may have. */
  private static String unescaped(String text) {
    return text.replaceAll("\\\\([_.-])", "$1");
  }

  /** Returns a text without emphasis, links, roles and anchors. */
  static String plain(String text) {
    String plain = TAG.matcher(unescaped(text)).replaceAll("");
    plain = LINK.matcher(plain).replaceAll("$1");
    return ROLE.matcher(plain).replaceAll("$1").replaceAll("[*`]", "").strip();
  }

  /** Returns a text without blanks and some characters at its end. */
  static String withoutEnd(String text, String characters) {
    int end = text.length();
    while (end > 0
        && (Character.isWhitespace(text.charAt(end - 1))
            || characters.indexOf(text.charAt(end - 1)) >= 0)) {
      end--;
    }
    return text.substring(0, end);
  }
}
