package dev.eventchain.mcp.tools;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.mcp.program.Ended;
import dev.eventchain.mcp.program.Program;
import dev.eventchain.mcp.project.Boundary;
import dev.eventchain.mcp.project.ProjectFiles;
import dev.eventchain.mcp.protocol.StandardStreams;
import io.modelcontextprotocol.server.McpServerFeatures.SyncResourceSpecification;
import io.modelcontextprotocol.server.McpServerFeatures.SyncResourceTemplateSpecification;
import io.modelcontextprotocol.server.McpSyncServerExchange;
import io.modelcontextprotocol.spec.McpError;
import io.modelcontextprotocol.spec.McpSchema;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;

/** Resources for clients: pages about findings, formats with their schemas, files. */
public final class Resources {

  private static final String RULES = "eventchain://rules/";
  private static final String FILES = "eventchain://files/";
  private static final String FORMATS = "eventchain://formats/";

  /** The commands that print the schema of a format. */
  private static final Map<String, List<String>> SCHEMAS =
      new TreeMap<>(
          Map.of(
              "settings", List.of("init", "--schema"),
              "suppressions", List.of("init", "--suppressions-schema"),
              "bench", List.of("bench", "--schema"),
              "scenario", List.of("bench", "--scenario-schema"),
              "faults", List.of("bench", "--faults-schema"),
              "campaign", List.of("campaign", "--schema"),
              "evaluation", List.of("evaluate", "--schema")));

  private final Commands commands;
  private final ProjectFiles files;

  /** Puts the resources together. */
  public Resources(Program program, Boundary boundary) {
    commands = new Commands(program, boundary);
    files = new ProjectFiles(boundary);
  }

  /** Returns the resources that have an address of their own. */
  public List<SyncResourceSpecification> all() {
    List<SyncResourceSpecification> all = new ArrayList<>();
    all.add(
        resource(
            "eventchain://rules",
            "rules",
            "All findings, each with the first sentence of its page.",
            "text/plain",
            exchange -> ruleList()));
    all.add(
        resource(
            "eventchain://files",
            "files",
            "The files in the folder of the server.",
            "application/json",
            exchange -> files.list()));
    SCHEMAS.forEach(
        (name, command) ->
            all.add(
                resource(
                    FORMATS + name,
                    name + " files",
                    "The JSON schema of " + name + " files.",
                    "application/schema+json",
                    exchange -> schema(command, exchange))));
    return all;
  }

  private static String ruleList() {
    StringBuilder text = new StringBuilder();
    for (RulePage page : RulePage.all()) {
      text.append(page.id()).append("  ").append(page.firstSentence()).append('\n');
    }
    return text.toString();
  }

  private String schema(List<String> command, McpSyncServerExchange exchange) {
    Ended ended = commands.output(command, StandardStreams.callOf(exchange.transportContext()));
    if (ended.code() != 0) {
      throw new IllegalStateException(ended.err());
    }
    return ended.out();
  }

  private static SyncResourceSpecification resource(
      String uri,
      String name,
      String description,
      String type,
      Function<McpSyncServerExchange, String> text) {
    McpSchema.Resource resource =
        McpSchema.Resource.builder(uri, name).description(description).mimeType(type).build();
    return new SyncResourceSpecification(
        resource, (exchange, request) -> read(uri, type, () -> text.apply(exchange)));
  }

  /** Returns the resources with a name in their address. */
  public List<SyncResourceTemplateSpecification> templates() {
    return List.of(
        template(
            RULES + "{id}",
            "rule",
            "The page of a finding: what it means, and what to do.",
            "text/markdown",
            Resources::rulePage),
        template(
            FILES + "{path}",
            "file",
            "A text file, by its path in the folder of the server.",
            "text/plain",
            uri -> files.text(nameIn(uri, FILES))));
  }

  private static String rulePage(String uri) {
    String id = nameIn(uri, RULES);
    return RulePage.of(id)
        .map(RulePage::text)
        .orElseThrow(() -> notFound(uri, "There is no finding '" + id + "'."));
  }

  private static SyncResourceTemplateSpecification template(
      String uri, String name, String description, String type, Function<String, String> text) {
    McpSchema.ResourceTemplate template =
        McpSchema.ResourceTemplate.builder(uri, name)
            .description(description)
            .mimeType(type)
            .build();
    return new SyncResourceTemplateSpecification(
        template,
        (exchange, request) -> read(request.uri(), type, () -> text.apply(request.uri())));
  }

  private static String nameIn(String uri, String prefix) {
    try {
      return URLDecoder.decode(
          uri.substring(prefix.length()).replace("+", "%2B"), StandardCharsets.UTF_8);
    } catch (IllegalArgumentException e) {
      throw notFound(uri, "This is no address: " + e.getMessage());
    }
  }

  /** Content of a resource. */
  private interface Text {
    String get();
  }

  private static McpSchema.ReadResourceResult read(String uri, String type, Text text) {
    try {
      McpSchema.ResourceContents contents =
          McpSchema.TextResourceContents.builder(uri, text.get())
              .mimeType(type)
              .meta(Catalog.DATA)
              .build();
      return McpSchema.ReadResourceResult.builder(List.of(contents)).build();
    } catch (DiagnosticException e) {
      throw notFound(uri, DiagnosticFormat.TEXT.render(e.diagnostics()));
    }
  }

  private static McpError notFound(String uri, String message) {
    return McpError.builder(McpSchema.ErrorCodes.RESOURCE_NOT_FOUND)
        .message(message)
        .data(Map.of("uri", uri))
        .build();
  }
}
