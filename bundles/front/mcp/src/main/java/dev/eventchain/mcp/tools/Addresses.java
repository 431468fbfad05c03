package dev.eventchain.mcp.tools;

import io.modelcontextprotocol.util.McpUriTemplateManager;
import java.util.List;
import java.util.Map;

/**
 * Addresses that end with a name. Unlike those of the SDK, the name may have slashes, as a path
 * has.
 *
 * @param template the address with {@code {name}} at its end
 */
public record Addresses(String template) implements McpUriTemplateManager {

  private String prefix() {
    int brace = template.indexOf('{');
    return brace < 0 ? template : template.substring(0, brace);
  }

  @Override
  public List<String> getVariableNames() {
    return isUriTemplate(template)
        ? List.of(template.substring(prefix().length() + 1, template.length() - 1))
        : List.of();
  }

  @Override
  public Map<String, String> extractVariableValues(String uri) {
    return isUriTemplate(template) && matches(uri)
        ? Map.of(getVariableNames().get(0), uri.substring(prefix().length()))
        : Map.of();
  }

  @Override
  public boolean matches(String uri) {
    return isUriTemplate(template)
        ? uri.startsWith(prefix()) && uri.length() > prefix().length()
        : uri.equals(template);
  }

  @Override
  public boolean isUriTemplate(String uri) {
    return uri.endsWith("}") && uri.contains("{");
  }
}
