package dev.eventchain.mcp;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A client that speaks the protocol by itself, and the server in a thread of its own. */
final class Client {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final long LONGEST_SECONDS = 60;

  private final PipedOutputStream toServer = new PipedOutputStream();
  private final BlockingQueue<JsonNode> messages = new LinkedBlockingQueue<>();
  private final Thread server;
  private int lastId;

  /** Starts a server whose commands are those of a script of {@code sh}. */
  Client(Path folder, Path script) throws IOException {
    PipedInputStream in = new PipedInputStream(toServer, 1 << 16);
    AgentServer opened =
        AgentServer.open(
            in, new Lines(), folder, List.of("sh", script.toAbsolutePath().toString()), "1");
    server = new Thread(opened::serve, "server");
    server.setDaemon(true);
    server.start();
  }

  /** What the server writes: each line has to be JSON. */
  private final class Lines extends OutputStream {
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();

    @Override
    public void write(int next) throws IOException {
      line.write(next);
      if (next == '\n') {
        messages.add(JSON.readTree(line.toByteArray()));
        line.reset();
      }
    }
  }

  /** Begins the session. */
  JsonNode begin(String version) throws Exception {
    JsonNode answer =
        request(
            "initialize",
            Map.of(
                "protocolVersion",
                version,
                "capabilities",
                Map.of(),
                "clientInfo",
                Map.of("name", "test", "version", "1")));
    line("{\"jsonrpc\":\"2.0\",\"method\":\"notifications/initialized\"}");
    return answer;
  }

  /** As above, in the newest version. */
  Client begun() throws Exception {
    begin("2025-11-25");
    return this;
  }

  /** Sends a line as it is. */
  void line(String line) throws IOException {
    bytes((line + "\n").getBytes(StandardCharsets.UTF_8));
  }

  void bytes(byte[] bytes) throws IOException {
    toServer.write(bytes);
    toServer.flush();
  }

  /** Returns the next message. */
  JsonNode next() throws InterruptedException {
    JsonNode message = messages.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
    if (message == null) {
      throw new AssertionError("the server is silent");
    }
    return message;
  }

  /** Sends a request; returns its id. */
  int send(String method, Object parameters) throws IOException {
    ObjectNode request = JSON.createObjectNode().put("jsonrpc", "2.0").put("id", ++lastId);
    request.put("method", method).set("params", JSON.valueToTree(parameters));
    line(request.toString());
    return lastId;
  }

  /** Returns the answer to a request. */
  JsonNode request(String method, Object parameters) throws Exception {
    return answer(send(method, parameters), new ArrayList<>());
  }

  /** Returns the answer to a request, and collects what comes before it. */
  JsonNode answer(int id, List<JsonNode> before) throws InterruptedException {
    for (JsonNode message = next(); ; message = next()) {
      if (message.path("id").asInt(-1) == id) {
        return message;
      }
      before.add(message);
    }
  }

  /** Returns the result of a tool. */
  JsonNode call(String tool, Map<String, Object> arguments) throws Exception {
    return request("tools/call", Map.of("name", tool, "arguments", arguments)).path("result");
  }

  /** Returns what a tool says to a reader. */
  String text(String tool, Map<String, Object> arguments) throws Exception {
    return call(tool, arguments).at("/content/0/text").asText();
  }

  /** Ends the input; fails if the server does not end soon. */
  void end() throws Exception {
    toServer.close();
    server.join(TimeUnit.SECONDS.toMillis(LONGEST_SECONDS));
    if (server.isAlive()) {
      throw new AssertionError("the server goes on after the end of its input");
    }
  }
}
