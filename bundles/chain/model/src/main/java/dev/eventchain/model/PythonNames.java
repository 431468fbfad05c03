package dev.eventchain.model;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Names that generated Python code can use. The definitions in {@code metamodel/eventchain.ocl} are
 * read, so that code without OCL uses the same list.
 */
public final class PythonNames {

  private static final Pattern LITERALS =
      Pattern.compile("'([^'\\\\]*)'(?:\\s*\\+\\s*'([^'\\\\]*)')*", Pattern.DOTALL);
  private static final Pattern LITERAL = Pattern.compile("'([^']*)'");

  private static final List<String> IDENTIFIER = patterns("isIdentifier", 2);
  private static final List<String> FREE = patterns("isFreeIdentifier", 1);
  private static final Pattern SHAPE = Pattern.compile(IDENTIFIER.get(0));
  private static final Pattern KEYWORD = Pattern.compile(IDENTIFIER.get(1));
  private static final Pattern TAKEN = Pattern.compile(FREE.get(0));

  private PythonNames() {}

  /**
   * Returns whether a name is a free ASCII identifier of Python. It must not be a keyword, the
   * first argument of {@code execute()}, a name used by the generated modules, or a name with two
   * leading underscores.
   */
  public static boolean isFreeIdentifier(String name) {
    return SHAPE.matcher(name).matches()
        && !KEYWORD.matcher(name).matches()
        && !TAKEN.matcher(name).matches();
  }

  /** Returns the keywords of Python 3 without soft ones (Python language reference, 2.3.1). */
  static List<String> keywords() {
    return List.of(IDENTIFIER.get(1).split("\\|"));
  }

  /** Returns the keywords and the names used by the generated modules. */
  static List<String> reserved() {
    return Stream.concat(keywords().stream(), Stream.of(FREE.get(0).split("\\|")))
        .filter(name -> name.matches("\\w+"))
        .toList();
  }

  /**
   * Returns the patterns in a definition of the standard rules, in order.
   *
   * @throws IllegalStateException if their number differs
   */
  private static List<String> patterns(String definition, int number) {
    String document = EventChainMetamodel.constraints().text();
    int start = document.indexOf("def: " + definition + "(");
    int end = document.indexOf("def:", start + 1);
    List<String> patterns = new ArrayList<>();
    String text = document.substring(start, end).replaceAll("--[^\n]*", "");
    for (Matcher sum = LITERALS.matcher(text); sum.find(); ) {
      StringBuilder pattern = new StringBuilder();
      for (Matcher part = LITERAL.matcher(sum.group()); part.find(); ) {
        pattern.append(part.group(1));
      }
      patterns.add(pattern.toString());
    }
    if (patterns.size() != number) {
      throw new IllegalStateException(definition + " has patterns " + patterns);
    }
    return List.copyOf(patterns);
  }
}
