package dev.eventchain.messages;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Parser for products and quotients of units with integer exponents, from left to right as in UCUM:
 * {@code kg.m2/s3}, {@code m/s/s}, {@code 1/s}, {@code J/(kg.K)}, {@code m·s⁻²}, {@code m/s**2}.
 */
final class UnitParser {

  private static final int LONGEST = 64;
  private static final String SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺";
  private static final String PLAIN = "0123456789-+";

  /** A factor: a number, or a symbol with its exponent of at most two digits. */
  private static final Pattern FACTOR =
      Pattern.compile(
          "(?<number>[0-9]{1,9})|(?<symbol>[^\\s0-9()./*·^+-]+)((\\^|\\*\\*)?(?<power>[-+]?[0-9]{1,2}))?");

  private final String text;
  private int position;

  private UnitParser(String text) {
    this.text = text;
  }

  static Optional<Unit> parse(String written) {
    String text = plain(written.strip());
    if (text.isEmpty() || text.length() > LONGEST) {
      return Optional.empty();
    }
    UnitParser parser = new UnitParser(text);
    Optional<Unit> unit = parser.product();
    return parser.position == text.length() ? unit.filter(Unit::isFinite) : Optional.empty();
  }

  private static String plain(String written) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < written.length(); i++) {
      int superscript = SUPERSCRIPTS.indexOf(written.charAt(i));
      text.append(superscript < 0 ? written.charAt(i) : PLAIN.charAt(superscript));
    }
    // A blank is a product, but not next to another operator.
    return text.toString().replaceAll("\\s*([*/.\u00B7])\\s*", "$1");
  }

  private Optional<Unit> product() {
    Optional<Unit> product = at('/') ? Optional.of(UnitTable.ONE) : factor();
    while (product.isPresent() && position < text.length() && !at(')')) {
      int power = at('/') ? -1 : 1;
      if (!at('/') && !at('.') && !at('*') && !at('·') && !at(' ')) {
        return Optional.empty();
      }
      position++;
      Unit left = product.get();
      product = factor().map(right -> left.times(right, power));
    }
    return product;
  }

  private boolean at(char character) {
    return position < text.length() && text.charAt(position) == character;
  }

  private Optional<Unit> factor() {
    if (at('(')) {
      position++;
      Optional<Unit> inner = product();
      if (!at(')')) {
        return Optional.empty();
      }
      position++;
      return inner;
    }
    Matcher factor = FACTOR.matcher(text).region(position, text.length());
    if (!factor.lookingAt()) {
      return Optional.empty();
    }
    position = factor.end();
    if (factor.group("number") != null) {
      double number = Double.parseDouble(factor.group("number"));
      return number > 0.0 ? Optional.of(UnitTable.number(number)) : Optional.empty();
    }
    Optional<Unit> unit = UnitTable.find(factor.group("symbol"));
    String power = factor.group("power");
    return power == null
        ? unit
        : unit.map(symbol -> UnitTable.ONE.times(symbol, Integer.parseInt(power)));
  }
}
