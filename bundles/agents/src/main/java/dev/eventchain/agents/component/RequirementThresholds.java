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
  private static final Pattern RELATIVE =
      Pattern.compile(
          "\\s*(?:above|below|over|under|beyond|from|away|ahead|behind|of|off|than"
              + "|more|less|higher|lower|faster|slower|longer|shorter|later|earlier)\\b.*");
  private static final Pattern CLAUSE_END = Pattern.compile("[,;:](?=\\s)|\\.(?=\\s|$)");
  private static final Pattern NEGATED = Pattern.compile("(?i)\\b(not|never|nor)\\s*$");
  private static final Pattern NO_WORD = Pattern.compile("[^a-z0-9]+");
  private static final Pattern UNDERSCORE = Pattern.compile("_");
  private static final int WORDS_BEFORE = 6;

  private RequirementThresholds() {}

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
      ThresholdEffect effect,
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
    List<String> clauses = CLAUSE_END.splitAsStream(requirement.text()).map(String::strip).toList();
    for (int i = 0; i < clauses.size(); i++) {
      List<String> others = new ArrayList<>(clauses);
      String clause = others.remove(i);
      Optional<Comparison> comparison = comparison(clause);
      if (comparison.isPresent() && !comparison.get().isRelative()) {
        threshold(clause, comparison.get(), others, component).ifPresent(found::add);
      }
    }
    return found;
  }

  /**
   * A comparison in a clause.
   *
   * @param quantity the words before it, which name what is compared
   * @param before the clause up to the operator
   * @param after the clause behind the number and its unit
   */
  private record Comparison(String quantity, Range range, String before, String after) {

    /** Returns whether a difference is compared: 5 km/h above the limit. */
    boolean isRelative() {
      return RELATIVE.matcher(after).matches();
    }
  }

  private static Comparison comparison(String clause, Matcher match, int quantity, Range range) {
    int end = quantity == 1 ? match.end(1) : match.start();
    String before = clause.substring(0, end);
    return new Comparison(match.group(quantity), range, before, clause.substring(match.end()));
  }

  private static Optional<Comparison> comparison(String clause) {
    Matcher between = BETWEEN.matcher(clause);
    if (between.find()) {
      Range range =
          new Range(
              number(between.group(1)),
              !between.group(3).equals("<"),
              number(between.group(6)),
              !between.group(5).equals("<"),
              between.group(7) == null ? between.group(2) : between.group(7));
      return Optional.of(comparison(clause, between, 4, range));
    }
    Matcher symbol = SYMBOL.matcher(clause);
    if (symbol.find()) {
      Range range = Range.of(symbol.group(2), number(symbol.group(3)), symbol.group(4));
      return Optional.of(comparison(clause, symbol, 1, range));
    }
    Matcher more = OR_MORE.matcher(clause);
    if (more.find()) {
      String sign = more.group(4).equals("more") ? ">=" : "<=";
      Range range = Range.of(sign, number(more.group(2)), more.group(3));
      return Optional.of(comparison(clause, more, 1, range));
    }
    Matcher words = WORDS.matcher(clause);
    if (words.find() && !NEGATED.matcher(words.group(1)).find()) {
      Range range = Range.of(sign(words.group(2)), number(words.group(3)), words.group(4));
      return Optional.of(comparison(clause, words, 1, range));
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

  private static Optional<Threshold> threshold(
      String clause, Comparison comparison, List<String> others, Component component) {
    List<String> outputs =
        component.outputValues().stream()
            .map(Value::name)
            .filter(output -> isSpokenOf(output, clause))
            .toList();
    ThresholdEffect effect = ThresholdEffect.of(comparison.before() + comparison.after(), others);
    Optional<Value> input = input(comparison.quantity(), component);
    return input
        .flatMap(value -> comparison.range().in(value.unit()))
        .map(
            range ->
                new Threshold(
                    clause,
                    input.get().name(),
                    range.least(),
                    range.leastIn(),
                    range.most(),
                    range.mostIn(),
                    effect,
                    outputs));
  }

  /** Returns the only input that the words before a comparison name. */
  private static Optional<Value> input(String quantity, Component component) {
    List<Value> inputs =
        component.inputValues().stream()
            .filter(input -> !input.type().contains("["))
            .filter(input -> isNamed(input.name(), quantity))
            .toList();
    return inputs.size() == 1 ? Optional.of(inputs.get(0)) : Optional.empty();
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

  /**
   * Returns whether a clause has a word of the same stem: brake and braking_force. One whose name
   * may mean the opposite, such as braking_inactive, is left to people.
   */
  private static boolean isSpokenOf(String output, String clause) {
    if (ThresholdEffect.mayBeOpposite(String.join(" ", tokens(output)))) {
      return false;
    }
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
