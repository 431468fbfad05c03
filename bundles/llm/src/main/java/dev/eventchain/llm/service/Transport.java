package dev.eventchain.llm.service;

import dev.eventchain.diagnostics.SourceText;
import dev.langchain4j.http.client.HttpClient;
import dev.langchain4j.http.client.HttpClientBuilder;
import dev.langchain4j.http.client.HttpRequest;
import dev.langchain4j.http.client.SuccessfulHttpResponse;
import dev.langchain4j.http.client.sse.ServerSentEventListener;
import dev.langchain4j.http.client.sse.ServerSentEventParser;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Flow;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * HTTP transport to a service for one attempt. Answers are streamed, within the deadline of the
 * whole call, without following redirects (which would forward the key). Failures are kept, since
 * the client library reports some of them as answers.
 */
final class Transport implements HttpClient {

  private static final Duration CONNECT = Duration.ofSeconds(10);

  /** HTTP connections, created by the first call of a run; most runs make none. */
  private static final class Connections {
    static final java.net.http.HttpClient SHARED =
        java.net.http.HttpClient.newBuilder()
            .version(java.net.http.HttpClient.Version.HTTP_1_1)
            .followRedirects(java.net.http.HttpClient.Redirect.NEVER)
            .connectTimeout(CONNECT)
            .proxy(new EnvironmentProxies(System.getenv()))
            .build();
  }

  private final Deadline deadline;
  private final Duration silence;
  private CallFailure failure;
  private CancellationException cancelled;

  Transport(Deadline deadline, Duration silence) {
    this.deadline = deadline;
    this.silence = silence;
  }

  /**
   * Throws the failure of an attempt that gave no answer.
   *
   * @throws CallFailure if something went wrong
   * @throws CancellationException if the thread was interrupted
   */
  void throwFailure() {
    if (cancelled != null) {
      throw cancelled;
    }
    if (failure != null) {
      throw failure;
    }
  }

  /** Returns a builder that always builds this transport. */
  HttpClientBuilder builder() {
    return new Builder(this);
  }

  @Override
  public SuccessfulHttpResponse execute(HttpRequest request) {
    throw new UnsupportedOperationException("all answers are streamed");
  }

  @Override
  public void execute(
      HttpRequest request, ServerSentEventParser parser, ServerSentEventListener listener) {
    try {
      HttpResponse<Flow.Publisher<List<ByteBuffer>>> response = send(request);
      BodyStream body = new BodyStream(deadline, silence);
      response.body().subscribe(body);
      if (response.statusCode() / 100 != 2) {
        throw ErrorBody.failure(response.statusCode(), response.headers(), body);
      }
      requireEvents(response, body);
      ErrorEvents events = new ErrorEvents(listener);
      parser.parse(body, events);
      events.throwFailure();
      listener.onClose();
    } catch (CallFailure problem) {
      failure = problem;
      listener.onError(problem);
    } catch (IOException problem) {
      failure = cut(problem);
      listener.onError(failure);
    } catch (CancellationException problem) {
      cancelled = problem;
      listener.onError(problem);
    }
  }

  private HttpResponse<Flow.Publisher<List<ByteBuffer>>> send(HttpRequest request) {
    CompletableFuture<HttpResponse<Flow.Publisher<List<ByteBuffer>>>> response =
        Connections.SHARED.sendAsync(toJdk(request), BodyHandlers.ofPublisher());
    try {
      return response.get(deadline.left().toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      response.cancel(true);
      throw deadline.passed();
    } catch (InterruptedException e) {
      response.cancel(true);
      throw deadline.interrupted();
    } catch (ExecutionException e) {
      throw new CallFailure(
          CallFailure.Kind.UNREACHABLE,
          URI.create(request.url()).getAuthority()
              + " cannot be reached: "
              + ConnectionProblem.words(e.getCause()),
          "Check that the service runs and that its 'url' in eventchain.yaml is right;"
              + " 'eventchain doctor' says which services can be reached.");
    }
  }

  private static java.net.http.HttpRequest toJdk(HttpRequest request) {
    java.net.http.HttpRequest.Builder builder =
        java.net.http.HttpRequest.newBuilder(URI.create(request.url()));
    for (Map.Entry<String, List<String>> header : request.headers().entrySet()) {
      header.getValue().forEach(value -> builder.header(header.getKey(), value));
    }
    String body = request.body();
    return builder
        .method(
            request.method().name(),
            body == null ? BodyPublishers.noBody() : BodyPublishers.ofString(body))
        .build();
  }

  private static void requireEvents(HttpResponse<?> response, BodyStream body) throws IOException {
    String type = response.headers().firstValue("Content-Type").orElse("").toLowerCase(Locale.ROOT);
    if (type.contains("html")) {
      String start = ErrorBody.start(body);
      throw new CallFailure(
          CallFailure.Kind.UNREADABLE,
          "the service sent a web page instead of an answer: " + start,
          "Check the service's 'url' in eventchain.yaml, and whether a proxy is in between.");
    }
  }

  private static CallFailure cut(IOException problem) {
    return new CallFailure(
        CallFailure.Kind.CUT, "the answer broke off: " + SourceText.reason(problem), "Try again.");
  }

  /** Builder of the existing transport, which has its own time limits. */
  private record Builder(Transport transport) implements HttpClientBuilder {

    @Override
    public Duration connectTimeout() {
      return CONNECT;
    }

    @Override
    public HttpClientBuilder connectTimeout(Duration timeout) {
      return this;
    }

    @Override
    public Duration readTimeout() {
      return transport.silence;
    }

    @Override
    public HttpClientBuilder readTimeout(Duration timeout) {
      return this;
    }

    @Override
    public HttpClient build() {
      return transport;
    }
  }
}
