package dev.eventchain.model;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Which names the generated Python can carry. The standard rules state this in definitions of
 * {@code metamodel/eventchain.ocl}; here it is read from there for code that cannot evaluate OCL,
 * so that there is one list.
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
   * Whether a name is an ASCII identifier of Python that means nothing else: no keyword, not the
   * first argument of {@code execute()}, nothing that the generated modules use themselves, and not
   * one of the names that begin with two underscores.
   */
  public static boolean isFreeIdentifier(String name) {
    return SHAPE.matcher(name).matches()
        && !KEYWORD.matcher(name).matches()
        && !TAKEN.matcher(name).matches();
  }

  /** The keywords of Python 3, soft ones not among them (Python language reference, 2.3.1). */
  static List<String> keywords() {
    return List.of(IDENTIFIER.get(1).split("\\|"));
  }

  /** The keywords, and the names that the generated modules use themselves. */
  static List<String> reserved() {
    return Stream.concat(keywords().stream(), Stream.of(FREE.get(0).split("\\|")))
        .filter(name -> name.matches("\\w+"))
        .toList();
  }

  /**
   * The patterns that a definition of the standard rules matches names with, in order.
   *
   * @throws IllegalStateException if it has another number of them
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
