package dev.eventchain.documentation;

import java.util.Map;
import java.util.Set;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.renderer.NodeRenderer;
import org.commonmark.renderer.html.CoreHtmlNodeRenderer;
import org.commonmark.renderer.html.HtmlNodeRendererContext;
import org.commonmark.renderer.html.HtmlWriter;

/**
 * Renders {@code console} blocks so that copying one yields only its commands: prompts and output
 * are separate elements, which the style sheet excludes from selection.
 */
final class ConsoleBlocks implements NodeRenderer {

  private final HtmlWriter html;
  private final CoreHtmlNodeRenderer usual;

  ConsoleBlocks(HtmlNodeRendererContext context) {
    html = context.getWriter();
    usual = new CoreHtmlNodeRenderer(context);
  }

  @Override
  public Set<Class<? extends Node>> getNodeTypes() {
    return Set.of(FencedCodeBlock.class);
  }

  @Override
  public void render(Node node) {
    FencedCodeBlock block = (FencedCodeBlock) node;
    if (!block.getInfo().startsWith("console")) {
      usual.render(node);
      return;
    }
    html.line();
    html.tag("pre");
    html.tag("code");
    block.getLiteral().lines().forEach(this::line);
    html.tag("/code");
    html.tag("/pre");
    html.line();
  }

  private void line(String line) {
    if (line.startsWith("$ ") || line.startsWith("> ") || line.equals(">")) {
      int end = Math.min(2, line.length());
      element("prompt", line.substring(0, end));
      html.text(line.substring(end) + "\n");
    } else {
      element("printed", line + "\n");
    }
  }

  private void element(String kind, String text) {
    html.tag("span", Map.of("class", kind));
    html.text(text);
    html.tag("/span");
  }
}
