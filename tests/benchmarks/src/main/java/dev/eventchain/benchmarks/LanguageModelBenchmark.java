package dev.eventchain.benchmarks;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.ModelAccess;
import dev.eventchain.llm.Spending;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.service.ModelServices;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;

/**
 * Times the overhead of a language model call: to a local server that streams the same answer
 * immediately, through the program's transport and with handwritten code; and answers from 10 and
 * from 10,000 recordings. Medians in one process; the first calls are not counted.
 */
public final class LanguageModelBenchmark {
  private static final int WARM_UP = 50;
  private static final int CALLS = 200;
  private static final String PROMPT =
      "Write the component. ".repeat(1_500); // 30 kB, like typical answers
  private static final String CHUNK =
      "data: {\"id\": \"c\", \"object\": \"chat.completion.chunk\", \"created\": 1, \"model\":"
          + " \"m\", \"choices\": [{\"index\": 0, \"delta\": {\"content\": \"%s\"},"
          + " \"finish_reason\": %s}]}\n\n";
  private static final String ANSWER =
      CHUNK.formatted("a few words of an answer ", "null").repeat(300)
          + CHUNK.formatted("", "\"stop\"")
          + "data: [DONE]\n\n";

  private static final HttpClient CLIENT = HttpClient.newHttpClient();

  private LanguageModelBenchmark() {}

  /**
   * Prints the milliseconds per call.
   *
   * @param arguments nothing
   */
  public static void main(String[] arguments) throws Exception {
    System.setProperty(
        "sun.net.httpserver.nodelay", "true"); // otherwise it waits 40 ms for each answer
    HttpServer server =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext("/", LanguageModelBenchmark::answer);
    server.setExecutor(Executors.newCachedThreadPool());
    server.start();
    URI url = URI.create("http://localhost:" + server.getAddress().getPort() + "/v1");
    Path recordings = Files.createTempDirectory("llm-benchmark");
    ChatModel live = model("live", url, recordings, false);
    double byHand = print("by hand, java.net.http", () -> post(url));
    double ours = print("through the program", () -> live.chat(request("live")));
    System.out.printf(Locale.ROOT, "%-32s %9.2f ms%n", "more", ours - byHand);
    record(url, recordings, 0, 10);
    print("replay, 10 recordings", () -> replay(url, recordings));
    record(url, recordings, 10, 10_000);
    print("replay, 10,000 recordings", () -> replay(url, recordings));
    server.stop(0);
    System.exit(0);
  }

  private static void answer(HttpExchange exchange) throws IOException {
    exchange.getRequestBody().readAllBytes();
    byte[] body = ANSWER.getBytes(StandardCharsets.UTF_8);
    exchange.getResponseHeaders().add("Content-Type", "text/event-stream");
    exchange.sendResponseHeaders(200, body.length);
    exchange.getResponseBody().write(body);
    exchange.close();
  }

  private static ChatModel model(String source, URI url, Path recordings, boolean record) {
    SourceText text =
        SourceText.of(
            "s.yaml", "services:\n  ours: {wire: openai-compatible, url: \"" + url + "\"}\n");
    ModelServices services =
        Document.parse(text, DocumentFormat.YAML, DocumentRules.all(Rule.error("s")), problem -> {})
            .object("", problem -> {})
            .map(ModelServices::read)
            .orElseThrow();
    ModelAccess access =
        new ModelAccess(
            source,
            recordings,
            record,
            services,
            new Spending(services),
            name -> null,
            message -> {},
            finding -> {});
    return ChatModels.open(access, List.of("ours/m"));
  }

  private static ChatRequest request(String which) {
    return ChatRequest.of("implement", List.of(ChatMessage.user(PROMPT + which)));
  }

  private static void record(URI url, Path recordings, int from, int to) {
    ChatModel recording = model("live", url, recordings, true);
    for (int i = from; i < to; i++) {
      recording.chat(request("recorded " + i));
    }
  }

  private static Object replay(URI url, Path recordings) {
    return model("replay", url, recordings, false).chat(request("recorded 3"));
  }

  private static Object post(URI url) throws IOException, InterruptedException {
    String body = "{\"messages\": [{\"role\": \"user\", \"content\": \"" + PROMPT + "\"}]}";
    HttpRequest request =
        HttpRequest.newBuilder(url).POST(HttpRequest.BodyPublishers.ofString(body)).build();
    return CLIENT.send(request, HttpResponse.BodyHandlers.ofString()).body();
  }

  private static double print(String name, Callable<Object> call) throws Exception {
    double[] times = new double[CALLS];
    for (int i = -WARM_UP; i < CALLS; i++) {
      long start = System.nanoTime();
      call.call();
      if (i >= 0) {
        times[i] = (System.nanoTime() - start) / 1e6;
      }
    }
    Arrays.sort(times);
    System.out.printf(
        Locale.ROOT,
        "%-32s %9.2f ms (%.2f to %.2f)%n",
        name,
        times[CALLS / 2],
        times[0],
        times[CALLS - 1]);
    return times[CALLS / 2];
  }
}
