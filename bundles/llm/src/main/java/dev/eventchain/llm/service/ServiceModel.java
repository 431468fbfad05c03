package dev.eventchain.llm.service;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ModelName;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/**
 * A model of a service. Temporary failures are retried as long as no part of an answer has arrived:
 * at most three attempts, after the delay that the service requests or an increasing one, within
 * the deadline of the whole call.
 */
public final class ServiceModel implements ChatModel {
  private static final int TRIES = 3;
  private static final Duration FIRST_WAIT = Duration.ofSeconds(1);
  private static final int GROWTH = 4;

  private final ModelService service;
  private final ModelName name;
  private final UnaryOperator<String> environment;
  private final Consumer<String> progress;
  private final Duration firstWait;

  /**
   * Creates a model of a service.
   *
   * @param environment the value of a variable, null if there is none
   * @param progress receives progress messages for the user
   */
  public ServiceModel(
      ModelService service,
      ModelName name,
      UnaryOperator<String> environment,
      Consumer<String> progress) {
    this(service, name, environment, progress, FIRST_WAIT);
  }

  ServiceModel(
      ModelService service,
      ModelName name,
      UnaryOperator<String> environment,
      Consumer<String> progress,
      Duration firstWait) {
    this.service = service;
    this.name = name;
    this.environment = environment;
    this.progress = progress;
    this.firstWait = firstWait;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    Optional<String> key = service.key().map(this::key);
    Deadline deadline = Deadline.in(service.deadline());
    for (int attempt = 1; ; attempt++) {
      ServiceCall call = new ServiceCall(service, name, key.orElse(""), deadline, progress);
      try {
        return call.ask(request);
      } catch (CallFailure failure) {
        Optional<Duration> wait = wait(failure, call, attempt, deadline);
        if (wait.isEmpty()) {
          throw failure.finding(name.toString(), key);
        }
        sleep(wait.get(), deadline);
      }
    }
  }

  private String key(String variable) {
    String key = environment.apply(variable);
    if (key == null || key.isBlank()) {
      throw new DiagnosticException(
          Reason.UNAVAILABLE,
          Diagnostic.of(
                  ServiceRules.KEY_MISSING,
                  "The environment variable "
                      + variable
                      + " with the key of '%s' is not set.".formatted(service.name()),
                  SourceLocation.NONE)
              .withHint("Set it; keys are read from the environment only."));
    }
    return key.strip();
  }

  private Optional<Duration> wait(
      CallFailure failure, ServiceCall call, int attempt, Deadline deadline) {
    if (!failure.isPassing() || call.hasBegun() || attempt == TRIES) {
      return Optional.empty();
    }
    Duration usual = attempt == 1 ? firstWait : firstWait.multipliedBy(GROWTH);
    Duration wait = failure.retryAfter().orElse(usual);
    if (wait.compareTo(deadline.left()) >= 0) {
      return Optional.empty();
    }
    progress.accept(
        "%s: %s; again in %s".formatted(name, failure.getMessage(), Deadline.text(wait)));
    return Optional.of(wait);
  }

  private static void sleep(Duration wait, Deadline deadline) {
    try {
      Thread.sleep(wait.toMillis());
    } catch (InterruptedException e) {
      throw deadline.interrupted();
    }
  }
}
