package dev.eventchain.agents.component;

import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.WrittenRequirement;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Parser for thresholds that a requirement states for an input of a component, such as "full brake
 * if TTC < 1.0 s, no brake if TTC ≥ 2.0 s" or "warn while the time to collision is below 2.6 s".
 * Only these forms with one input are recognized.
 */
final class RequirementThresholds {
  private static final String NUMBER = "([-+]?\\d+(?:\\.\\d+)?)\\s*";
  private static final String UNIT = "([a-zA-Z°%µ][a-zA-Z/²³^0-9]*)?";
  private static final String QUANTITY = "([A-Za-z][A-Za-z_ -]*?)\\s*";
  private static final Pattern BETWEEN =
      Pattern.compile(
          NUMBER + UNIT + "\\s*(<=|≤|<)\\s*" + QUANTITY + "(<=|≤|<)\\s*" + NUMBER + UNIT);
  private static final Pattern SYMBOL =
      Pattern.compile(QUANTITY + "(<=|>=|≤|≥|<|>)\\s*" + NUMBER + UNIT);
  private static final Pattern WORDS =
      Pattern.compile(
          QUANTITY
              + "(below|under|less than|lower than|above|over|more than|greater than|at least|at most)\\s+"
              + NUMBER
              + UNIT);
  private static final Pattern OR_MORE =
      Pattern.compile(QUANTITY + "\\bis\\s+" + NUMBER + UNIT + "\\s+or\\s+(more|less)");
  private static final Pattern CLAUSE_END = Pattern.compile("[,;:](?=\\s)|\\.(?=\\s|$)");
  private static final Pattern NEGATED = Pattern.compile("(?i)\\b(not|never|nor)\\s*$");
  private static final Pattern NO_WORD = Pattern.compile("[^a-z0-9]+");
  private static final Pattern UNDERSCORE = Pattern.compile("_");
  private static final int WORDS_BEFORE = 6;

  private RequirementThresholds() {}

  /** Effects of a clause on an output. */
  enum Effect {
    /** Zero, or false. */
    NONE,
    /** More than zero and less than full. */
    PARTIAL,
    /** Full value. */
    FULL,
    /** Anything but zero or false. */
    SOME;

    private static Effect of(String clause) {
      String words = " " + clause.toLowerCase(Locale.ROOT).replaceAll("[^a-z]+", " ") + " ";
      if (words.matches(".* (no|not|never|neither|without) .*")) {
        return NONE;
      }
      if (words.contains(" partial") || words.contains(" half ")) {
        return PARTIAL;
      }
      return words.contains(" full") ? FULL : SOME;
    }
  }

  /**
   * A range of an input in which a requirement demands an effect.
   *
   * @param clause the words of the requirement
   * @param input the input's name
   * @param least the least value, in the unit of the input; -infinity if unbounded
   * @param leastIn true if the range includes that value
   * @param most the greatest value; infinity if unbounded
   * @param outputs the outputs that the clause mentions; empty if unknown
   */
  record Threshold(
      String clause,
      String input,
      double least,
      boolean leastIn,
      double most,
      boolean mostIn,
      Effect effect,
      List<String> outputs) {
    boolean holds(double value) {
      return (leastIn ? value >= least : value > least) && (mostIn ? value <= most : value < most);
    }

    /** Returns the bounds, at which the effect changes. */
    List<Double> bounds() {
      return List.of(least, most).stream().filter(Double::isFinite).toList();
    }
  }

  /** Returns the thresholds of a requirement. */
  static List<Threshold> of(WrittenRequirement requirement, Component component) {
    List<Threshold> found = new ArrayList<>();
    for (String clause : CLAUSE_END.split(requirement.text(), -1)) {
      threshold(clause.strip(), component).ifPresent(found::add);
    }
    return found;
  }

  private static Optional<Threshold> threshold(String clause, Component component) {
    Matcher between = BETWEEN.matcher(clause);
    if (between.find()) {
      Range range =
          new Range(
              number(between.group(1)),
              !between.group(3).equals("<"),
              number(between.group(6)),
              !between.group(5).equals("<"),
              between.group(7) == null ? between.group(2) : between.group(7));
      return of(clause, between.group(4), range, component);
    }
    Matcher symbol = SYMBOL.matcher(clause);
    if (symbol.find()) {
      Range range = Range.of(symbol.group(2), number(symbol.group(3)), symbol.group(4));
      return of(clause, symbol.group(1), range, component);
    }
    Matcher more = OR_MORE.matcher(clause);
    if (more.find()) {
      String sign = more.group(4).equals("more") ? ">=" : "<=";
      Range range = Range.of(sign, number(more.group(2)), more.group(3));
      return of(clause, more.group(1), range, component);
    }
    Matcher words = WORDS.matcher(clause);
    if (words.find() && !NEGATED.matcher(words.group(1)).find()) {
      Range range = Range.of(sign(words.group(2)), number(words.group(3)), words.group(4));
      return of(clause, words.group(1), range, component);
    }
    return Optional.empty();
  }

  /**
   * A range as written in a requirement.
   *
   * @param unit null if none is stated
   */
  private record Range(double least, boolean leastIn, double most, boolean mostIn, String unit) {
    static Range of(String sign, double number, String unit) {
      boolean closed = !sign.equals("<") && !sign.equals(">");
      return sign.startsWith("<") || sign.equals("≤")
          ? new Range(Double.NEGATIVE_INFINITY, true, number, closed, unit)
          : new Range(number, closed, Double.POSITIVE_INFINITY, true, unit);
    }

    /** Converts the range to another unit; empty if the dimension differs. */
    Optional<Range> in(String wanted) {
      if (unit == null || wanted.isEmpty()) {
        return Optional.of(this);
      }
      Optional<Unit> from = Unit.parse(unit.replaceFirst("^sec(ond)?s?$", "s"));
      Optional<Unit> to = Unit.parse(wanted);
      if (from.isEmpty() || to.isEmpty()) {
        return Optional.empty();
      }
      return switch (from.get().relationTo(to.get())) {
        case SAME -> Optional.of(this);
        case CONVERTIBLE ->
            Optional.of(
                new Range(
                    to.get().ofCoherent(from.get().coherent(least)),
                    leastIn,
                    to.get().ofCoherent(from.get().coherent(most)),
                    mostIn,
                    wanted));
        default -> Optional.empty();
      };
    }
  }

  private static Optional<Threshold> of(
      String clause, String quantity, Range written, Component component) {
    List<Value> inputs =
        component.inputValues().stream()
            .filter(input -> !input.type().contains("[") && isNamed(input.name(), quantity))
            .toList();
    if (inputs.size() != 1) {
      return Optional.empty();
    }
    Value input = inputs.get(0);
    List<String> outputs =
        component.outputValues().stream()
            .map(Value::name)
            .filter(output -> isSpokenOf(output, clause))
            .toList();
    return written
        .in(input.unit())
        .map(
            range ->
                new Threshold(
                    clause,
                    input.name(),
                    range.least(),
                    range.leastIn(),
                    range.most(),
                    range.mostIn(),
                    Effect.of(clause),
                    outputs));
  }

  /** Returns whether the words before a comparison name a value: TTC, or the time to collision. */
  private static boolean isNamed(String name, String quantity) {
    List<String> words = lastWords(quantity);
    String plain = String.join("", tokens(name));
    if (words.contains(plain)) {
      return true;
    }
    StringBuilder initials = new StringBuilder();
    words.forEach(word -> initials.append(word.charAt(0)));
    boolean abbreviated =
        (plain.length() > 2 && initials.indexOf(plain) >= 0) || words.contains(initials(name));
    return abbreviated || words.containsAll(tokens(name));
  }

  private static List<String> lastWords(String text) {
    List<String> words =
        NO_WORD
            .splitAsStream(text.toLowerCase(Locale.ROOT))
            .filter(word -> !word.isEmpty())
            .toList();
    return words.subList(Math.max(0, words.size() - WORDS_BEFORE), words.size());
  }

  private static List<String> tokens(String name) {
    String apart = name.replaceAll("(?<=[a-z])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
    return UNDERSCORE.splitAsStream(apart).filter(token -> !token.isEmpty()).toList();
  }

  private static String initials(String name) {
    List<String> tokens = tokens(name);
    StringBuilder initials = new StringBuilder();
    tokens.forEach(token -> initials.append(token.charAt(0)));
    return tokens.size() > 2 ? initials.toString() : "\0";
  }

  /** Returns whether a clause has a word of the same stem: brake and braking_force. */
  private static boolean isSpokenOf(String output, String clause) {
    List<String> words = NO_WORD.splitAsStream(clause.toLowerCase(Locale.ROOT)).toList();
    return tokens(output).stream()
        .filter(token -> token.length() >= 4)
        .anyMatch(token -> words.stream().anyMatch(word -> word.startsWith(token.substring(0, 4))));
  }

  private static String sign(String words) {
    return switch (words) {
      case "below", "under", "less than", "lower than" -> "<";
      case "at most" -> "<=";
      case "at least" -> ">=";
      default -> ">";
    };
  }

  private static double number(String text) {
    return Double.parseDouble(text);
  }
}
