package dev.eventchain.agents.prompt;

import dev.eventchain.model.WrittenRequirement;
import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/** Text of written rules and numbers in prompts. */
public final class RuleText {
  private RuleText() {}

  /** Returns one line per item, with its id. */
  public static String items(List<WrittenRequirement> items) {
    return items.stream()
        .map(item -> "- " + item.id() + ": " + item.text())
        .collect(Collectors.joining("\n"));
  }

  /** Returns a number without trailing zeros: 20, 12.5. */
  public static String number(double value) {
    return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
  }
}
