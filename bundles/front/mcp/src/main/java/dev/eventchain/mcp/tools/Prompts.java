package dev.eventchain.mcp.tools;

import dev.eventchain.diagnostics.ResourceText;
import io.modelcontextprotocol.server.McpServerFeatures.SyncPromptSpecification;
import io.modelcontextprotocol.spec.McpSchema;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The tasks of a language model, told to an agent that has the tools. */
public final class Prompts {

  private static final McpSchema.PromptArgument PROJECT =
      argument("project", "The project's folder, relative to the server's (default: itself).");
  private static final McpSchema.PromptArgument COMPONENT =
      argument("component", "The component's name.");

  private Prompts() {}

  /** Returns the prompts. */
  public static List<SyncPromptSpecification> all() {
    return List.of(
        prompt("design", "Design the event chain from the requirements", false),
        prompt("implement", "Implement a component of the chain", true),
        prompt("test", "Write tests of a component from its requirements", true),
        prompt("model", "Make the chain a model that fulfils all constraints", false),
        prompt("constrain", "Write the design rules as OCL", false),
        prompt("diagnose", "Find out why scenarios fail", false));
  }

  private static McpSchema.PromptArgument argument(String name, String description) {
    return McpSchema.PromptArgument.builder(name).description(description).required(false).build();
  }

  private static SyncPromptSpecification prompt(String name, String title, boolean component) {
    List<McpSchema.PromptArgument> arguments = new ArrayList<>(List.of(PROJECT));
    if (component) {
      arguments.add(COMPONENT);
    }
    McpSchema.Prompt prompt =
        McpSchema.Prompt.builder(name)
            .title(title)
            .description(title + ".")
            .arguments(arguments)
            .build();
    return new SyncPromptSpecification(
        prompt, (exchange, request) -> answer(name, title, request.arguments()));
  }

  private static McpSchema.GetPromptResult answer(
      String name, String title, Map<String, Object> given) {
    Map<String, Object> arguments = given == null ? Map.of() : given;
    String text =
        resource(name)
            .replace("{project}", value(arguments, "project", "."))
            .replace("{component}", value(arguments, "component", "the component in question"));
    McpSchema.PromptMessage message =
        McpSchema.PromptMessage.builder(
                McpSchema.Role.USER, McpSchema.TextContent.builder(text).build())
            .build();
    return McpSchema.GetPromptResult.builder(List.of(message)).description(title).build();
  }

  private static String value(Map<String, Object> arguments, String name, String otherwise) {
    Object value = arguments.get(name);
    return value == null || value.toString().isBlank() ? otherwise : value.toString();
  }

  private static String resource(String name) {
    return ResourceText.of(Prompts.class, name + ".md");
  }
}
