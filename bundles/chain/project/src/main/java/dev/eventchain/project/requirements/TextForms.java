package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Requirements whose ids have a form that is not read, such as {@code REQ 1} or {@code 4.2}, or are
 * in a place that is not read: each kind is a finding, since nobody would notice what is lost.
 */
final class TextForms {

  private static final Pattern WORD =
      Pattern.compile(
          "[\\[(*`]*+([A-Z][A-Za-z]{0,20}[ :#–—_]{1,2}[0-9][0-9A-Za-z._-]{0,30})[\\])*`:.]*+(.*)");
  private static final Pattern NUMBER =
      Pattern.compile("([0-9]{1,5}(?:\\.[0-9]{1,5}){1,8})[.):]?+(\\s.*)");

  /** Marks in front of a text: of quotations, lists and tasks, tags and symbols. */
  private static final Pattern MARKS =
      Pattern.compile(
          "(?:[>\\s]++|(?:[-*+]|[0-9]{1,9}[.)]|\\[[ xX]\\])\\s|<[^<>]*+>|\\p{So}){0,20}+(.*)");

  private static final Pattern EMPHASIS =
      Pattern.compile(
          "(?<![A-Za-z0-9_])_{1,2}(?=[A-Za-z0-9])|(?<=[A-Za-z0-9])_{1,2}(?![A-Za-z0-9_])");
  private static final Pattern SENTENCE =
      Pattern.compile("[.)]?\\s+\\p{Lu}.*|\\s*+(?:[|:=→>–—]|-\\s).*");

  private final Map<String, List<Found>> found = new LinkedHashMap<>();

  /** Heading that may be that of a requirement; empty if it is none. */
  private Optional<Found> heading = Optional.empty();

  private record Found(String id, SourceLocation place) {}

  /** Looks through the blocks of a text. */
  void see(SourceText source, List<TextBlock> blocks) {
    heading = Optional.empty();
    look(source, blocks);
  }

  private void look(SourceText source, List<TextBlock> blocks) {
    for (TextBlock block : blocks) {
      if (block instanceof TextBlock.Heading it) {
        String text = it.text().strip();
        heading =
            TextIds.ofHeading(text).isPresent()
                ? Optional.empty()
                : form(text)
                    .or(() -> atEnd(text))
                    .map(id -> new Found(id.id(), source.at(it.line(), 1)));
      } else if (block instanceof TextBlock.Lines it) {
        for (int i = 0; i < it.lines().size(); i++) {
          line(it.lines().get(i), source.at(it.line() + i, 1));
        }
      } else if (block instanceof TextBlock.Included it) {
        look(it.source(), it.blocks());
      } else {
        heading = Optional.empty();
      }
    }
  }

  private void line(String line, SourceLocation place) {
    Matcher marks = MARKS.matcher(line);
    String text = EMPHASIS.matcher(marks.matches() ? marks.group(1) : line).replaceAll("");
    if (TextIds.ofLine(line).isPresent()) {
      heading = Optional.empty();
    } else if (TextIds.ofLine(text).isPresent()) {
      add(TextIds.ofLine(text).get().id(), place);
    } else {
      TextIds.ofHeading(text)
          .or(() -> form(text))
          .filter(it -> SENTENCE.matcher(it.text()).matches() && isRequired(it.text()))
          .ifPresent(it -> add(it.id(), place));
      heading.filter(it -> isRequired(line)).ifPresent(it -> add(it.id(), it.place()));
    }
  }

  private static boolean isRequired(String text) {
    return TextKinds.isRequirement(text);
  }

  private static Optional<TextIds.Named> form(String text) {
    Matcher word = WORD.matcher(text);
    Matcher number = NUMBER.matcher(text);
    Matcher any = word.matches() ? word : number;
    return any == word || number.matches()
        ? Optional.of(new TextIds.Named(any.group(1), any.group(2)))
        : Optional.empty();
  }

  /** Returns the id in brackets at the end of a heading: {@code Braking (REQ-1)}. */
  private static Optional<TextIds.Named> atEnd(String text) {
    int bracket = Math.max(text.lastIndexOf('('), text.lastIndexOf('['));
    String id = TextIds.withoutEnd(text.substring(bracket + 1), ")]");
    return bracket >= 0 && TextIds.isId(id)
        ? Optional.of(new TextIds.Named(id, ""))
        : Optional.empty();
  }

  private void add(String id, SourceLocation place) {
    String kind = id.split("[^A-Za-z]", 2)[0];
    heading = Optional.empty();
    if (!TextKinds.isName(id) && !TextKinds.isName(kind + "-1")) {
      found.computeIfAbsent(kind, it -> new ArrayList<>()).add(new Found(id, place));
    }
  }

  /**
   * Reports what is not read, once for each kind.
   *
   * @param known the ids of items, in lower case
   * @param kinds those of items, of which each mentioned id is looked for
   */
  void report(Reading reading, Set<String> known, Set<String> kinds) {
    for (List<Found> each : found.values()) {
      List<Found> lost =
          each.stream()
              .filter(it -> !known.contains(it.id().toLowerCase(Locale.ROOT)))
              .filter(it -> !(TextIds.isId(it.id()) && kinds.contains(TextKinds.kind(it.id()))))
              .toList();
      if (!lost.isEmpty()) {
        String others = lost.size() == 1 ? "" : " (and " + (lost.size() - 1) + " more like it)";
        reading.unread(
            "'%s'%s is written like the id of a requirement, but not in a form that is read."
                .formatted(lost.get(0).id(), others),
            lost.get(0).place(),
            "If it is one, write a heading '### REQ-1: Title', an item '- REQ-1: text' or a row of a"
                + " table with a column 'ID'.",
            RequirementRules.UNREAD);
      }
    }
  }
}
