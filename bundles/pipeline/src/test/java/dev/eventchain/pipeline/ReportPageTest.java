package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportPageTest {

  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  /** Text that would leave its place, run, or be taken for a part of the template. */
  private static final List<String> HOSTILE =
      List.of(
          "</script><script>alert(1)</script>",
          "<!--<script>",
          "]]>&lt;&quot;\"'`\\",
          "line\u2028paragraph\u2029end",
          "{{script}} $1 \\1 {{unknown}}",
          "a pair of surrogates \ud83d\ude97",
          "\u0000\u001b\u202e");

  @ParameterizedTest
  @ValueSource(strings = {"passed", "failed", "incomplete"})
  void dataComesOutOfThePageAsItWentIn(String sample) throws IOException {
    JsonNode data = sample(sample);

    assertEquals(data, MAPPER.readTree(dataOf(page(data))));
  }

  @ParameterizedTest
  @ValueSource(strings = {"passed", "failed", "incomplete"})
  void sameDataGivesSameBytes(String sample) throws IOException {
    byte[] first = ReportPage.render(sample(sample));

    assertArrayEquals(first, ReportPage.render(sample(sample)));
    assertFalse(new String(first, StandardCharsets.UTF_8).contains("\r"));
  }

  @Test
  void hostileTextStaysInsideTheData() throws IOException {
    for (String hostile : HOSTILE) {
      ObjectNode data = MAPPER.createObjectNode();
      data.putArray("diagnostics").addObject().put("message", hostile).put(hostile, "as a name");

      String page = page(data);

      String json = dataOf(page);
      assertTrue(Pattern.matches("[\\x20-\\x7e&&[^<>&]]*", json), json);
      assertEquals(data, MAPPER.readTree(json));
      assertEquals(2, count(page, "<script"), hostile);
      assertEquals(page(MAPPER.createObjectNode()), page.replace(json, "{}"));
    }
  }

  @Test
  void hostileTitleVerdictAndSummaryAreTextWhereNoScriptRuns() {
    ObjectNode data = MAPPER.createObjectNode();
    String hostile = "</title></noscript><img src=x onerror=\"alert(1)\">&{{data}}";
    data.putObject("project").put("title", hostile).put("verdict", hostile).put("summary", hostile);

    String page = page(data);

    String escaped =
        "&lt;/title&gt;&lt;/noscript&gt;&lt;img src=x onerror=&quot;alert(1)&quot;&gt;&amp;{{data}}";
    assertFalse(page.contains("<img"));
    assertEquals(4, count(page, escaped));
    assertEquals(1, count(page, "</noscript>"));
  }

  @Test
  void viewerWithoutScriptShowsTheVerdict() throws IOException {
    String page = page(sample("failed"));

    String silent = between(page, "<noscript>", "</noscript>");
    assertTrue(silent.contains("<strong>failed</strong>"), silent);
    assertTrue(silent.contains("hits the stopped vehicle with 50.0 km/h"), silent);
  }

  @Test
  void policyAllowsExactlyThisStyleAndThisScript() throws Exception {
    String page = page(sample("passed"));

    String policy = between(page, "Content-Security-Policy\" content=\"", "\">");
    String style = between(page, "<style>", "</style>");
    String script = between(page, "<script>", "</script>");
    assertEquals(
        "default-src 'none'; style-src '%s'; script-src '%s'; base-uri 'none'; form-action 'none'"
            .formatted(hash(style), hash(script)),
        policy);
  }

  @Test
  void scriptMakesNoMarkupOfTextAndLoadsNothing() throws IOException {
    String page = page(MAPPER.createObjectNode());

    String script = between(page, "<script>", "</script>");
    Matcher risky =
        Pattern.compile(
                "innerHTML|outerHTML|insertAdjacentHTML|document\\.write|DOMParser|srcdoc|\\beval\\b"
                    + "|Function\\(|fetch\\(|XMLHttpRequest|WebSocket|import\\(")
            .matcher(script);
    assertFalse(risky.find(), () -> risky.group());
    assertEquals(1, count(page, "://"), "only the name of the SVG namespace");
    assertFalse(between(page, "<style>", "</style>").matches("(?s).*(url\\(|@import).*"));
  }

  @Test
  void everyPlaceOfTheTemplateIsFilled() throws IOException {
    assertFalse(page(sample("passed")).contains("{{"));
  }

  @Test
  void numbersThatJsonLacksLeaveItReadable() throws IOException {
    ObjectNode data = MAPPER.createObjectNode();
    data.putArray("scenarios").addObject().put("minimalGap", Double.POSITIVE_INFINITY);

    JsonNode read = MAPPER.readTree(dataOf(page(data)));

    assertFalse(read.at("/scenarios/0/minimalGap").isNumber());
  }

  @Test
  void loneSurrogateIsKeptAsAnEscape() {
    String json = dataOf(page(MAPPER.createObjectNode().put("title", "half \ud800.")));

    assertEquals("{\"title\":\"half \\uD800.\"}", json);
  }

  private static JsonNode sample(String name) throws IOException {
    try (InputStream stream =
        ReportPageTest.class.getResourceAsStream("report/" + name + ".json")) {
      return MAPPER.readTree(stream);
    }
  }

  private static String page(JsonNode data) {
    return new String(ReportPage.render(data), StandardCharsets.UTF_8);
  }

  private static String dataOf(String page) {
    return between(page, "<script type=\"application/json\" id=\"data\">", "</script>");
  }

  private static String between(String text, String start, String end) {
    int from = text.indexOf(start) + start.length();
    return text.substring(from, text.indexOf(end, from));
  }

  private static int count(String text, String part) {
    return text.split(Pattern.quote(part), -1).length - 1;
  }

  private static String hash(String text) throws Exception {
    byte[] digest =
        MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
    return "sha256-" + Base64.getEncoder().encodeToString(digest);
  }
}
