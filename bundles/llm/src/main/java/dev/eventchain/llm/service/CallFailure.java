package dev.eventchain.llm.service;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import java.time.Duration;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Why a call of a service gave no answer. Thrown through the client library, which knows nothing of
 * it, and turned into a finding when the call is abandoned.
 */
final class CallFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** What went wrong, by what the user can do about it. */
  enum Kind {
    /** Nothing answers, or the connection broke before an answer began. */
    UNREACHABLE("llm.service.unreachable", true),
    /** The service is overloaded or broken at the moment. */
    FAILED("llm.service.failed", true),
    /** Too many requests. */
    LIMITED("llm.service.limited", true),
    /** The key is missing at the service, wrong, or has no right to the model. */
    KEY("llm.key.refused", false),
    /** The account has no credit left. */
    QUOTA("llm.quota.spent", false),
    /** The service understood the request and does not take it. */
    REJECTED("llm.request.rejected", false),
    /** The deadline of the whole call passed, or the service fell silent. */
    LATE("llm.answer.late", false),
    /** The answer ended before its end. */
    CUT("llm.answer.cut", true),
    /** What came is not an answer of such a service. */
    UNREADABLE("llm.answer.unreadable", false);

    private final String id;
    private final boolean passing;

    Kind(String id, boolean passing) {
      this.id = id;
      this.passing = passing;
    }
  }

  /** What services call the schema, or what they make of it. */
  private static final Pattern SCHEMA =
      Pattern.compile(
          "schema|response[_ ]?format|output_(format|config)|\\bgrammar", Pattern.CASE_INSENSITIVE);

  private final Kind kind;
  private final String hint;
  private final transient Optional<Duration> retryAfter;

  CallFailure(Kind kind, String message, String hint, Optional<Duration> retryAfter) {
    super(message, null, false, false);
    this.kind = kind;
    this.hint = hint;
    this.retryAfter = retryAfter;
  }

  CallFailure(Kind kind, String message, String hint) {
    this(kind, message, hint, Optional.empty());
  }

  /**
   * The same failure of a request with a JSON Schema: if the service names that, its own words say
   * little to whoever never saw it.
   */
  CallFailure ofSchema() {
    if (kind != Kind.REJECTED || !SCHEMA.matcher(getMessage()).find()) {
      return this;
    }
    return new CallFailure(
        kind,
        "the service rejects the JSON Schema that is sent along with this task: " + getMessage(),
        "Ask another model or service for this task, or see whether the service's 'wire' in"
            + " eventchain.yaml is right.");
  }

  Kind kind() {
    return kind;
  }

  /** Whether the same request may well succeed a little later. */
  boolean isPassing() {
    return kind.passing;
  }

  /** How long the service asked to be left alone. */
  Optional<Duration> retryAfter() {
    return retryAfter;
  }

  /**
   * What the user is told.
   *
   * @param asked the model that was asked
   * @param key what never appears in a message
   */
  DiagnosticException finding(String asked, Optional<String> key) {
    String message = asked + ": " + getMessage();
    String shown = key.map(secret -> message.replace(secret, "***")).orElse(message);
    Diagnostic finding =
        Diagnostic.error(kind.id, shown, SourceLocation.NONE)
            .withHint(key.map(secret -> hint.replace(secret, "***")).orElse(hint));
    return new DiagnosticException(Reason.UNAVAILABLE, finding);
  }
}
