package dev.eventchain.documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.WorldReference;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the site's links resolve and that its reference pages match the program. */
class SiteBuilderTest {

  private static final Pattern LINK = Pattern.compile("(?:href|src)=\"([^\"]*)\"");
  private static final Pattern ANCHOR = Pattern.compile(" id=\"([^\"]*)\"");

  private static Map<String, String> files;

  @BeforeAll
  static void build() throws IOException {
    files = new SiteBuilder(Path.of("../..")).files();
  }

  @Test
  void everyLinkLeadsSomewhere() {
    Map<String, Set<String>> anchors = new HashMap<>();
    files.forEach((name, text) -> anchors.put(name, allOf(ANCHOR, text)));
    List<String> broken = new ArrayList<>();
    int links = 0;
    for (Map.Entry<String, String> file : files.entrySet()) {
      for (String link : allOf(LINK, file.getValue())) {
        links++;
        if (!leadsSomewhere(file.getKey(), link, anchors)) {
          broken.add(file.getKey() + ": " + link);
        }
      }
    }
    assertEquals(List.of(), broken);
    assertTrue(links > 1000, links + " links");
  }

  private static boolean leadsSomewhere(
      String from, String link, Map<String, Set<String>> anchors) {
    int hash = link.indexOf('#');
    String path = hash < 0 ? link : link.substring(0, hash);
    Path here = Path.of(from);
    String target =
        path.isEmpty() ? from : here.resolveSibling(path).normalize().toString().replace('\\', '/');
    if (target.startsWith(SiteBuilder.API + "/")) {
      return true; // SiteTest in tests/architecture checks it once there is Javadoc
    }
    return anchors.containsKey(target)
        && (hash < 0 || anchors.get(target).contains(link.substring(hash + 1)));
  }

  private static Set<String> allOf(Pattern pattern, String text) {
    Set<String> found = new HashSet<>();
    Matcher matcher = pattern.matcher(text);
    while (matcher.find()) {
      found.add(matcher.group(1));
    }
    return found;
  }

  @Test
  void commandsCanBeCopiedWithoutPromptsAndWhatIsPrinted() {
    String text =
        "# Page\n```console exit=1\n$ a <<'END'\n> b\n>\n> END\nprinted\n```\n```\n$ c\n```\n";
    String page = PageTemplate.page("page", text, List.of());
    String block =
        """
        <pre><code><span class="prompt">$ </span>a &lt;&lt;'END'
        <span class="prompt">&gt; </span>b
        <span class="prompt">&gt;</span>
        <span class="prompt">&gt; </span>END
        <span class="printed">printed
        </span></code></pre>
        <pre><code>$ c
        </code></pre>
        """;
    assertTrue(page.contains(block), page);
  }

  @Test
  void pagesThatAreNoLongerThereAreDeletedAndJavadocIsKept(@TempDir Path site) throws IOException {
    Path javadoc = Files.createDirectories(site.resolve(SiteBuilder.API)).resolve("A.html");
    Files.writeString(javadoc, "Javadoc");
    SiteBuilder.write(Map.of("index.html", "1", "rules/old.html", "1"), site);
    SiteBuilder.write(Map.of("index.html", "2"), site);
    assertEquals("2", Files.readString(site.resolve("index.html")));
    assertTrue(Files.notExists(site.resolve("rules/old.html")));
    assertTrue(Files.exists(javadoc));
  }

  @Test
  void everyPageOfTheNavigationIsThere() {
    Set<String> links = allOf(LINK, files.get("index.html"));
    links.removeIf(link -> link.contains("#"));
    assertTrue(files.keySet().containsAll(links), links::toString);
    assertTrue(files.size() > 300, files.size() + " files");
  }

  @Test
  void everyPageThatPeopleWroteIsInTheSite() throws IOException {
    try (Stream<Path> pages = Files.list(Path.of("../..", SiteBuilder.PAGES))) {
      List<String> names = pages.map(page -> page.getFileName().toString()).sorted().toList();
      assertTrue(names.size() >= 8, names::toString);
      for (String name : names) {
        assertTrue(files.containsKey(name.replace(".md", ".html")), name);
      }
    }
  }

  @Test
  void thePageOfCommandsHasTheHelpOfEach() {
    String page = files.get("commands.html");
    for (String text : List.of("Usage:", "--time-limit=SECONDS", "id=\"explain\"", "Exit codes")) {
      assertTrue(page.contains(text), text);
    }
  }

  @Test
  void everythingThatBenchesScenariosAndFaultsMaySayIsDescribed() throws IOException {
    String page = files.get("scenarios.html");
    Set<String> names = new HashSet<>();
    for (String schema : List.of(Bench.schema(), Scenario.schema(), FaultPlan.schema())) {
      collectNames(new ObjectMapper().readTree(schema), names);
    }
    WorldReference.quantities().forEach(each -> names.add(each.name()));
    WorldReference.actuators().forEach(each -> names.add(each.name()));
    assertTrue(names.size() > 100, names::toString);
    names.removeIf(
        name -> Pattern.compile("[>.]" + Pattern.quote(name) + "[<.\\[]").matcher(page).find());
    assertEquals(Set.of(), names);
    for (WorldReference.OperatorEntry each : WorldReference.operators()) {
      assertTrue(
          page.contains(each.example().replace(">", "&gt;").replace("<", "&lt;")), each.example());
    }
  }

  /** Collects the names of all properties and the values of all enumerations. */
  private static void collectNames(JsonNode node, Set<String> names) {
    node.path("properties").fieldNames().forEachRemaining(names::add);
    node.path("enum").forEach(value -> names.add(value.asText()));
    node.forEach(each -> collectNames(each, names));
  }

  @Test
  void javaIsThatOfTheTests() {
    String page = files.get("java.html");
    assertTrue(page.contains("OclValidator.validate(rules"), page);
    assertTrue(!page.contains("<!-- java") && !page.contains("&lt;!-- java"), page);
  }
}
