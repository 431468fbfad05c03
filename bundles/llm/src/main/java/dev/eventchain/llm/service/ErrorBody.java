package dev.eventchain.llm.service;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.io.IOException;
import java.io.InputStream;
import java.net.http.HttpHeaders;
import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Error responses of services. Their text is untrusted: it is shortened and put on one line. */
public final class ErrorBody {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final int READ = 64 << 10;
  private static final int SHOWN = 300;
  private static final List<String> QUOTA =
      List.of("insufficient_quota", "billing", "credit balance", "exceeded your current quota");

  private ErrorBody() {}

  /** Returns the failure for a response with an error status. */
  static CallFailure failure(int status, HttpHeaders headers, InputStream body) throws IOException {
    String text = new String(body.readNBytes(READ), StandardCharsets.UTF_8);
    body.close();
    return failure(status, message(parse(text)).orElse(text), retryAfter(headers));
  }

  /** Returns the failure for an error event within an answer. */
  static CallFailure ofEvent(JsonNode data) {
    JsonNode error = data.path("error");
    int status = error.path("code").asInt(0);
    String type = error.path("type").asText("");
    String message = message(data).orElse(data.toString());
    if (type.contains("overloaded") || type.contains("rate_limit") || status == 0) {
      return failure(503, message, Optional.empty());
    }
    return failure(status, message, Optional.empty());
  }

  private static CallFailure failure(int status, String said, Optional<Duration> retryAfter) {
    String message = "HTTP status " + status + (said.isBlank() ? "" : ": " + shown(said));
    if (QUOTA.stream().anyMatch(said.toLowerCase(Locale.ROOT)::contains)) {
      return new CallFailure(
          CallFailure.Kind.QUOTA, message, "Check the account's limits and payments.");
    }
    return switch (status) {
      case 401, 403 ->
          new CallFailure(
              CallFailure.Kind.KEY,
              message,
              "Check the key in the environment variable that 'eventchain doctor' names.");
      case 429 ->
          new CallFailure(
              CallFailure.Kind.LIMITED, message, "Wait, or ask another model.", retryAfter);
      case 408, 500, 502, 503, 504, 529 ->
          new CallFailure(
              CallFailure.Kind.FAILED,
              message,
              "Try again later, or ask another model.",
              retryAfter);
      default ->
          new CallFailure(
              CallFailure.Kind.REJECTED,
              message,
              "Check the model's name and the service's 'url' and 'wire' in eventchain.yaml.");
    };
  }

  private static JsonNode parse(String text) {
    try {
      return MAPPER.readTree(text);
    } catch (JsonProcessingException e) {
      return MissingNode.getInstance();
    }
  }

  /**
   * Returns the error text. OpenAI, Anthropic and Gemini: error.message; Ollama: error; some wrap
   * it in an array.
   */
  private static Optional<String> message(JsonNode body) {
    JsonNode object = body.isArray() ? body.path(0) : body;
    JsonNode error = object.path("error");
    String text = error.isTextual() ? error.asText() : error.path("message").asText("");
    String type = error.path("type").asText(error.path("code").asText(""));
    if (text.isBlank()) {
      text = object.path("message").asText("");
    }
    String whole = type.isBlank() || text.contains(type) ? text : text + " (" + type + ")";
    return Optional.of(whole).filter(known -> !known.isBlank());
  }

  /** Returns the delay, given in seconds or as a date (RFC 9110, section 10.2.3). */
  private static Optional<Duration> retryAfter(HttpHeaders headers) {
    return headers
        .firstValue("Retry-After")
        .flatMap(
            value -> {
              try {
                return Optional.of(
                    value.matches("\\d{1,9}(\\.\\d+)?")
                        ? Duration.ofMillis(Math.round(Double.parseDouble(value) * 1000))
                        : until(value));
              } catch (DateTimeException e) {
                return Optional.empty();
              }
            })
        .filter(time -> !time.isNegative());
  }

  private static Duration until(String date) {
    ZonedDateTime when = ZonedDateTime.parse(date, DateTimeFormatter.RFC_1123_DATE_TIME);
    return Duration.between(ZonedDateTime.now(when.getZone()), when);
  }

  /** Returns the beginning of a body, for messages. */
  static String start(InputStream body) throws IOException {
    String text = new String(body.readNBytes(READ), StandardCharsets.UTF_8);
    body.close();
    return shown(text.replaceAll("<[^>]*>", " "));
  }

  /** Returns untrusted text on one line, without terminal control characters. */
  public static String shown(String text) {
    String line = text.strip().replaceAll("[\\s\\p{Cntrl}\\p{Cf}]+", " ");
    return line.length() <= SHOWN ? line : line.substring(0, SHOWN - 3) + "...";
  }
}
