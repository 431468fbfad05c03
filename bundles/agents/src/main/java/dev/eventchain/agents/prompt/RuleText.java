package dev.eventchain.agents.prompt;

import dev.eventchain.model.WrittenRequirement;
import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/** Written rules and numbers as prompts show them. */
public final class RuleText {
  private RuleText() {}

  /** An item a line, with its id. */
  public static String items(List<WrittenRequirement> items) {
    return items.stream()
        .map(item -> "- " + item.id() + ": " + item.text())
        .collect(Collectors.joining("\n"));
  }

  /** A number without needless zeros: 20, 12.5. */
  public static String number(double value) {
    return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
  }
}
