package dev.eventchain.llm.service;

import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.UnaryOperator;

/** Checks which services can be reached, without a key and without cost. */
public final class ServiceProbe {
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  /**
   * The state of a service from this machine.
   *
   * @param key the environment variable with its key; empty if it needs none
   * @param keyIsSet true if that variable has a value
   * @param problem the reason why it cannot be reached; empty if it can
   */
  public record State(
      String name, String url, Optional<String> key, boolean keyIsSet, Optional<String> problem) {

    /** Returns whether its models can be asked. */
    public boolean isReady() {
      return problem.isEmpty() && (key.isEmpty() || keyIsSet);
    }
  }

  private ServiceProbe() {}

  /**
   * Probes services concurrently, for some seconds at most.
   *
   * @param names the names of services; unknown ones are left out
   * @param environment the value of an environment variable, null if it is not set
   */
  public static List<State> look(
      ModelServices services, Collection<String> names, UnaryOperator<String> environment) {
    HttpClient client =
        HttpClient.newBuilder()
            .version(HttpClient.Version.HTTP_1_1)
            .followRedirects(HttpClient.Redirect.NEVER)
            .connectTimeout(PATIENCE)
            .build();
    List<CompletableFuture<State>> states =
        names.stream()
            .sorted()
            .distinct()
            .flatMap(name -> services.service(name).stream())
            .map(service -> look(client, service, environment))
            .toList();
    return states.stream().map(CompletableFuture::join).toList();
  }

  /** Probes a service. Any response counts as reachable, including a refusal without a key. */
  private static CompletableFuture<State> look(
      HttpClient client, ModelService service, UnaryOperator<String> environment) {
    HttpRequest request = HttpRequest.newBuilder(service.url()).timeout(PATIENCE).GET().build();
    return client
        .sendAsync(request, BodyHandlers.discarding())
        .handle(
            (response, failure) ->
                new State(
                    service.name(),
                    service.url().toString(),
                    service.key(),
                    service.key().map(environment).filter(key -> !key.isBlank()).isPresent(),
                    Optional.ofNullable(failure).map(ConnectionProblem::words)));
  }
}
