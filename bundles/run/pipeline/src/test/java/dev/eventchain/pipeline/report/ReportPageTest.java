package dev.eventchain.pipeline.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyMeasurement;
import dev.eventchain.model.eventchain.LatencyPart;
import dev.eventchain.model.eventchain.Measurement;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.model.eventchain.StatisticKind;
import dev.eventchain.model.eventchain.Statistics;
import dev.eventchain.pipeline.diagram.ChainPicture;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportPageTest {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  /** Texts that could break out, be executed, or act as part of the template. */
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
    ReportPage.Heading heading = heading(sample(sample));
    byte[] first = ReportPage.render(chain("Detection"), heading, sample(sample));

    assertArrayEquals(first, ReportPage.render(chain("Detection"), heading, sample(sample)));
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
  void hostileTitleAndSummaryAreText() {
    String hostile = "</title></noscript><img src=x onerror=\"alert(1)\">&{{data}}[data/]";

    String page =
        text(
            ReportPage.render(
                EventchainFactory.eINSTANCE.createEventChain(),
                new ReportPage.Heading("", hostile, Verdict.INCOMPLETE, hostile),
                MAPPER.createObjectNode()));

    String escaped =
        "&lt;/title&gt;&lt;/noscript&gt;&lt;img src=x"
            + " onerror=&quot;alert(1)&quot;&gt;&amp;{{data}}[data/]";
    assertFalse(page.contains("<img"));
    assertEquals(3, count(page, escaped));
    assertEquals(1, count(page, "</noscript>"));
    assertTrue(page.contains("<div class=\"verdict incomplete\">"));
  }

  @Test
  void hostileModelIsText() {
    for (String hostile : HOSTILE) {
      String page = page(chain(hostile), MAPPER.createObjectNode());

      String harmless = page(chain("x"), MAPPER.createObjectNode());
      assertEquals(tags(harmless), tags(page), hostile);
      assertFalse(page.contains("\u202e") || page.contains("\u0000"), hostile);
    }
  }

  @Test
  void signalThatLeavesTheChainIsMarked() {
    EventChain chain = chain("Detection");
    Requirement asking = FACTORY.createRequirement();
    asking.setId("R-7");
    chain.getRequirements().add(asking);
    Data warning = FACTORY.createData();
    warning.setName("warning");
    warning.setTopicName("/cluster/warning");
    warning.setExternal(true);
    warning.getSatisfies().add(asking);
    chain.getData().add(warning);
    chain.getSoftware().get(0).getOutput().add(warning);

    String page = page(chain, MAPPER.createObjectNode());

    assertTrue(page.contains("<strong>leaves the chain</strong> for R-7</div>"));
    List<String> leaving = new ArrayList<>();
    for (JsonNode box : ChainPicture.of(chain).path("boxes")) {
      if (box.path("external").asBoolean()) {
        leaving.add(box.path("kind").asText() + " " + box.path("name").asText());
      }
    }
    assertEquals(List.of("SIGNAL_OUT /cluster/warning"), leaving);
  }

  /** Without a script, since the data come from the model. */
  @Test
  void longestLatencyIsStackedByNode() {
    EventChain chain = chain("Detection");
    LatencyConstraint bound = FACTORY.createLatencyConstraint();
    bound.setName("quick");
    bound.setFirst(chain.getSoftware().get(0));
    bound.setLast(chain.getSoftware().get(0));
    bound.setMaximum(100);
    chain.getLatencyConstraints().add(bound);
    for (double waiting : new double[] {5, 35, 15}) {
      ChainMeasurement measured = FACTORY.createChainMeasurement();
      measured.setScenario("waits " + waiting);
      measured.getLatencies().add(latency(bound, waiting, 10));
      chain.getMeasured().add(measured);
    }

    String page = page(chain, MAPPER.createObjectNode());

    assertTrue(
        page.contains("at most <strong>45.000 ms</strong> of 100 ms allowed, in <em>waits 35.0"));
    assertTrue(
        page.contains("<rect class=\"waiting\" x=\"0\" y=\"0\" width=\"3500\" height=\"100\"/>"));
    assertTrue(page.contains("<rect class=\"execution\" x=\"3500\" y=\"0\" width=\"1000\""));
    assertTrue(page.contains("Simulated execution time, from the model"));
    assertEquals(1, count(page, "<figure class=\"passage\">"));
    assertFalse(page.contains("too long"));
    bound.setMaximum(20);
    assertTrue(page(chain, MAPPER.createObjectNode()).contains("<strong class=\"bad\">too long"));
  }

  private static LatencyMeasurement latency(
      LatencyConstraint bound, double waiting, double execution) {
    LatencyPart part = FACTORY.createLatencyPart();
    part.setNode(bound.getFirst());
    part.setWaiting(waiting);
    part.setExecution(execution);
    Statistics statistics = FACTORY.createStatistics();
    statistics.setMaximum(waiting + execution);
    LatencyMeasurement latency = FACTORY.createLatencyMeasurement();
    latency.setConstraint(bound);
    latency.setLatency(statistics);
    latency.getSlowest().add(part);
    return latency;
  }

  @Test
  void chainRequirementsAndMeasurementsStandInThePage() {
    String page = page(chain("Detection"), MAPPER.createObjectNode());

    String shown =
        page.replaceAll("<script.*?</script>|<style>.*?</style>", "").replaceAll("<[^>]*>", "");
    assertTrue(shown.contains("Detection: 1 node, 0 of them generated"), shown);
    assertTrue(page.contains("<td class=\"number\">12.5</td><td class=\"number\">0</td>"), page);
    assertTrue(page.contains("<td class=\"number\">1\u202f234</td>"), page);
    assertTrue(page.contains("<td>margin</td><td class=\"number\">\u22121.023</td>"), page);
    assertTrue(page.contains("<td>Detection</td><td class=\"number\">2.50</td>"), page);
    assertTrue(page.contains("<a href=\"#requirement-1\">Detection</a>"), page);
    assertTrue(page.contains("<tr role=\"row\" data-requirement=\"Detection\">"), page);
  }

  @Test
  void eachOfFifteenNodesHasOneRowOfMeasurements() {
    EventChain chain = chain("N");
    while (chain.getSoftware().size() < 15) {
      chain.getSoftware().add(EcoreUtil.copy(chain.getSoftware().get(0)));
    }

    String page = page(chain, MAPPER.createObjectNode());

    assertEquals(15, count(page, "<tr data-node="));
    assertTrue(page.contains("Latency of the chain, in ms"), page);
  }

  @Test
  void viewerWithoutScriptShowsTheVerdict() throws IOException {
    String page = page(sample("failed"));

    String silent = page.substring(0, page.indexOf("<script"));
    assertTrue(silent.contains("<span class=\"status bad\">Failed</span>"), silent);
    assertTrue(silent.contains("hits the stopped vehicle with 50.0 km/h"), silent);
    assertTrue(between(page, "<noscript>", "</noscript>").contains("JavaScript"));
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
  void numbersThatJsonLacksLeaveItReadable() throws IOException {
    ObjectNode data = MAPPER.createObjectNode();
    data.putArray("scenarios").addObject().put("margin", Double.POSITIVE_INFINITY);

    JsonNode read = MAPPER.readTree(dataOf(page(data)));

    assertFalse(read.at("/scenarios/0/margin").isNumber());
  }

  @Test
  void loneSurrogateIsKeptAsAnEscape() {
    String json = dataOf(page(MAPPER.createObjectNode().put("title", "half \ud800.")));

    assertEquals("{\"title\":\"half \\uD800.\"}", json);
  }

  /** Returns a chain whose texts are all the name. */
  private static EventChain chain(String name) {
    EventchainFactory factory = EventchainFactory.eINSTANCE;
    EventChain chain = factory.createEventChain();
    chain.setName(name);
    Requirement requirement = factory.createRequirement();
    requirement.setId(name);
    requirement.setText(name);
    chain.getRequirements().add(requirement);
    SoftwareNode node = factory.createSoftwareNode();
    node.setName(name);
    node.setDescription(name);
    node.getSatisfies().add(requirement);
    Data data = factory.createData();
    data.setName(name);
    data.setTopicName(name);
    data.setMessageType(name);
    data.setFieldName(name + ".x");
    data.setUnit(name);
    node.getInput().add(data);
    chain.getData().add(data);
    chain.getSoftware().add(node);
    ChainMeasurement measured = factory.createChainMeasurement();
    measured.setScenario(name);
    measured.setLatency(factory.createStatistics());
    measured.getLatency().setMinimum(12.46);
    measured.getLatency().setMaximum(1234.4);
    Measurement margin = factory.createMeasurement();
    margin.setName(name);
    margin.setUnit(name);
    margin.setStatistic(StatisticKind.MARGIN);
    margin.setValue(-1.0234);
    margin.setTime(2.5);
    measured.getMeasurements().add(margin);
    chain.getMeasured().add(measured);
    node.setMeasured(factory.createNodeMeasurement());
    node.getMeasured().setPeriod(factory.createStatistics());
    return chain;
  }

  /** Returns the page's markup without its texts and without the data and code of the script. */
  private static String tags(String page) {
    StringBuilder tags = new StringBuilder();
    Matcher tag =
        Pattern.compile("</?[a-z][^>]*>").matcher(page.substring(0, page.indexOf("<script")));
    while (tag.find()) {
      tags.append(tag.group().replaceAll("data-(requirement|scenario|node)=\"[^\"]*\"", ""));
    }
    return tags.toString().replace("<wbr>", "");
  }

  private static JsonNode sample(String name) throws IOException {
    try (InputStream stream = ReportPageTest.class.getResourceAsStream(name + ".json")) {
      return MAPPER.readTree(stream);
    }
  }

  private static String page(JsonNode data) {
    return page(EventchainFactory.eINSTANCE.createEventChain(), data);
  }

  private static String page(EventChain chain, JsonNode data) {
    return text(ReportPage.render(chain, heading(data), data));
  }

  private static String text(byte[] page) {
    return new String(page, StandardCharsets.UTF_8);
  }

  private static ReportPage.Heading heading(JsonNode data) {
    JsonNode project = data.path("project");
    String verdict = project.path("verdict").asText("incomplete").toUpperCase(Locale.ROOT);
    return new ReportPage.Heading(
        project.path("name").asText(),
        project.path("title").asText(),
        Verdict.valueOf(verdict),
        project.path("summary").asText());
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
