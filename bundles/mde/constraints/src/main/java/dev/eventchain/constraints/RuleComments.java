package dev.eventchain.constraints;

import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The annotations in the comments above an invariant: {@code -- @severity warning}, {@code
 * -- @message text with {expressions}}, {@code -- @hint text}. A following comment line that starts
 * with more than one space continues the text.
 */
final class RuleComments {

  private static final Pattern COMMENT = Pattern.compile("^[ \\t]*--(.*)$", Pattern.MULTILINE);
  private static final Pattern BLANK_LINE =
      Pattern.compile("(?>\\r\\n|\\r|\\n)[ \\t]*(?>\\r\\n|\\r|\\n)");
  private static final Pattern ANNOTATION = Pattern.compile(" ?@(\\w+)[ \\t]*(.*)");
  private static final List<String> KEYWORDS = List.of("severity", "message", "hint");

  private final SourceText source;
  private final List<Diagnostic> problems;
  private Severity severity = Severity.ERROR;
  private final StringBuilder message = new StringBuilder();
  private final StringBuilder hint = new StringBuilder();
  private SourceRange messageStart;
  private String last = "";
  private final String own;
  private final String context;
  private final List<RuleComments> repeated = new ArrayList<>();

  private RuleComments(RuleDocument.Clause clause, List<Diagnostic> problems) {
    this.source = clause.text().source();
    this.problems = problems;
    this.own = PlainComment.in(clause.ownComment());
    this.context = PlainComment.in(clause.contextComment());
  }

  /** Reads the comments above an invariant and its context; the invariant's own have priority. */
  static RuleComments read(RuleDocument.Clause clause, List<Diagnostic> problems) {
    RuleComments comments = new RuleComments(clause, problems);
    clause.comments().forEach(comments::readBlock);
    return comments;
  }

  /** Adds the comments above the same invariant in another document. */
  void addRepeated(RuleDocument.Clause clause) {
    repeated.add(new RuleComments(clause, new ArrayList<>()));
  }

  /** Returns those ids that the invariant's comment names, or else the comment of its context. */
  Set<String> named(Collection<String> ids) {
    List<String> byItself = PlainComment.named(own, ids);
    Set<String> named =
        new LinkedHashSet<>(byItself.isEmpty() ? PlainComment.named(context, ids) : byItself);
    repeated.forEach(each -> named.addAll(each.named(ids)));
    return named;
  }

  /** Reads the lines between the last blank line and the end. */
  private void readBlock(SourceRange part) {
    Matcher blank = BLANK_LINE.matcher(source.text()).region(part.start(), part.end());
    int start = part.start();
    while (blank.find()) {
      start = blank.end();
      blank.region(start - 1, part.end());
    }
    Matcher lines = COMMENT.matcher(source.text()).region(start, part.end());
    lines.useAnchoringBounds(false);
    while (lines.find()) {
      readLine(lines.group(1).stripTrailing(), lines.start(1));
    }
    last = "";
  }

  /** Returns the severity of violations. */
  Severity severity() {
    return severity;
  }

  /** Returns the text of the message; empty for the default. */
  String message() {
    return message.toString();
  }

  /** Returns the first line of the message as written; {@code null} if there is none. */
  SourceRange messageStart() {
    return messageStart;
  }

  /** Returns the hint; empty if there is none. */
  String hint() {
    return hint.toString();
  }

  private void readLine(String line, int offset) {
    Matcher annotation = ANNOTATION.matcher(line);
    if (annotation.matches()) {
      read(annotation.group(1), annotation.group(2), offset + annotation.start(2));
    } else if (line.startsWith("  ") && !line.isBlank()) {
      switch (last) {
        case "message" -> message.append(' ').append(line.strip());
        case "hint" -> hint.append(' ').append(line.strip());
        default -> {}
      }
    } else {
      last = "";
    }
  }

  private void read(String keyword, String text, int offset) {
    last = keyword;
    switch (keyword) {
      case "severity" -> readSeverity(text, offset);
      case "message" -> {
        message.setLength(0);
        message.append(text);
        messageStart = source.range(offset, offset + text.length());
      }
      case "hint" -> {
        hint.setLength(0);
        hint.append(text);
      }
      default ->
          NearestName.of(keyword, KEYWORDS)
              .ifPresent(
                  meant ->
                      problems.add(
                          Diagnostic.of(
                                  ConstraintRules.ANNOTATION,
                                  "The annotation '@" + keyword + "' is not known.",
                                  source.at(offset))
                              .withSeverity(Severity.WARNING)
                              .withHint("Did you mean `@" + meant + "`?")));
    }
  }

  private void readSeverity(String text, int offset) {
    switch (text.strip().toLowerCase(Locale.ROOT)) {
      case "error" -> severity = Severity.ERROR;
      case "warning" -> severity = Severity.WARNING;
      case "info" -> severity = Severity.INFO;
      default ->
          problems.add(
              Diagnostic.of(
                      ConstraintRules.ANNOTATION,
                      "'" + text.strip() + "' is not a severity.",
                      source.at(offset))
                  .withHint("Write error, warning or info."));
    }
  }
}
