package dev.eventchain.documentation;

import java.util.List;
import java.util.Map;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/** Turns Markdown into a page of the site. */
final class PageTemplate {

  private static final List<Extension> EXTENSIONS =
      List.of(TablesExtension.create(), HeadingAnchorExtension.create());

  private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();

  /** Pages contain no HTML; quoted text must not become HTML. */
  private static final HtmlRenderer RENDERER =
      HtmlRenderer.builder()
          .extensions(EXTENSIONS)
          .escapeHtml(true)
          .nodeRendererFactory(ConsoleBlocks::new)
          .build();

  private PageTemplate() {}

  /**
   * Returns an HTML page.
   *
   * @param name its file name without ending, with the folder that it is in
   * @param navigation file name and text of each link
   */
  static String page(String name, String markdown, List<Map.Entry<String, String>> navigation) {
    String up = "../".repeat((int) name.chars().filter(each -> each == '/').count());
    Node document = PARSER.parse(markdown);
    document.accept(new PageLinks());
    StringBuilder links = new StringBuilder();
    for (Map.Entry<String, String> entry : navigation) {
      boolean here = entry.getKey().equals(name);
      links.append("<a href=\"").append(up).append(entry.getKey()).append(".html\"");
      links.append(here ? " aria-current=\"page\">" : ">");
      links.append(entry.getValue()).append("</a>\n");
    }
    return """
    <!DOCTYPE html>
    <html lang="en">
    <head>
    <meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1">
    <title>%s</title>
    <link rel="stylesheet" href="%sstyle.css">
    </head>
    <body>
    <nav>
    %s</nav>
    <main>
    %s</main>
    </body>
    </html>
    """
        .formatted(title(markdown), up, links, RENDERER.render(document));
  }

  private static String title(String markdown) {
    String first = markdown.lines().findFirst().orElse("").replaceFirst("^#+ *", "");
    String title = first.replace("`", "").replace("&", "&amp;").replace("<", "&lt;");
    return title.equals("Eventchain") ? title : title + " – Eventchain";
  }

  /** Links between pages of Markdown become links between pages of the site. */
  private static final class PageLinks extends AbstractVisitor {
    @Override
    public void visit(Link link) {
      String target = link.getDestination();
      if (!target.contains(":")) {
        link.setDestination(target.replaceFirst("\\.md(?=$|#)", ".html"));
      }
      visitChildren(link);
    }
  }
}
