package dev.eventchain.agents.component;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * Effects of a clause on an output while an input is beyond a threshold. An effect is known only
 * where the threshold alone decides: a further condition, a time, a second number or a word such as
 * "off" leave it to people.
 */
enum ThresholdEffect {
  /** Zero, or false. */
  NONE,
  /** More than zero and less than full. */
  PARTIAL,
  /** Full value. */
  FULL,
  /** Anything but zero or false. */
  SOME,
  UNKNOWN;

  private static final String CONDITION =
      "if|when|while|whenever|where|during|once|after|before|since|until|unless|except|provided"
          + "|given|as long as";

  private static final Pattern CONDITIONS = Pattern.compile("\\b(?:" + CONDITION + ")\\b");

  /** A clause that restricts others: "When the ignition is on, ...". */
  private static final Pattern RESTRICTS =
      Pattern.compile("(?:and |or |but |only )*(?:" + CONDITION + ")\\b.*");

  /** Words that add a condition, a time or a comparison, or demand that something ends. */
  private static final Pattern DOUBTFUL =
      Pattern.compile(
          "\\b(?:and|or|but|other|only|again|first|within|for|without|later|earlier|sooner|more"
              + "|less|fewer|most|least|off|zero|false|inactive\\w*|passive|idle|neutral|low"
              + "|minim\\w*|mut(?:e[ds]?|ing)|hid\\w*|block\\w*|interrupt\\w*|abort\\w*"
              + "|terminat\\w*|disengag\\w*|clear\\w*|open\\w*|clos\\w*|unlock\\w*|releas\\w*"
              + "|disabl\\w*|deactivat\\w*|stop\\w*|suppress\\w*|inhibit\\w*|end\\w*|reset\\w*"
              + "|remov\\w*|cancel\\w*|silen\\w*|prevent\\w*|limit\\w*|reduc\\w*)\\b");

  private static final Pattern NEGATED = Pattern.compile("\\b(?:no|not|never|neither)\\b");

  /**
   * Returns the effect that a clause demands.
   *
   * @param rest the clause without its threshold
   * @param others the other clauses of its requirement
   */
  static ThresholdEffect of(String rest, List<String> others) {
    String words = plain(rest);
    boolean decided =
        rest.chars().noneMatch(Character::isDigit)
            && !DOUBTFUL.matcher(words).find()
            && CONDITIONS.matcher(words).results().count() <= 1
            && others.stream().noneMatch(other -> RESTRICTS.matcher(plain(other)).matches());
    if (!decided) {
      return UNKNOWN;
    }
    if (NEGATED.matcher(words).find()) {
      return NONE;
    }
    if (words.matches(".*\\b(?:partial\\w*|half)\\b.*")) {
      return PARTIAL;
    }
    return words.matches(".*\\bfull.*") ? FULL : SOME;
  }

  /** Returns whether something that is called so may be true, or large, where nothing happens. */
  static boolean mayBeOpposite(String words) {
    return DOUBTFUL.matcher(words).find() || NEGATED.matcher(words).find();
  }

  private static String plain(String clause) {
    return clause.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", " ").strip();
  }
}
