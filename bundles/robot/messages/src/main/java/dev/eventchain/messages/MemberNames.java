package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** Naming rules for fields and constants of ROS 2 messages (rosidl_adapter). */
public final class MemberNames {

  private static final Pattern FIELD = Pattern.compile("[a-z][a-z0-9]*(_[a-z0-9]+)*");
  private static final Pattern CONSTANT = Pattern.compile("[A-Z][A-Z0-9]*(_[A-Z0-9]+)*");

  /**
   * Keywords of Python (language reference, 2.3.1); a message class has an attribute for each
   * field.
   */
  private static final List<String> KEYWORDS =
      List.of(
          "False",
          "None",
          "True",
          "and",
          "as",
          "assert",
          "async",
          "await",
          "break",
          "class",
          "continue",
          "def",
          "del",
          "elif",
          "else",
          "except",
          "finally",
          "for",
          "from",
          "global",
          "if",
          "import",
          "in",
          "is",
          "lambda",
          "nonlocal",
          "not",
          "or",
          "pass",
          "raise",
          "return",
          "try",
          "while",
          "with",
          "yield");

  private MemberNames() {}

  /** Returns the keywords of Python, which are not allowed as names in any definition language. */
  public static List<String> keywords() {
    return KEYWORDS;
  }

  /** Returns the error in a field name of the message language; empty if it is valid. */
  static Optional<Diagnostic> problemOfField(String name, SourceLocation place) {
    if (FIELD.matcher(name).matches()) {
      return problemOfKeyword(name, place);
    }
    return Optional.of(
        problem("'" + name + "' cannot be the name of a field.", place)
            .withHint(
                "Use lower-case letters, digits and single underscores between them, a letter"
                    + " first: max_speed."));
  }

  /** Returns the error in a constant name of the message language; empty if it is valid. */
  static Optional<Diagnostic> problemOfConstant(String name, SourceLocation place) {
    if (CONSTANT.matcher(name).matches()) {
      return Optional.empty();
    }
    return Optional.of(
        problem("'" + name + "' cannot be the name of a constant.", place)
            .withHint(
                "Use capital letters, digits and single underscores between them, a letter first:"
                    + " MAX_SPEED. A field's default has no equals sign: int32 speed 5."));
  }

  /** Returns an error if a name is a keyword of Python, for any definition language. */
  static Optional<Diagnostic> problemOfKeyword(String name, SourceLocation place) {
    return KEYWORDS.contains(name)
        ? Optional.of(
            problem("'" + name + "' is a keyword of Python.", place)
                .withHint("Rename it: message classes have an attribute of this name."))
        : Optional.empty();
  }

  private static Diagnostic problem(String message, SourceLocation place) {
    return Diagnostic.of(MessageRules.NAME, message, place);
  }
}
