package dev.eventchain.ocl;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Says what the parser says about syntax in words of the language instead of its grammar. */
final class SyntaxTexts {

  private static final Pattern RULE_NAME =
      Pattern.compile("\"(\\w*(?:CS|WithLet|NotLet|Not)\\w*)\"");
  private static final Pattern MISSING = Pattern.compile("missing \"(.*)\" to complete scope");
  private static final Pattern INVALID_TOKEN = Pattern.compile("token (\\S+) is invalid");
  private static final Pattern UNEXPECTED = Pattern.compile("(.*) unexpected token\\(s\\)");
  private static final Pattern UNKNOWN_CHARACTER =
      Pattern.compile("[\\d:]+ (.*) unexpected character ignored");
  private static final Pattern UNTYPED_LET = Pattern.compile("let\\s+\\w+\\s*=");
  private static final Pattern INFIX =
      Pattern.compile("[\\w)\\]]\\s+(mod|div|max|min|concat|size|first)\\s+[\\w(]");

  private SyntaxTexts() {}

  static String message(String message) {
    Matcher missing = MISSING.matcher(message);
    Matcher unexpected = UNEXPECTED.matcher(message);
    Matcher invalid = INVALID_TOKEN.matcher(message);
    Matcher character = UNKNOWN_CHARACTER.matcher(message);
    String text;
    if (missing.matches()) {
      String what = missing.group(1).replaceAll("\\w*CS\\b", "...").replace("OclExpression", "...");
      text = "'" + what + "' is missing to end what starts here.";
    } else if (unexpected.matches()) {
      text = unexpected.group(1) + " is not expected here.";
    } else if (invalid.matches()) {
      text = invalid.group(1) + " is a keyword; as a name it is written with _ before it.";
    } else if (character.matches()) {
      text = character.group(1) + " is no character of OCL.";
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

  /** What is probably meant, by the text around an error. */
  static String hint(String text, int offset, int start, int end) {
    String before =
        text.substring(Math.max(start, Math.min(offset, end) - 12), Math.min(offset, end));
    String after = text.substring(Math.min(offset, end), Math.min(end, offset + 40));
    if (after.startsWith("?.") || after.startsWith("?->")) {
      return "Safe navigation is not part of this OCL: write x <> null implies x.y ...";
    } else if (UNTYPED_LET.matcher(after).lookingAt()
        || UNTYPED_LET.matcher(before + after).find()) {
      return "A variable needs a type: let name : Type = ... in ...";
    }
    Matcher infix = INFIX.matcher(before + after);
    if (infix.find()) {
      return "'" + infix.group(1) + "' is called with a dot: a." + infix.group(1) + "(...).";
    } else if (after.startsWith("==") || after.startsWith("!=")) {
      return "Equality is written = and inequality <>.";
    } else if (after.startsWith("&") || after.startsWith("!")) {
      return "The operators are written and, or, not, implies.";
    }
    return "";
  }
}
