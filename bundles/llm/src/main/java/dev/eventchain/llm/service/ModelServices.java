package dev.eventchain.llm.service;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.chat.Sampling;
import java.math.BigDecimal;
import java.net.URI;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Configuration of a project's services for language models, their prices, and the budget of a run.
 * Keys are taken from the environment only.
 */
public final class ModelServices {
  private static final NumberRange SECONDS = NumberRange.above(0).upTo(86_400);
  private static final NumberRange TOKENS = NumberRange.of(1, 1e9);
  private static final NumberRange TEMPERATURE = NumberRange.of(0, 2);
  private static final NumberRange SEED = NumberRange.of(0, Integer.MAX_VALUE);
  private static final NumberRange MONEY = NumberRange.of(0, 1e6);
  private static final BigDecimal MILLION = BigDecimal.valueOf(1_000_000);

  /**
   * Prices of a model per token.
   *
   * @param input price of a request token
   * @param output price of an answer token, including hidden reasoning
   */
  public record Price(BigDecimal input, BigDecimal output) {
    public BigDecimal of(ChatResponse.Usage usage) {
      return input
          .multiply(BigDecimal.valueOf(usage.inputTokens()))
          .add(output.multiply(BigDecimal.valueOf(usage.outputTokens())));
    }
  }

  /**
   * The budget of a run.
   *
   * @param cost in the currency of the prices
   */
  public record Budget(Optional<BigDecimal> cost, OptionalLong tokens) {}

  private final SortedMap<String, ModelService> services;
  private final Map<String, Price> prices;
  private final Budget budget;
  private final Duration commandDeadline;

  private ModelServices(
      SortedMap<String, ModelService> services,
      Map<String, Price> prices,
      Budget budget,
      Duration commandDeadline) {
    this.services = services;
    this.prices = prices;
    this.budget = budget;
    this.commandDeadline = commandDeadline;
  }

  /** Returns the services that need no configuration, without prices and without a budget. */
  public static ModelServices usual() {
    return new ModelServices(
        new TreeMap<>(ModelService.known()),
        Map.of(),
        new Budget(Optional.empty(), OptionalLong.empty()),
        ModelService.DEADLINE);
  }

  /**
   * Reads the keys {@code services}, {@code prices}, {@code budget} and {@code command}.
   *
   * @param settings the configuration, which receives the errors
   */
  public static ModelServices read(ObjectReader settings) {
    SortedMap<String, ModelService> services = new TreeMap<>(ModelService.known());
    settings
        .object("services")
        .ifPresent(
            all ->
                all.names()
                    .forEach(
                        name ->
                            all.requiredObject(name)
                                .flatMap(each -> service(name, each))
                                .ifPresent(service -> services.put(name, service))));
    Map<String, Price> prices = new TreeMap<>();
    settings
        .object("prices")
        .ifPresent(
            all ->
                all.names()
                    .forEach(
                        model ->
                            all.requiredObject(model)
                                .ifPresent(each -> prices.put(model, price(each)))));
    Optional<ObjectReader> budget = settings.object("budget");
    return new ModelServices(services, prices, budget(budget), commandDeadline(settings));
  }

  private static Duration commandDeadline(ObjectReader settings) {
    Optional<ObjectReader> command = settings.object("command");
    Duration deadline =
        command
            .map(section -> seconds(section, "deadline_s", ModelService.DEADLINE))
            .orElse(ModelService.DEADLINE);
    command.ifPresent(ObjectReader::refuseOthers);
    return deadline;
  }

  private static Budget budget(Optional<ObjectReader> section) {
    if (section.isEmpty()) {
      return new Budget(Optional.empty(), OptionalLong.empty());
    }
    ObjectReader reader = section.get();
    Optional<BigDecimal> cost =
        reader.number("cost", MONEY).stream().mapToObj(BigDecimal::valueOf).findFirst();
    OptionalLong tokens = reader.wholeNumber("tokens", TOKENS);
    reader.refuseOthers();
    return new Budget(cost, tokens);
  }

  private static Price price(ObjectReader section) {
    BigDecimal input = perToken(section, "input_per_million");
    BigDecimal output = perToken(section, "output_per_million");
    section.refuseOthers();
    return new Price(input, output);
  }

  private static BigDecimal perToken(ObjectReader section, String key) {
    return BigDecimal.valueOf(section.requiredNumber(key, MONEY)).divide(MILLION);
  }

  private static Optional<ModelService> service(String name, ObjectReader section) {
    Optional<ModelService> known = Optional.ofNullable(ModelService.known().get(name));
    Optional<Wire> wire =
        section.text("wire").isPresent() || known.isEmpty()
            ? wire(section)
            : known.map(ModelService::wire);
    Optional<URI> url =
        section.text("url").isPresent() || known.isEmpty()
            ? url(section)
            : known.map(ModelService::url);
    Optional<String> key = section.text("key").or(() -> known.flatMap(ModelService::key));
    Duration deadline = seconds(section, "deadline_s", ModelService.DEADLINE);
    Duration silence = seconds(section, "silence_s", ModelService.SILENCE);
    int tokens =
        (int) section.wholeNumber("maximum_tokens", TOKENS).orElse(ModelService.MAXIMUM_TOKENS);
    Sampling sampling =
        new Sampling(
            section.number("temperature", TEMPERATURE),
            OptionalInt.empty(),
            section.wholeNumber("seed", SEED));
    section.refuseOthers();
    return wire.isEmpty() || url.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new ModelService(
                name, wire.get(), url.get(), key, deadline, silence, tokens, sampling));
  }

  private static Duration seconds(ObjectReader section, String key, Duration usual) {
    return section.number(key, SECONDS).stream()
        .mapToObj(seconds -> Duration.ofMillis(Math.round(seconds * 1000)))
        .findFirst()
        .orElse(usual);
  }

  private static Optional<Wire> wire(ObjectReader section) {
    String id = section.requiredText("wire");
    Optional<Wire> wire = Wire.of(id);
    if (wire.isEmpty() && !id.isBlank()) {
      section.find(
          Diagnostic.of(
                  ServiceRules.SERVICE_WIRE,
                  "'" + id + "' is not a wire format of a service.",
                  section.at("wire"))
              .withHint("Use one of " + String.join(", ", Wire.ids()) + "."));
    }
    return wire;
  }

  private static Optional<URI> url(ObjectReader section) {
    String text = section.requiredText("url");
    try {
      URI url = URI.create(text);
      if (("http".equals(url.getScheme()) || "https".equals(url.getScheme()))
          && url.getHost() != null
          && url.getUserInfo() == null) {
        return Optional.of(URI.create(text.replaceAll("/+$", "")));
      }
    } catch (IllegalArgumentException e) {
      // Reported below.
    }
    if (!text.isBlank()) {
      section.find(
          Diagnostic.of(
                  ServiceRules.SERVICE_URL,
                  "'" + text + "' is not the address of a service.",
                  section.at("url"))
              .withHint("Write http:// or https://, a host, and a path; keys do not belong here."));
    }
    return Optional.empty();
  }

  /** Returns the time that a program may take for an answer. */
  public Duration commandDeadline() {
    return commandDeadline;
  }

  /** Returns a service by name. */
  public Optional<ModelService> service(String name) {
    return Optional.ofNullable(services.get(name));
  }

  /** Returns the names of all services, in order. */
  public Set<String> names() {
    return new TreeSet<>(services.keySet());
  }

  /**
   * Returns the cost of answers of a model, in the currency of the prices.
   *
   * @return empty if the project has no price for the model
   */
  public Optional<BigDecimal> cost(String model, long inputTokens, long outputTokens) {
    ChatResponse.Usage usage = new ChatResponse.Usage(inputTokens, outputTokens);
    return price(ModelName.parse(model)).map(price -> price.of(usage).stripTrailingZeros());
  }

  public Optional<Price> price(ModelName model) {
    return Optional.ofNullable(prices.get(model.toString()));
  }

  public Budget budget() {
    return budget;
  }
}
