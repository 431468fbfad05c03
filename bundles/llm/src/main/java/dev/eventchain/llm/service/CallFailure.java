package dev.eventchain.llm.service;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.time.Duration;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Failure of a call of a service. It is thrown through the client library, which does not know it,
 * and turned into a finding when the call is abandoned.
 */
final class CallFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Kinds of failures, by possible actions of the user. */
  @SuppressWarnings("ImmutableEnumChecker") // rules are immutable
  enum Kind {
    /** No service answers, or the connection broke before an answer began. */
    UNREACHABLE(ServiceRules.SERVICE_UNREACHABLE, true),
    /** The service is currently overloaded or broken. */
    FAILED(ServiceRules.SERVICE_FAILED, true),
    /** Too many requests. */
    LIMITED(ServiceRules.SERVICE_LIMITED, true),
    /** The key is missing, wrong, or not authorized for the model. */
    KEY(ServiceRules.KEY_REFUSED, false),
    /** The account has no credit left. */
    QUOTA(ServiceRules.QUOTA_SPENT, false),
    /** The service rejected the request. */
    REJECTED(ServiceRules.REQUEST_REJECTED, false),
    /** The deadline of the whole call passed, or the service was silent for too long. */
    LATE(ServiceRules.ANSWER_LATE, false),
    /** The answer ended early. */
    CUT(ServiceRules.ANSWER_CUT, true),
    /** The response does not follow the service's protocol. */
    UNREADABLE(ServiceRules.ANSWER_UNREADABLE, false);

    private final Rule rule;
    private final boolean passing;

    Kind(Rule rule, boolean passing) {
      this.rule = rule;
      this.passing = passing;
    }
  }

  /** Terms of services for the schema and for its translations. */
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
   * Returns the same failure for a request with a JSON Schema. If the service mentions the schema,
   * its message alone would not help the user, who has not seen it.
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

  /** Returns whether the same request may succeed a little later. */
  boolean isPassing() {
    return kind.passing;
  }

  /** Returns the delay that the service requested. */
  Optional<Duration> retryAfter() {
    return retryAfter;
  }

  /**
   * Returns the finding for the user.
   *
   * @param asked the requested model
   * @param key the key, which is removed from messages
   */
  DiagnosticException finding(String asked, Optional<String> key) {
    String message = asked + ": " + getMessage();
    String shown = key.map(secret -> message.replace(secret, "***")).orElse(message);
    Diagnostic finding =
        Diagnostic.of(kind.rule, shown, SourceLocation.NONE)
            .withHint(key.map(secret -> hint.replace(secret, "***")).orElse(hint));
    return new DiagnosticException(Reason.UNAVAILABLE, finding);
  }
}
