package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what a browser makes of the report of a failed run; skipped where there is no Chromium. */
class ReportInBrowserTest {

  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** Scenarios, in most of which the vehicle has to brake. */
  private static final List<String> SCENARIOS =
      List.of(
          "braking-vehicle",
          "cut-in",
          "cut-out",
          "next-lane",
          "pedestrian",
          "slower-vehicle",
          "stopped-vehicle-50",
          "stopped-vehicle-80");

  private static final int MOST_PIXELS = 4_000;
  private static final int WIDTH = 1_400;

  @TempDir Path folder;

  @Test
  void reportOfAFailedRunIsShortAndComplete() throws Exception {
    Optional<String> browser =
        Stream.of("chromium", "chromium-browser", "google-chrome")
            .filter(ReportInBrowserTest::isThere)
            .findFirst();
    assumeTrue(browser.isPresent(), "there is no Chromium");
    Path page = reportOfVehicleThatDoesNotBrake();
    Path proved = withStrength(page);
    String drawn = dom(browser.get(), proved);
    assertEquals(Set.of(), missing(proved, text(drawn)));
    assertEquals(List.of(), axesWithoutScale(drawn));
    String spoken =
        "Storyboard: target brakes: 1.00\u00a0s to 2.50\u00a0s; the storyboard ends: 2.75\u00a0s";
    assertTrue(drawn.replace("&nbsp;", "\u00a0").contains("aria-label=\"" + spoken + "\""));
    String shown = text(drawn).replace('\u00a0', ' ').replaceAll("\\s+", " ");
    assertTrue(
        shown.contains("Compared with the bound of 50 %: 3 of 8 faults of Brake, a sample of 20."),
        shown);
    assertTrue(shown.contains("No fault of Gap counts for the bound of 2.5 %."), shown);
    int height = height(browser.get(), page);
    assertTrue(height > 1_000 && height < MOST_PIXELS, height + " pixels");
  }

  /** Returns the plots whose axis has fewer than two labels. */
  private static List<String> axesWithoutScale(String drawn) {
    List<String> plots =
        Stream.of(drawn.split("<g role=\"img\"", -1))
            .skip(1)
            .map(plot -> plot.substring(0, plot.indexOf("</g>")))
            .toList();
    assertTrue(plots.size() > 5, "only " + plots.size() + " plots");
    return plots.stream().filter(plot -> plot.split("class=\"tick\"", -1).length < 3).toList();
  }

  private Path reportOfVehicleThatDoesNotBrake() throws IOException {
    Path project = Program.wholeExampleIn(folder);
    try (Stream<Path> files = Files.list(project.resolve("scenarios"))) {
      for (Path file : files.toList()) {
        if (!SCENARIOS.contains(file.getFileName().toString().replace(".yaml", ""))) {
          Files.delete(file);
        }
      }
    }
    new ProjectCopy(project)
        .replace(
            "software-base/components/Carla_Vehicle_Control.py",
            "max(0.0, min(1.0, float(braking_force)))",
            "0.1 * max(0.0, min(1.0, float(braking_force)))");
    new Program().run("run", project).expect(1).says("FAILED: 2 of 8 scenarios passed");
    return withStoryboard(project.resolve("out/report.html"));
  }

  /** Returns a page with what counts for the bounds on the strength of two requirements. */
  private static Path withStrength(Path page) throws IOException {
    String text = Files.readString(page);
    for (String bound :
        List.of(
            "{\"minimumPercent\":50.0,\"components\":[\"Brake\"],\"noticed\":3,\"faults\":8,\"sampleOf\":20}",
            "{\"minimumPercent\":2.5,\"components\":[\"Gap\"],\"noticed\":0,\"faults\":0}")) {
      String strength = "\"strength\":{\"noticed\":4,\"faults\":9,\"bound\":" + bound;
      text =
          text.replaceFirst(
              "(?<=\\],)(?=\"proved\":)",
              Matcher.quoteReplacement(strength + ",\"unnoticed\":[]},"));
    }
    return Files.writeString(page.resolveSibling("proved.html"), text);
  }

  /**
   * Adds to the data of each scenario what a storyboard would let happen, and a name for a value
   * that no signal has.
   */
  private static Path withStoryboard(Path page) throws IOException {
    String happened =
        "\"happened\":[{\"name\":\"target brakes\",\"kind\":\"event\",\"start\":1,\"end\":2.5},"
            + "{\"name\":\"the storyboard ends\",\"kind\":\"end\",\"start\":2.75}],\"series\":";
    String text = Files.readString(page);
    assertTrue(text.contains("\"series\":"));
    String named = "\"names\":[{\"value\":655.35,\"name\":\"not available\"}],\"values\":";
    return Files.writeString(
        page, text.replace("\"series\":", happened).replace("\"values\":", named));
  }

  /** Returns what the data of the page say and the page does not. */
  private static Set<String> missing(Path page, String shown) throws IOException {
    Matcher embedded =
        Pattern.compile("(?s)<script[^>]*id=\"data\"[^>]*>(.*?)</script>")
            .matcher(Files.readString(page));
    assertTrue(embedded.find());
    JsonNode data = MAPPER.readTree(embedded.group(1));
    List<String> said = new ArrayList<>();
    for (JsonNode scenario : data.path("scenarios")) {
      said.add(scenario.path("title").asText());
      for (JsonNode criterion : scenario.path("criteria")) {
        said.add(criterion.path("text").asText());
        said.add(criterion.path("measured").asText());
      }
      scenario.path("happened").forEach(each -> said.add(each.path("name").asText()));
      for (JsonNode signal : scenario.path("series").path("signals")) {
        said.add(signal.path("name").asText());
      }
    }
    data.path("diagnostics").forEach(each -> said.add(each.path("message").asText()));
    for (JsonNode requirement : data.path("requirements")) {
      said.add(requirement.path("text").asText());
      requirement.path("generated").forEach(each -> said.add(each.path("file").asText()));
    }
    data.path("nodes").forEach(each -> said.add(each.path("name").asText()));
    for (JsonNode signal : data.path("signals")) {
      said.add(signal.path("name").asText());
      said.add(signal.path("shown").asText());
      signal.path("unshown").forEach(each -> said.add(each.asText()));
    }
    data.path("hops").forEach(each -> said.add(each.path("topic").asText()));
    data.path("stages").forEach(each -> said.add(each.path("details").asText()));
    assertTrue(said.size() > 100, said::toString);
    Set<String> missing = new LinkedHashSet<>();
    for (String each : said) {
      if (!shown.contains(each.replaceAll("\\s+", " ").strip())) {
        missing.add(each);
      }
    }
    return missing;
  }

  private String dom(String browser, Path page) throws Exception {
    return ended(browser, "--window-size=" + WIDTH + ",900", page.toUri().toString());
  }

  /** Returns the height of the page, which a page around it measures. */
  private int height(String browser, Path page) throws Exception {
    Path around = folder.resolve("around.html");
    Files.writeString(
        around,
        String.format(
            Locale.ROOT,
            """
        <script>
          onload = () => {
            const page = document.createElement("iframe");
            page.style = "width: %dpx; height: 900px; border: 0";
            page.src = "%s";
            page.onload = () => setTimeout(() => {
              document.title = "height " + page.contentDocument.documentElement.scrollHeight;
            }, 500);
            document.body.append(page);
          };
        </script>
        """,
            WIDTH,
            page.toUri()));
    Matcher height =
        Pattern.compile("<title>height (\\d+)</title>")
            .matcher(ended(browser, "--window-size=1500,1000", around.toUri().toString()));
    assertTrue(height.find(), "the page was not measured");
    return Integer.parseInt(height.group(1));
  }

  private static String text(String dom) {
    return dom.replaceAll("(?s)<(script|style|noscript).*?</\\1>", "")
        .replaceAll("<[^>]*>", "")
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&nbsp;", "\u00a0")
        .replace("&amp;", "&")
        .replaceAll("\\s+", " ");
  }

  private String ended(String browser, String size, String address) throws Exception {
    Path dom = folder.resolve("dom.html");
    Process process =
        new ProcessBuilder(
                browser,
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--allow-file-access-from-files",
                "--user-data-dir=" + folder.resolve("browser"),
                "--virtual-time-budget=10000",
                size,
                "--dump-dom",
                address)
            .redirectOutput(dom.toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      assertTrue(process.waitFor(5, TimeUnit.MINUTES), "the browser does not end");
      return Files.readString(dom);
    } finally {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
  }

  private static boolean isThere(String command) {
    try {
      Process process =
          new ProcessBuilder(command, "--version")
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      return process.waitFor() == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
