package dev.eventchain.ocl.parse;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Rewords the parser's syntax messages in terms of the language instead of its grammar. */
public final class SyntaxTexts {

  private static final Pattern RULE_NAME =
      Pattern.compile("\"(\\w*(?:CS|WithLet|NotLet|Not)\\w*)\"");
  private static final Pattern MISSING = Pattern.compile("missing \"(.*)\" to complete scope");
  private static final Pattern INVALID_TOKEN =
      Pattern.compile("(?:[\\d:]+ )?token (\\S+) is invalid");
  private static final Pattern UNEXPECTED = Pattern.compile("(.*) unexpected token\\(s\\)");
  private static final Pattern OPERATOR_EXPECTED =
      Pattern.compile("\"(?:[*+/=|<>:-]|::|\\.|->)\" expected instead of (\".*\")");
  private static final Pattern UNKNOWN_CHARACTER =
      Pattern.compile("[\\d:]+ (.*) unexpected character ignored");

  private static final String DOUBLE_QUOTE = "\"\"\"";

  private SyntaxTexts() {}

  static String message(String message) {
    Matcher missing = MISSING.matcher(message);
    Matcher unexpected = UNEXPECTED.matcher(message);
    Matcher invalid = INVALID_TOKEN.matcher(message);
    Matcher character = UNKNOWN_CHARACTER.matcher(message);
    Matcher operator = OPERATOR_EXPECTED.matcher(message);
    String text;
    if (missing.matches()) {
      String what = missing.group(1).replaceAll("\\w*CS\\b", "...").replace("OclExpression", "...");
      text = "'" + what + "' is missing to end what starts here.";
    } else if (unexpected.matches()) {
      text = unexpected.group(1) + " is not expected here.";
    } else if (operator.matches()) {
      // Any operator would do; the parser names one of them.
      text = operator.group(1) + " is not expected here.";
    } else if (invalid.matches()) {
      text = invalid.group(1) + " is a keyword; as a name it is written with _ before it.";
    } else if (character.matches()) {
      text =
          character.group(1).equals(DOUBLE_QUOTE)
              ? "A double quote is not a character of OCL."
              : character.group(1) + " is not a character of OCL.";
    } else {
      text = RULE_NAME.matcher(message).replaceAll(m -> described(m.group(1)));
      text = text.replaceFirst(" expected ", " is expected ");
      text = Character.toUpperCase(text.charAt(0)) + text.substring(1) + ".";
    }
    return text.replace('"', '\'');
  }

  private static String described(String ruleName) {
    return ruleName.contains("Name") ? "a name" : "an expression";
  }

  /** Returns a hint for a message of the parser; empty if there is none. */
  static String hint(String message) {
    return message.contains("endif") ? "Write if ... then ... else ... endif." : "";
  }

  private static boolean isOfTheParser(StackTraceElement[] trace) {
    return trace.length > 0 && trace[0].getClassName().startsWith("org.eclipse.ocl.");
  }

  /** Returns the failure of the parser, in words that follow "The expression". */
  public static String unread(Throwable e) {
    return e instanceof StackOverflowError
        ? "is nested too deeply."
        : e instanceof ClassCastException && isOfTheParser(e.getStackTrace())
            ? "has a type where the parser takes only its name, such as Tuple(...) as an argument."
            : "cannot be read: " + e.getMessage();
  }
}
