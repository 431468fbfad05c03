package dev.eventchain.lsp.language;

import dev.eventchain.diagnostics.Cancellation;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.jsonrpc.CompletableFutures;

/**
 * The services of the languages, which answer one question after the other: they share what they
 * know of the same texts.
 */
public final class Languages implements AutoCloseable {

  private static final long STACK = 16L << 20;

  private final List<LanguageService> services;
  private final OpenTexts texts;
  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(
          work -> {
            Thread answers = new Thread(null, work, "answers", STACK);
            answers.setDaemon(true);
            return answers;
          });

  /** Creates the languages of a session. */
  public Languages(List<LanguageService> services, OpenTexts texts) {
    this.services = List.copyOf(services);
    this.texts = texts;
  }

  /** Answers a question about a text; what nobody knows is answered by the given value. */
  public <T> CompletableFuture<T> ask(String uri, T nothing, Function<Analysis, T> question) {
    return later(() -> analysis(uri).map(question).orElse(nothing));
  }

  /** As {@link #ask}, about a position. */
  public <T> CompletableFuture<T> ask(
      String uri, Position at, T nothing, BiFunction<Analysis, TextPosition, T> question) {
    TextPosition position = Positions.of(at);
    return ask(uri, nothing, analysis -> question.apply(analysis, position));
  }

  /** Answers in the background, unless or until the editor no longer wants to know. */
  public <T> CompletableFuture<T> later(Supplier<T> answer) {
    return CompletableFutures.computeAsync(
        thread,
        cancelled -> {
          cancelled.checkCanceled();
          return Cancellation.during(cancelled::isCanceled, answer);
        });
  }

  /** Returns what is known about a text, in the columns in which the editor counts it. */
  public Optional<Analysis> analysis(String uri) {
    return Positions.path(uri)
        .flatMap(
            path ->
                of(path)
                    .flatMap(each -> each.analysis(path))
                    .map(it -> texts.mark(path) == 0 ? it : new MarkedAnalysis(it)));
  }

  /** Returns the service of the language of a file. */
  public Optional<LanguageService> of(Path file) {
    return services.stream().filter(each -> each.handles(file)).findFirst();
  }

  /** Ends the work in the background. */
  @Override
  public void close() {
    thread.shutdownNow();
    try {
      thread.awaitTermination(1, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
