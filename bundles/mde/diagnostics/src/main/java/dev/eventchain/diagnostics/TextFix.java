package dev.eventchain.diagnostics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A change of a file's text that fixes a finding.
 *
 * @param start the offset of the first character to replace
 * @param end the offset after the last one
 * @param by the replacement
 */
public record TextFix(int start, int end, String by) {

  /** The question by which hints propose a name similar to an unknown one. */
  private static final Pattern MEANT = Pattern.compile("Did you mean `([^`]+)`\\?");

  private static final Pattern QUOTED = Pattern.compile("[`']([^`']+)[`']");

  /** Name in a message, quoted or not: topics are not quoted. */
  private static final Pattern NAME = Pattern.compile("[\\w/][\\w/.:-]*[\\w]");

  private static final Set<String> XML = Set.of("xmi", "eventchain", "ecore");

  /** Returns the name that a hint proposes, if any. */
  public static Optional<String> meant(String hint) {
    Matcher question = MEANT.matcher(hint);
    return question.find() ? Optional.of(question.group(1)) : Optional.empty();
  }

  /**
   * Replaces the unknown name in the message by the similar name that the hint proposes.
   *
   * @param text the file's text
   * @param offset the offset of the finding
   * @param extension that of the file
   * @return empty if the replacement is ambiguous: the text has changed, or contains the name twice
   *     there
   */
  public static Optional<TextFix> nearestName(
      String text, int offset, String extension, String message, String hint) {
    Optional<String> meant = meant(hint);
    if (meant.isEmpty() || offset < 0 || offset > text.length()) {
      return Optional.empty();
    }
    int from = begin(text, offset, extension);
    int to = end(text, offset, extension);
    List<TextFix> found = new ArrayList<>();
    Matcher named = NAME.matcher(message);
    while (named.find()) {
      String wrong = named.group();
      boolean near =
          !wrong.equals(meant.get()) && NearestName.of(wrong, Set.of(meant.get())).isPresent();
      if (near) {
        find(text, from, to, wrong).ifPresent(at -> add(found, at, wrong, meant.get()));
      }
    }
    return found.size() == 1 ? Optional.of(found.get(0)) : Optional.empty();
  }

  /**
   * Removes the reference to a missing element from the start tag at an offset.
   *
   * @param message the message, which quotes the reference as in the file
   */
  public static Optional<TextFix> withoutReference(String text, int offset, String message) {
    Matcher quoted = QUOTED.matcher(message);
    if (!quoted.find() || offset < 0 || offset > text.length()) {
      return Optional.empty();
    }
    String wrong = Pattern.quote(quoted.group(1));
    Matcher attribute =
        Pattern.compile("\\s+[\\w:.-]+=([\"'])" + wrong + "\\1")
            .matcher(text)
            .region(begin(text, offset, "xmi"), end(text, offset, "xmi"));
    return attribute.find()
        ? Optional.of(new TextFix(attribute.start(), attribute.end(), ""))
        : Optional.empty();
  }

  /** Returns the text after the change. */
  public String apply(String text) {
    return text.substring(0, start) + by + text.substring(end);
  }

  private static void add(List<TextFix> found, int at, String wrong, String meant) {
    TextFix fix = new TextFix(at, at + wrong.length(), meant);
    if (!found.contains(fix)) {
      found.add(fix);
    }
  }

  /** Returns the only offset of a name between two offsets; empty if there are several. */
  private static Optional<Integer> find(String text, int from, int to, String name) {
    Matcher place =
        Pattern.compile("(?<![\\w/])" + Pattern.quote(name) + "(?!\\w)")
            .matcher(text)
            .region(from, to);
    if (!place.find()) {
      return Optional.empty();
    }
    int first = place.start();
    return place.find() ? Optional.empty() : Optional.of(first);
  }

  /** Returns the offset of the start tag, or else of the line. */
  private static int begin(String text, int offset, String extension) {
    return XML.contains(extension)
        ? Math.max(0, text.lastIndexOf('<', Math.min(offset, text.length() - 1)))
        : text.lastIndexOf('\n', Math.max(0, offset - 1)) + 1;
  }

  private static int end(String text, int offset, String extension) {
    int end = text.indexOf(XML.contains(extension) ? '>' : '\n', offset);
    return end < 0 ? text.length() : end;
  }
}
