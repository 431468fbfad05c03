package dev.eventchain.llm.service;

import dev.eventchain.llm.chat.Sampling;
import java.net.URI;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;

/**
 * A service for language models.
 *
 * @param name the prefix of its models, as in {@code NAME/MODEL}
 * @param url the URL without the path that the protocol adds, such as {@code /chat/completions}
 * @param key the environment variable with the key; empty if the service needs none
 * @param deadline the time for a whole call, with its repetitions
 * @param silence the longest pause within an answer
 * @param maximumTokens default length at which an answer is truncated
 * @param sampling the temperature and the seed of its models, as far as they are given
 */
public record ModelService(
    String name,
    Wire wire,
    URI url,
    Optional<String> key,
    Duration deadline,
    Duration silence,
    int maximumTokens,
    Sampling sampling) {

  /** Creates a service that leaves the sampling to the provider. */
  ModelService(
      String name,
      Wire wire,
      URI url,
      Optional<String> key,
      Duration deadline,
      Duration silence,
      int maximumTokens) {
    this(name, wire, url, key, deadline, silence, maximumTokens, Sampling.DEFAULT);
  }

  public static final Duration DEADLINE = Duration.ofMinutes(5);
  static final Duration SILENCE = Duration.ofMinutes(1);
  static final int MAXIMUM_TOKENS = 16_384;

  private static final Map<String, ModelService> KNOWN =
      Map.of(
          "openai", known("openai", Wire.OPENAI, "https://api.openai.com/v1"),
          "groq", known("groq", Wire.OPENAI_COMPATIBLE, "https://api.groq.com/openai/v1"),
          "gemini",
              known("gemini", Wire.GEMINI, "https://generativelanguage.googleapis.com/v1beta"),
          "anthropic", known("anthropic", Wire.ANTHROPIC, "https://api.anthropic.com/v1"),
          "ollama", own("ollama", Wire.OLLAMA, "http://localhost:11434"),
          "vllm", own("vllm", Wire.OPENAI_COMPATIBLE, "http://localhost:8000/v1"),
          "llamacpp", own("llamacpp", Wire.OPENAI_COMPATIBLE, "http://localhost:8080/v1"));

  /** Returns the services that need no configuration, by name. */
  static Map<String, ModelService> known() {
    return KNOWN;
  }

  private static ModelService known(String name, Wire wire, String url) {
    return of(name, wire, URI.create(url), Optional.of(variable(name)));
  }

  private static ModelService own(String name, Wire wire, String url) {
    return of(name, wire, URI.create(url), Optional.empty());
  }

  /** Returns a service with the usual limits. */
  static ModelService of(String name, Wire wire, URI url, Optional<String> key) {
    return new ModelService(name, wire, url, key, DEADLINE, SILENCE, MAXIMUM_TOKENS);
  }

  /** Returns the default environment variable for the key of a service. */
  static String variable(String name) {
    return name.toUpperCase(java.util.Locale.ROOT).replaceAll("[^A-Z0-9]", "_") + "_API_KEY";
  }
}
