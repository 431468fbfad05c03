package dev.eventchain.pipeline.report;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Sha256;
import java.util.Base64;

/**
 * A self-contained HTML page without scripts, in the style of the report. Its
 * Content-Security-Policy allows only exactly its style.
 */
public final class StaticPage {

  private final StringBuilder out = new StringBuilder();

  /**
   * Begins a page.
   *
   * @param title its title, without the name of this program
   * @param ownStyle CSS besides that of the report
   */
  public StaticPage(String title, String ownStyle) {
    String style = "\n" + ReportPage.resource("report.css") + ownStyle;
    String hash = Base64.getEncoder().encodeToString(Sha256.of(style).bytes());
    raw("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    raw(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src"
            + " 'sha256-");
    raw(hash + "'; base-uri 'none'; form-action 'none'\">\n");
    raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    add("<title>%s · Eventchain</title>\n", title);
    raw("<style>" + style + "</style>\n</head>\n<body>\n");
  }

  /** Adds HTML as it is. */
  public void raw(String html) {
    out.append(html);
  }

  /** Adds HTML with a text, which is escaped, for each {@code %s}. */
  public void add(String html, Object... texts) {
    int from = 0;
    for (Object text : texts) {
      int place = html.indexOf("%s", from);
      out.append(html, from, place).append(escaped(String.valueOf(text)));
      from = place + 2;
    }
    out.append(html, from, html.length());
  }

  private static String escaped(String text) {
    return Printable.clean(text)
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
        .replace("'", "&#39;");
  }

  /** Ends the page with a footer, and returns it. */
  public String end(String footer) {
    add("<footer>%s</footer>\n</body>\n</html>\n", footer);
    return out.toString();
  }
}
