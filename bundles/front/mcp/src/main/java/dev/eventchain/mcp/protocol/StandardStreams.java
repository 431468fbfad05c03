package dev.eventchain.mcp.protocol;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.mcp.program.RunningCall;
import io.modelcontextprotocol.common.McpTransportContext;
import io.modelcontextprotocol.json.McpJsonMapper;
import io.modelcontextprotocol.json.TypeRef;
import io.modelcontextprotocol.spec.McpSchema;
import io.modelcontextprotocol.spec.McpServerSession;
import io.modelcontextprotocol.spec.McpServerTransport;
import io.modelcontextprotocol.spec.McpServerTransportProvider;
import io.modelcontextprotocol.spec.ProtocolVersions;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import reactor.core.publisher.Mono;

/**
 * The protocol on two streams, a message a line. What the SDK's own transport does not do, this
 * does: it cancels requests, answers lines that are no messages, and stops at the end of input.
 */
public final class StandardStreams implements McpServerTransportProvider {

  private static final String CALL = "dev.eventchain.mcp.call";
  private static final String CANCELLED = "notifications/cancelled";

  /** Methods that are answered before the session has begun. */
  private static final List<String> BEFORE = List.of("initialize", "ping");

  private static final ObjectMapper JSON =
      new ObjectMapper().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

  private final McpJsonMapper mapper;
  private final InputStream in;
  private final OutputStream out;
  private final RunningCalls calls = new RunningCalls();
  private final Transport transport = new Transport();
  private McpServerSession session;
  private boolean begun;

  /**
   * Prepares the streams; {@link #serve()} reads them.
   *
   * @param mapper the SDK's reader of messages
   */
  public StandardStreams(McpJsonMapper mapper, InputStream in, OutputStream out) {
    this.mapper = mapper;
    this.in = new BufferedInputStream(in);
    this.out = out;
  }

  /** Returns the request that a context belongs to. */
  public static RunningCall callOf(McpTransportContext context) {
    return context.get(CALL) instanceof RunningCall call ? call : new RunningCall();
  }

  /** Reads messages until the input ends. */
  public void serve() {
    InputLines lines = new InputLines(in);
    try {
      for (Optional<InputLines.Line> line = lines.next(); line.isPresent(); line = lines.next()) {
        if (!line.get().isBlank()) {
          receive(line.get());
        }
      }
    } catch (IOException e) {
      // A stream that breaks has ended.
    }
  }

  /** Cancels what is running; returns the processes that are ending. */
  public List<ProcessHandle> stop() {
    return calls.cancelAll();
  }

  /** Waits until nothing is running, or for a time. */
  public void awaitNone(Duration patience) {
    calls.awaitNone(patience);
  }

  private void receive(InputLines.Line line) throws IOException {
    if (!line.whole()) {
      refuse(
          null,
          McpSchema.ErrorCodes.INVALID_REQUEST,
          "A message may have " + InputLines.LONGEST + " bytes; this one is longer.");
      return;
    }
    JsonNode message;
    try {
      message = JSON.readTree(line.bytes());
    } catch (IOException e) {
      refuse(null, McpSchema.ErrorCodes.PARSE_ERROR, "This line is not JSON: " + reason(e));
      return;
    }
    if (message.path("method").asText().equals(CANCELLED)) {
      calls.cancel(key(message.at("/params/requestId")));
    } else {
      handle(message);
    }
  }

  private void handle(JsonNode message) throws IOException {
    JsonNode id = message.path("id");
    boolean known = id.isTextual() || id.isIntegralNumber();
    McpSchema.JSONRPCMessage read;
    try {
      read = read(message);
    } catch (IOException | IllegalArgumentException e) {
      String text = "This is no message of JSON-RPC: " + reason(e);
      refuse(known ? id : null, McpSchema.ErrorCodes.INVALID_REQUEST, text);
      return;
    }
    String method = message.path("method").asText();
    begun |= method.equals("initialize");
    if (!begun && known && !method.isEmpty() && !isAnswerable(method)) {
      refuse(id, McpSchema.ErrorCodes.INVALID_REQUEST, "The session begins with 'initialize'.");
    } else if (read instanceof McpSchema.JSONRPCRequest) {
      handle(read, calls.begin(key(id)), problem -> fail(id, problem));
    } else {
      handle(read, new RunningCall(), problem -> {});
    }
  }

  private McpSchema.JSONRPCMessage read(JsonNode message) throws IOException {
    if (!message.path("jsonrpc").asText().equals("2.0")) {
      throw new IllegalArgumentException("it is no object with \"jsonrpc\": \"2.0\"");
    }
    return McpSchema.deserializeJsonRpcMessage(mapper, message.toString());
  }

  private void handle(
      McpSchema.JSONRPCMessage message, RunningCall call, Consumer<Throwable> failure) {
    McpTransportContext context = McpTransportContext.create(Map.of(CALL, call));
    session
        .handle(message)
        .contextWrite(it -> it.put(McpTransportContext.KEY, context))
        .subscribe(nothing -> {}, failure);
  }

  /** Answers a request that the session could not handle. */
  private void fail(JsonNode id, Throwable problem) {
    try {
      if (calls.end(key(id))) {
        refuse(id, McpSchema.ErrorCodes.INTERNAL_ERROR, problem.toString());
      }
    } catch (IOException e) {
      stop(); // Nobody reads any more.
    }
  }

  /** Returns whether the SDK answers a method at once, if only that it does not know it. */
  private static boolean isAnswerable(String method) {
    return BEFORE.contains(method)
        || !List.of("tools", "resources", "prompts", "completion", "logging")
            .contains(method.replaceFirst("/.*", ""));
  }

  /** Returns an id as a key: 7 and "7" are two. */
  private static String key(JsonNode id) {
    return id.toString();
  }

  private static String reason(Exception problem) {
    return problem instanceof JsonProcessingException json
        ? json.getOriginalMessage()
        : problem.getMessage();
  }

  private void refuse(JsonNode id, int code, String text) throws IOException {
    ObjectNode answer = JSON.createObjectNode().put("jsonrpc", "2.0");
    answer.set("id", id);
    answer.putObject("error").put("code", code).put("message", text);
    write(JSON.writeValueAsBytes(answer));
  }

  private void write(byte[] message) throws IOException {
    synchronized (out) {
      out.write(message);
      out.write('\n');
      out.flush();
    }
  }

  @Override
  public void setSessionFactory(McpServerSession.Factory factory) {
    session = factory.create(transport);
  }

  @Override
  public Mono<Void> notifyClients(String method, Object parameters) {
    return session.sendNotification(method, parameters);
  }

  @Override
  public Mono<Void> closeGracefully() {
    return Mono.empty();
  }

  @Override
  public List<String> protocolVersions() {
    return List.of(
        ProtocolVersions.MCP_2024_11_05,
        ProtocolVersions.MCP_2025_03_26,
        ProtocolVersions.MCP_2025_06_18,
        ProtocolVersions.MCP_2025_11_25);
  }

  /** The way of messages to the client. */
  private final class Transport implements McpServerTransport {

    @Override
    public Mono<Void> sendMessage(McpSchema.JSONRPCMessage message) {
      return Mono.fromRunnable(() -> send(message));
    }

    private void send(McpSchema.JSONRPCMessage message) {
      boolean wanted =
          !(message instanceof McpSchema.JSONRPCResponse answer)
              || calls.end(key(JSON.valueToTree(answer.id())));
      if (!wanted) {
        return;
      }
      try {
        write(mapper.writeValueAsBytes(message));
      } catch (IOException e) {
        // Nobody reads any more: the end of input follows.
        stop();
      }
    }

    @Override
    public <T> T unmarshalFrom(Object data, TypeRef<T> type) {
      return mapper.convertValue(data, type);
    }

    @Override
    public List<String> protocolVersions() {
      return StandardStreams.this.protocolVersions();
    }

    @Override
    public Mono<Void> closeGracefully() {
      return Mono.empty();
    }
  }
}
