package dev.eventchain.llm;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.ChatResponse.Usage;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.service.ModelServices;
import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/** Cost of the calls of a run, and its budget. Thread-safe. */
public final class Spending {
  private final ModelServices services;
  private final SortedMap<String, Line> lines = new TreeMap<>();

  /**
   * The calls of one model.
   *
   * @param unknown the number of calls without token counts
   * @param cost in the currency of the prices; empty if the project has no price for the model
   */
  public record Line(
      String model,
      int calls,
      int unknown,
      long inputTokens,
      long outputTokens,
      Optional<BigDecimal> cost) {

    private Line with(Optional<Usage> usage, Optional<BigDecimal> price) {
      Usage used = usage.orElse(new Usage(0, 0));
      return new Line(
          model,
          calls + 1,
          unknown + (usage.isPresent() ? 0 : 1),
          inputTokens + used.inputTokens(),
          outputTokens + used.outputTokens(),
          price.map(each -> cost.orElse(BigDecimal.ZERO).add(each)));
    }
  }

  /** Creates the spending of a new run. */
  public Spending(ModelServices services) {
    this.services = services;
  }

  /** Returns the spending by model. */
  public synchronized List<Line> lines() {
    return List.copyOf(lines.values());
  }

  synchronized void add(ModelName model, Optional<Usage> usage) {
    Optional<BigDecimal> price =
        services.price(model).map(each -> each.of(usage.orElse(new Usage(0, 0))));
    Line line = new Line(model.toString(), 0, 0, 0, 0, Optional.empty());
    lines.put(model.toString(), lines.getOrDefault(model.toString(), line).with(usage, price));
  }

  /**
   * Refuses a call once the budget is spent. The call that exceeds the budget is the last one,
   * since the cost is known only afterwards.
   */
  synchronized void requireBudget(ModelName model) {
    ModelServices.Budget budget = services.budget();
    if (budget.cost().isPresent() && services.price(model).isEmpty()) {
      throw stop(
          LlmRules.PRICE_MISSING,
          "A run may cost " + budget.cost().get() + ", and the price of " + model + " is unknown.",
          "Add it to 'prices' of eventchain.yaml, or limit 'tokens' instead of 'cost'.");
    }
    BigDecimal cost =
        lines.values().stream()
            .flatMap(line -> line.cost().stream())
            .reduce(BigDecimal.ZERO, BigDecimal::add);
    long tokens =
        lines.values().stream().mapToLong(line -> line.inputTokens() + line.outputTokens()).sum();
    if (budget.cost().filter(most -> cost.compareTo(most) >= 0).isPresent()) {
      throw spent("The calls of this run have cost %s of %s.", cost, budget.cost().get());
    }
    if (budget.tokens().isPresent() && tokens >= budget.tokens().getAsLong()) {
      throw spent(
          "The calls of this run have used %s of %s tokens.", tokens, budget.tokens().getAsLong());
    }
  }

  private static DiagnosticException spent(String message, Object spent, Object allowed) {
    return stop(
        LlmRules.BUDGET_SPENT,
        message.formatted(spent, allowed),
        "With --record, the answers so far are kept. Allow more with 'budget' in eventchain.yaml.");
  }

  private static DiagnosticException stop(Rule rule, String message, String hint) {
    return new DiagnosticException(
        Reason.UNAVAILABLE, Diagnostic.of(rule, message, SourceLocation.NONE).withHint(hint));
  }
}
