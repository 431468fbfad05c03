package dev.eventchain.workspace.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** Substitutions of launch that decide and calculate: {@code $(and ...)}, {@code $(eval ...)}. */
final class LaunchSubstitution {

  private static final Set<String> NAMES =
      Set.of("and", "or", "not", "any", "all", "equals", "not-equals", "if", "eval");

  private LaunchSubstitution() {}

  static boolean isOne(String name) {
    return NAMES.contains(name);
  }

  /**
   * Returns the value of a substitution; empty if it is not known, or launch would refuse it.
   *
   * @param inner it without its parentheses
   * @param values returns a text with the values of the substitutions in it
   */
  static Optional<String> value(String inner, Function<String, Optional<String>> values) {
    List<String> written = words(inner);
    String name = written.get(0);
    List<String> given = new ArrayList<>();
    for (String word : written.subList(1, written.size())) {
      Optional<String> value = values.apply(word).filter(LaunchScope::isComplete);
      if (value.isEmpty()) {
        return value;
      }
      given.add(value.get());
    }
    return switch (name) {
      case "eval" -> given.size() == 1 ? LaunchExpression.value(given.get(0)) : Optional.empty();
      case "equals", "not-equals" ->
          given.size() == 2
              ? LaunchCondition.equal(given.get(0), given.get(1))
                  .map(it -> String.valueOf(it == name.equals("equals")))
              : Optional.empty();
      case "if" -> chosen(given);
      default -> decided(name, given);
    };
  }

  private static Optional<String> chosen(List<String> given) {
    if (given.isEmpty() || given.size() > 3) {
      return Optional.empty();
    }
    return LaunchCondition.truth(given.get(0))
        .map(it -> it ? 1 : 2)
        .map(place -> place < given.size() ? given.get(place) : "");
  }

  private static Optional<String> decided(String name, List<String> given) {
    List<Boolean> truths = new ArrayList<>();
    for (String each : given) {
      Optional<Boolean> truth = LaunchCondition.truth(each);
      if (truth.isEmpty()) {
        return Optional.empty();
      }
      truths.add(truth.get());
    }
    boolean isOfTwo = name.equals("and") || name.equals("or");
    if (truths.isEmpty()
        || (isOfTwo && truths.size() != 2)
        || (name.equals("not") && truths.size() != 1)) {
      return Optional.empty();
    }
    boolean value =
        switch (name) {
          case "not" -> !truths.get(0);
          case "and", "all" -> truths.stream().allMatch(it -> it);
          default -> truths.stream().anyMatch(it -> it);
        };
    return Optional.of(String.valueOf(value));
  }

  /** Returns the words of a substitution: in quotes, with what a backslash hides, or without. */
  private static List<String> words(String text) {
    List<String> found = new ArrayList<>();
    StringBuilder word = new StringBuilder();
    boolean isIn = false;
    char quote = 0;
    int open = 0;
    for (int i = 0; i < text.length(); i++) {
      char each = text.charAt(i);
      if (each == '\\' && quote != 0 && i + 1 < text.length()) {
        char hidden = text.charAt(++i);
        word.append(hidden == '$' ? "$(unknown)" : String.valueOf(hidden));
      } else if (open == 0 && quote == 0 && !isIn && (each == '\'' || each == '"')) {
        quote = each;
        isIn = true;
      } else if (open == 0 && quote != 0 && each == quote) {
        quote = 0;
      } else if (open == 0 && quote == 0 && Character.isWhitespace(each)) {
        isIn = end(isIn, word, found);
      } else {
        open += each == '(' ? 1 : each == ')' ? -1 : 0;
        isIn = true;
        word.append(each);
      }
    }
    end(isIn, word, found);
    return found;
  }

  private static boolean end(boolean isIn, StringBuilder word, List<String> found) {
    if (isIn) {
      found.add(word.toString());
      word.setLength(0);
    }
    return false;
  }
}
