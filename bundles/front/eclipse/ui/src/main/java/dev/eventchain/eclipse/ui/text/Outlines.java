package dev.eventchain.eclipse.ui.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Declarations in a file of constraints or templates, read from its text whether it is valid or
 * not.
 */
public final class Outlines {

  /**
   * A declaration.
   *
   * @param label its label in the outline
   * @param start the offset of the declaration
   * @param end the offset after the head of the declaration
   */
  public record Entry(String label, int start, int end) {}

  private static final String NAME = "[A-Za-z_][\\w]*(?:\\s*::\\s*[A-Za-z_]\\w*)*";

  private static final Pattern CONTEXT = Pattern.compile("\\bcontext\\s+(" + NAME + ")");

  private static final Pattern CONSTRAINT =
      Pattern.compile(
          "\\bcontext\\s+(?<context>"
              + NAME
              + ")|\\b(?<kind>inv|pre|post|def|derive|init|body)\\b[ \\t]*(?<name>[A-Za-z_]\\w*)?"
              + "\\s*(?:\\([^()]*(?:\\([^()]*\\))?[^()]*\\)\\s*)?:");

  private static final Pattern DECLARATION =
      Pattern.compile(
          "\\[\\s*(?<kind>template|query|macro)\\s+(?:(?:public|private|protected)\\s+)?"
              + "(?<name>[A-Za-z_]\\w*)");

  private Outlines() {}

  /** Returns the constraints and definitions, with their contexts. */
  public static List<Entry> constraints(String text) {
    String code = withoutComments(text);
    List<Entry> entries = new ArrayList<>();
    Matcher found = CONSTRAINT.matcher(code);
    String context = "";
    while (found.find()) {
      if (found.group("context") != null) {
        context = found.group("context").replaceAll("\\s", "");
      } else {
        String name = found.group("name") == null ? "" : " " + found.group("name");
        entries.add(
            new Entry(
                "context " + context + " " + found.group("kind") + name,
                found.start(),
                found.end("kind") + name.length()));
      }
    }
    return entries;
  }

  /** Returns the class of the last context before an offset; empty if there is none. */
  static String contextAt(String text, int offset) {
    Matcher found = CONTEXT.matcher(withoutComments(text.substring(0, offset)));
    String context = "";
    while (found.find()) {
      context = found.group(1).replaceAll("\\s", "");
    }
    return context;
  }

  /** Returns the templates, queries and macros. */
  public static List<Entry> templates(String text) {
    List<Entry> entries = new ArrayList<>();
    for (Token part : TemplateTokens.parts(text)) {
      Matcher found = DECLARATION.matcher(text).region(part.start(), part.end());
      if (part.kind() == TokenKind.TAG && found.lookingAt()) {
        String label = found.group("kind") + " " + found.group("name");
        entries.add(new Entry(label, part.start(), found.end()));
      }
    }
    return entries;
  }

  /** Returns the text with comments and strings blanked, so that offsets are preserved. */
  private static String withoutComments(String text) {
    StringBuilder code = new StringBuilder(text);
    for (Token token : OclTokens.of(text, Set.of())) {
      if (token.kind() == TokenKind.COMMENT || token.kind() == TokenKind.STRING) {
        code.replace(token.start(), token.end(), " ".repeat(token.end() - token.start()));
      }
    }
    return code.toString();
  }
}
