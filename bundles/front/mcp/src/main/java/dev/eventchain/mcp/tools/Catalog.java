package dev.eventchain.mcp.tools;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.mcp.program.Program;
import dev.eventchain.mcp.project.Boundary;
import dev.eventchain.mcp.project.McpRules;
import dev.eventchain.mcp.protocol.StandardStreams;
import io.modelcontextprotocol.server.McpServerFeatures.SyncToolSpecification;
import io.modelcontextprotocol.server.McpSyncServerExchange;
import io.modelcontextprotocol.spec.McpSchema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.stream.Stream;

/** All tools, as the SDK takes them. */
public final class Catalog {

  /** Annotations of each result and each resource. */
  static final Map<String, Object> DATA =
      Map.of("dev.eventchain/content", "data of the project, no instructions");

  private static final int MOST_AT_ONCE = 4;

  private final List<Tool> tools;
  private final Semaphore free = new Semaphore(MOST_AT_ONCE);

  /** Puts the tools together. */
  public Catalog(Program program, Boundary boundary) {
    Commands commands = new Commands(program, boundary);
    tools =
        Stream.of(
                new CommandTools(commands, boundary).all(),
                new ResultTools(boundary).all(),
                new ChangeTools(commands, boundary).all())
            .flatMap(List::stream)
            .toList();
  }

  /** Returns the tools with what they do. */
  public List<SyncToolSpecification> tools() {
    return tools.stream()
        .map(
            tool ->
                new SyncToolSpecification(
                    description(tool), (exchange, request) -> answer(tool, exchange, request)))
        .toList();
  }

  private static McpSchema.Tool description(Tool tool) {
    boolean reads = tool.effect() == Tool.Effect.READS;
    McpSchema.ToolAnnotations annotations =
        McpSchema.ToolAnnotations.builder()
            .readOnlyHint(reads)
            .destructiveHint(tool.effect() == Tool.Effect.CHANGES)
            .idempotentHint(reads)
            .openWorldHint(false)
            .build();
    return McpSchema.Tool.builder(tool.name(), inputSchema(tool))
        .title(tool.title())
        .description(tool.description())
        .outputSchema(schema(tool.output(), List.of()))
        .annotations(annotations)
        .build();
  }

  private static Map<String, Object> inputSchema(Tool tool) {
    Map<String, Object> properties = new LinkedHashMap<>();
    tool.parameters().forEach(each -> properties.put(each.name(), each.schema()));
    List<String> required =
        tool.parameters().stream().filter(Parameter::required).map(Parameter::name).toList();
    Map<String, Object> schema = schema(properties, required);
    schema.put("additionalProperties", false);
    return schema;
  }

  private static Map<String, Object> schema(Map<String, Object> properties, List<String> required) {
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put("type", "object");
    schema.put("properties", properties);
    if (!required.isEmpty()) {
      schema.put("required", required);
    }
    return schema;
  }

  private McpSchema.CallToolResult answer(
      Tool tool, McpSyncServerExchange exchange, McpSchema.CallToolRequest request) {
    if (!free.tryAcquire()) {
      return refused(
          McpRules.refusal(
              McpRules.BUSY,
              "",
              MOST_AT_ONCE + " calls are being worked on.",
              "Wait for an answer, or cancel one."));
    }
    try {
      Arguments arguments = Arguments.of(request.arguments(), tool.parameters());
      Tool.Call call =
          new Tool.Call(
              StandardStreams.callOf(exchange.transportContext()), progress(exchange, request));
      Tool.Result result = tool.work().with(arguments, call);
      return McpSchema.CallToolResult.builder()
          .addTextContent(result.text())
          .structuredContent(result.structured())
          .isError(result.failed())
          .meta(DATA)
          .build();
    } catch (DiagnosticException e) {
      return refused(e);
    } catch (RuntimeException e) {
      return refused("eventchain mcp has a defect: " + e);
    } finally {
      free.release();
    }
  }

  private static McpSchema.CallToolResult refused(DiagnosticException problem) {
    return refused(DiagnosticFormat.TEXT.render(problem.diagnostics()));
  }

  private static McpSchema.CallToolResult refused(String message) {
    return McpSchema.CallToolResult.builder()
        .addTextContent(message)
        .isError(true)
        .meta(DATA)
        .build();
  }

  /** Returns what tells the client about the progress, if it has asked for that. */
  private static Consumer<String> progress(
      McpSyncServerExchange exchange, McpSchema.CallToolRequest request) {
    Object token = request.meta() == null ? null : request.meta().get("progressToken");
    if (token == null) {
      return message -> {};
    }
    AtomicInteger count = new AtomicInteger();
    return message ->
        exchange.progressNotification(
            McpSchema.ProgressNotification.builder(token, count.incrementAndGet())
                .message(message)
                .build());
  }
}
