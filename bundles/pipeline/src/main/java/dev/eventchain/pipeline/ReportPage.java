package dev.eventchain.pipeline;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.CharacterEscapes;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The report of a run as one HTML file that needs nothing else: style, script and data are inside,
 * and its Content-Security-Policy lets only exactly this style and this script take effect.
 *
 * <p>The data is untrusted: models, LLMs and file names speak in it. It stands in the page as JSON
 * in which nothing can end the element or start another; the script turns it into text nodes only.
 * A viewer that runs no script shows title, verdict and summary.
 */
final class ReportPage {

  /** In the order in which they make up the script; later parts use earlier ones. */
  private static final List<String> SCRIPTS =
      List.of("dom.js", "plots.js", "chain.js", "scenarios.js", "report.js");

  private static final Pattern PLACE = Pattern.compile("\\{\\{(\\w+)}}");

  private ReportPage() {}

  /**
   * The page in UTF-8. The same data, in the same order, gives the same bytes.
   *
   * @param data an object with what the run found out; every part of it may be absent
   */
  static byte[] render(JsonNode data) {
    String style = "\n" + resource("report.css");
    String script =
        SCRIPTS.stream()
            .map(ReportPage::resource)
            .collect(Collectors.joining("\n", "\n\"use strict\";\n", ""));
    JsonNode project = data.path("project");
    String title = project.path("title").asText(project.path("name").asText());
    Map<String, String> parts =
        Map.of(
            "policy", policy(style, script),
            "title", escapeHtml("Eventchain report: " + title),
            "verdict", escapeHtml(project.path("verdict").asText("incomplete")),
            "summary", escapeHtml(project.path("summary").asText()),
            "style", style,
            "script", script,
            "data", json(data));
    return PLACE
        .matcher(resource("report.html"))
        .replaceAll(place -> Matcher.quoteReplacement(parts.get(place.group(1))))
        .getBytes(StandardCharsets.UTF_8);
  }

  private static String policy(String style, String script) {
    return "default-src 'none'; style-src '%s'; script-src '%s'; base-uri 'none'; form-action 'none'"
        .formatted(hash(style), hash(script));
  }

  private static String hash(String text) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
      return "sha256-" + Base64.getEncoder().encodeToString(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("Every Java platform has SHA-256", e);
    }
  }

  /** JSON in ASCII without a character that means something to HTML. */
  private static String json(JsonNode data) {
    JsonMapper mapper = JsonMapper.builder().build();
    StringWriter text = new StringWriter();
    try (JsonGenerator generator = mapper.createGenerator(text)) {
      generator.setCharacterEscapes(new HtmlSafe());
      generator.enable(JsonWriteFeature.ESCAPE_NON_ASCII.mappedFeature());
      mapper.writeTree(generator, data);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }

  private static String escapeHtml(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  private static String resource(String name) {
    try (InputStream stream = ReportPage.class.getResourceAsStream("report/" + name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static final class HtmlSafe extends CharacterEscapes {

    private static final long serialVersionUID = 1L;

    private final int[] escapes = standardAsciiEscapesForJSON();

    HtmlSafe() {
      for (char special : new char[] {'<', '>', '&'}) {
        escapes[special] = ESCAPE_STANDARD;
      }
    }

    @Override
    public int[] getEscapeCodesForAscii() {
      return escapes;
    }

    /** None of its own: everything outside ASCII is written as an escape already. */
    @Override
    public SerializableString getEscapeSequence(int character) {
      return null;
    }
  }
}
