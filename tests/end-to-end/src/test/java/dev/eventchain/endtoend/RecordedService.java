package dev.eventchain.endtoend;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/**
 * A local language model service that answers with recordings, in the format of any kind of
 * service. It recognises a prompt by its last message.
 */
final class RecordedService implements AutoCloseable {

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final int PIECE = 500;

  private final String wire;
  private final Map<String, String> answers = new TreeMap<>();
  private final List<String> headers = Collections.synchronizedList(new ArrayList<>());
  private final HttpServer server;

  /**
   * Starts the service.
   *
   * @param wire the protocol, as in {@code eventchain.yaml}
   * @param recordings a folder of recordings
   */
  RecordedService(String wire, Path recordings) throws IOException {
    this.wire = wire;
    try (Stream<Path> files = Files.walk(recordings)) {
      files.filter(file -> file.toString().endsWith(".json")).forEach(this::read);
    }
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext("/", this::answer);
    server.start();
  }

  private void read(Path file) {
    try {
      JsonNode recording = MAPPER.readTree(file.toFile());
      JsonNode messages = recording.at("/request/messages");
      String question = lines(messages.get(messages.size() - 1).get("content"));
      answers.put(question, lines(recording.at("/samples/0/text")));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String lines(JsonNode text) {
    return text.isTextual()
        ? text.asText()
        : String.join(
            "\n", StreamSupport.stream(text.spliterator(), false).map(JsonNode::asText).toList());
  }

  /** Returns the address, as a project's {@code url}. */
  String url() {
    return "http://localhost:" + server.getAddress().getPort();
  }

  /** Returns all headers of all requests. */
  String headers() {
    return String.join("\n", headers);
  }

  /** Returns the number of requests. */
  int requests() {
    return headers.size();
  }

  private void answer(HttpExchange exchange) throws IOException {
    headers.add(String.valueOf(exchange.getRequestHeaders().entrySet()));
    JsonNode request = MAPPER.readTree(exchange.getRequestBody());
    String answer = answers.get(question(request));
    int status = answer == null ? 404 : 200;
    exchange.getResponseHeaders().add("Content-Type", "text/event-stream");
    exchange.sendResponseHeaders(status, 0);
    try (OutputStream body = exchange.getResponseBody()) {
      String text = answer == null ? "{\"error\": \"no such recording\"}" : stream(answer);
      body.write(text.getBytes(StandardCharsets.UTF_8));
    }
  }

  /** Returns the last text of the last message, wherever the format has it. */
  private static String question(JsonNode request) {
    JsonNode messages = request.has("contents") ? request.get("contents") : request.get("messages");
    JsonNode last = messages.get(messages.size() - 1);
    JsonNode content = last.has("parts") ? last.get("parts") : last.get("content");
    return content.isTextual() ? content.asText() : content.get(0).get("text").asText();
  }

  private String stream(String answer) {
    StringBuilder out = new StringBuilder();
    if (wire.equals("anthropic")) {
      event(
          out,
          "{'type':'message_start','message':{'id':'m','model':'authored','content':[],'usage':{'input_tokens':9,'output_tokens':1}}}");
      event(
          out,
          "{'type':'content_block_start','index':0,'content_block':{'type':'text','text':''}}");
    }
    for (int at = 0; at < answer.length(); at += PIECE) {
      event(out, piece(), answer.substring(at, Math.min(answer.length(), at + PIECE)));
    }
    end(out);
    return out.toString();
  }

  private String piece() {
    return switch (wire) {
      case "gemini" ->
          "{'candidates':[{'content':{'role':'model','parts':[{'text':'@'}]}}],'modelVersion':'authored'}";
      case "anthropic" ->
          "{'type':'content_block_delta','index':0,'delta':{'type':'text_delta','text':'@'}}";
      case "ollama" ->
          "{'model':'authored','message':{'role':'assistant','content':'@'},'done':false}";
      default -> "{'id':'c','model':'authored','choices':[{'index':0,'delta':{'content':'@'}}]}";
    };
  }

  private void end(StringBuilder out) {
    switch (wire) {
      case "gemini" ->
          event(
              out,
              "{'candidates':[{'content':{'role':'model','parts':[{'text':''}]},'finishReason':'STOP'}],'modelVersion':'authored','usageMetadata':{'promptTokenCount':9,'candidatesTokenCount':9,'totalTokenCount':18}}");
      case "anthropic" -> {
        event(out, "{'type':'content_block_stop','index':0}");
        event(
            out,
            "{'type':'message_delta','delta':{'stop_reason':'end_turn'},'usage':{'output_tokens':9}}");
        event(out, "{'type':'message_stop'}");
      }
      case "ollama" ->
          event(
              out,
              "{'model':'authored','message':{'role':'assistant','content':''},'done':true,'done_reason':'stop','prompt_eval_count':9,'eval_count':9}");
      default -> {
        event(
            out,
            "{'id':'c','model':'authored','choices':[{'index':0,'delta':{},'finish_reason':'stop'}]}");
        event(
            out,
            "{'id':'c','model':'authored','choices':[],'usage':{'prompt_tokens':9,'completion_tokens':9,'total_tokens':18}}");
        out.append("data: [DONE]\n\n");
      }
    }
  }

  private void event(StringBuilder out, String json) {
    event(out, json, "");
  }

  /** Appends an event with a text in place of the mark. */
  private void event(StringBuilder out, String json, String text) {
    try {
      JsonNode tree = MAPPER.readTree(json.replace('\'', '"'));
      put(tree, text);
      if (wire.equals("ollama")) {
        out.append(tree).append('\n');
      } else {
        String type = tree.path("type").asText("");
        out.append(type.isEmpty() ? "" : "event: " + type + "\n");
        out.append("data: ").append(tree).append("\n\n");
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void put(JsonNode tree, String text) {
    tree.findParents("content").forEach(each -> put(each, "content", text));
    tree.findParents("text").forEach(each -> put(each, "text", text));
  }

  private static void put(JsonNode object, String key, String text) {
    if (object.path(key).asText("").equals("@")) {
      ((ObjectNode) object).put(key, text);
    }
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
