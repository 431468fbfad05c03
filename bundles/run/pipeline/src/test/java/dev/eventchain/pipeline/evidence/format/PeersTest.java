package dev.eventchain.pipeline.evidence.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.RequirementTools;
import dev.eventchain.fixtures.RequirementTools.Ended;
import dev.eventchain.pipeline.evidence.Evidence;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Lets the programs for which reports are written read them. */
class PeersTest {

  private static final String CONF =
      """
      project = "brakes"
      extensions = ["sphinx_needs", "sphinx_test_reports"]
      needs_id_regex = "^[A-Za-z0-9_.-]+$"
      needs_links = {
          "fully_verifies": {"incoming": "is fully verified by", "outgoing": "fully verifies"},
          "partially_verifies": {"incoming": "is partially verified by", "outgoing": "partially verifies"},
      }
      tr_property_link_types = {"FullyVerifies": "fully_verifies", "PartiallyVerifies": "partially_verifies"}
      needs_build_json = True
      exclude_patterns = ["html"]
      """;

  private static final String INDEX =
      """
      Brakes
      ======

      .. needimport:: needs.json

      .. test-file:: Evidence
         :file: brakes.lit.junit.xml
         :id: EVIDENCE
         :auto_suites:
         :auto_cases:

      .. test-file:: Run
         :file: run.xml
         :id: RUN_OF_ALL
         :auto_suites:
         :auto_cases:
      """;

  private static final String STRICTDOC =
      """
      from strictdoc.core.project_config import ProjectConfig


      def create_config() -> ProjectConfig:
          return ProjectConfig(
              project_title="Brakes",
              project_features=["REQUIREMENT_TO_SOURCE_TRACEABILITY"],
              include_doc_paths=["/docs/**", "/reports/**"],
              include_source_paths=["/scenarios/**", "/tests/**"],
              test_report_root_dict={"reports/brakes.lit.junit.xml": ""},
          )
      """;

  private static final String SDOC =
      """
      [DOCUMENT]
      TITLE: Brakes

      [REQUIREMENT]
      UID: BRK-1
      STATEMENT: It brakes.
      RELATIONS:
      - TYPE: File
        VALUE: scenarios/stopped.yaml
      """;

  @TempDir private static Path folder;

  private static RequirementTools tools;

  @BeforeAll
  static void writeReports() throws Exception {
    tools = RequirementTools.install(Path.of("src/test/python/requirements-peers.txt"));
    write(EvidenceFormat.EVIDENCE, "reports/brakes.lit.junit.xml");
    write(EvidenceFormat.EVIDENCE, "sphinx/brakes.lit.junit.xml");
    write(EvidenceFormat.NEEDS, "sphinx/needs.json");
    write(EvidenceFormat.LOBSTER, "lobster");
    write(EvidenceFormat.REQIF, "new.reqif");
    Evidence full = Evidences.full();
    for (Evidence.Test test : full.tests()) {
      file(test.place().file(), "name: x\n");
    }
    file("sphinx/run.xml", DiagnosticFormat.JUNIT.render(run()));
    file("sphinx/conf.py", CONF);
    file("sphinx/index.rst", INDEX);
    file("strictdoc_config.py", STRICTDOC);
    file("docs/brakes.sdoc", SDOC);
  }

  /** Returns a run that fully verified a requirement, and could not judge a scenario. */
  private static Report run() {
    return new Report(
        "1",
        1,
        Coverage.NONE,
        List.of(),
        List.of(),
        List.of(
            trial(Trial.Kind.REQUIREMENT, Trial.Outcome.PASSED, List.of("BRK-1"), List.of()),
            trial(Trial.Kind.SCENARIO, Trial.Outcome.UNTESTED, List.of(), List.of("BRK-4")),
            new Trial(
                Trial.Kind.CRITERION, "c", Trial.Outcome.FAILED, "not tested", 1, List.of())));
  }

  private static Trial trial(
      Trial.Kind kind, Trial.Outcome outcome, List<String> fully, List<String> partially) {
    Trial.Evidence evidence =
        new Trial.Evidence(SourceLocation.of("requirements.md"), fully, partially);
    return new Trial(kind, "of " + kind, outcome, "text", 1, List.of(), Optional.of(evidence));
  }

  private static void write(EvidenceFormat format, String name) throws IOException {
    Path target = folder.resolve(name);
    for (Map.Entry<String, byte[]> file : format.render(Evidences.full(), target).entrySet()) {
      Path path = target.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.write(path, file.getValue());
    }
  }

  private static void file(String name, String content) throws IOException {
    Path path = folder.resolve(name);
    Files.createDirectories(path.getParent());
    Files.writeString(path, content);
  }

  private static JsonNode json(String name) throws IOException {
    return new ObjectMapper().readTree(folder.resolve(name).toFile());
  }

  private static String passes(Path in, String program, Object... arguments) throws Exception {
    Ended ended = tools.run(in, program, arguments);
    assertEquals(0, ended.code(), ended.output());
    return ended.output();
  }

  @Test
  void sphinxBuildsWithoutAWarning() throws Exception {
    Path sphinx = folder.resolve("sphinx");
    passes(sphinx, "sphinx-build", "-W", "--keep-going", "-q", "-b", "html", ".", "html");
    JsonNode all = json("sphinx/html/needs.json").get("versions");
    JsonNode needs = all.iterator().next().get("needs");
    assertEquals("not tested", needs.at("/BRK-4/status").asText());
    String html = Files.readString(sphinx.resolve("html/index.html"));
    assertTrue(html.contains("not tested: scenario fog: *it* &lt;warns&gt;"), "says why");
    assertTrue(html.contains("not tested: No scenario tests the requirement BRK_5"), "says why");
    assertEquals("passed", needs.at("/SCENARIO_STOPPED/status").asText());
    assertEquals("[\"BRK-1\",\"BRK-2\"]", needs.at("/SCENARIO_STOPPED/links").toString());
    assertEquals("not tested", needs.at("/SCENARIO_FOG/status").asText());
    Map<String, String> cases = new TreeMap<>();
    for (JsonNode need : needs) {
      if (need.path("type").asText().equals("testcase")) {
        cases.put(
            need.path("title").asText(),
            need.path("result").asText()
                + " "
                + need.path("fully_verifies")
                + need.path("partially_verifies"));
      }
    }
    assertEquals(
        Map.of(
            "Brake.yaml", "failed [][\"BRK-3\"]",
            "Warning.yaml", "skipped [][\"BRK-4\"]",
            "stopped.yaml", "passed [][\"BRK-1\",\"BRK-2\"]",
            "late.yaml", "failed [][\"BRK-3\"]",
            "fog.yaml", "skipped [][\"BRK-4\"]",
            "of REQUIREMENT", "passed [\"BRK-1\"][]",
            "of SCENARIO", "skipped [][\"BRK-4\"]",
            "c", "failed [][]"),
        cases);
  }

  @Test
  void strictDocReadsEachFileAndItsResult() throws Exception {
    passes(folder, "strictdoc", "export", ".", "--formats", "json", "--output-dir", "strictdoc");
    Map<String, String> results = new TreeMap<>();
    json("strictdoc/json/index.json")
        .findParents("TEST_PATH")
        .forEach(each -> results.put(each.get("TEST_PATH").asText(), each.get("STATUS").asText()));
    assertEquals(
        Map.of(
            "tests/Brake.yaml", "FAILED",
            "tests/Warning.yaml", "SKIPPED",
            "scenarios/stopped.yaml", "PASSED",
            "scenarios/late.yaml", "FAILED",
            "scenarios/fog.yaml", "SKIPPED"),
        results);
  }

  @Test
  void lobsterCountsOnlyWhatHolds() throws Exception {
    Path lobster = folder.resolve("lobster");
    passes(lobster, "lobster-report", "--out", "../report.lobster");
    assertEquals(1, tools.run(folder, "lobster-ci-report", "report.lobster").code());
    passes(folder, "lobster-html-report", "--out", "report.html", "report.lobster");
    String html = Files.readString(folder.resolve("report.html"));
    assertTrue(html.contains("not tested: No scenario tests the requirement BRK_5"), "says why");
    assertTrue(html.contains("not tested: It did not run."), "says why");
    Map<String, String> found = new TreeMap<>();
    for (JsonNode level : json("report.lobster").get("levels")) {
      for (JsonNode item : level.get("items")) {
        found.put(item.get("tag").asText(), item.get("tracing_status").asText());
      }
    }
    assertEquals(
        new TreeMap<>(
            Map.ofEntries(
                Map.entry("req BRK-1", "OK"),
                Map.entry("req BRK-2", "OK"),
                Map.entry("req BRK-3", "MISSING"),
                Map.entry("req BRK-4", "MISSING"),
                Map.entry("req BRK_5", "MISSING"),
                Map.entry("component Brake", "OK"),
                Map.entry("component Warning", "OK"),
                Map.entry("test Brake: near enough", "OK"),
                Map.entry("test Brake: far _ 3 m", "MISSING"),
                Map.entry("test Warning: lamp", "MISSING"),
                Map.entry("scenario stopped", "OK"),
                Map.entry("scenario late", "MISSING"),
                Map.entry("scenario fog", "MISSING"))),
        found);
  }

  @Test
  void lobsterReadsTheTestsOfTheOthers() throws Exception {
    Path report = folder.resolve("reports/brakes.lit.junit.xml");
    passes(folder, "lobster-gtest", "--out", "gtest.lobster", report);
    Map<String, String> found = new TreeMap<>();
    json("gtest.lobster")
        .get("data")
        .forEach(
            each ->
                found.put(
                    each.get("name").asText(), each.get("status").asText() + each.get("refs")));
    assertEquals(
        Map.of(
            "component-tests:Brake.yaml", "fail[\"req BRK-3\"]",
            "component-tests:Warning.yaml", "not run[\"req BRK-4\"]",
            "scenarios:stopped.yaml", "ok[\"req BRK-1\",\"req BRK-2\"]",
            "scenarios:late.yaml", "fail[\"req BRK-3\"]",
            "scenarios:fog.yaml", "not run[\"req BRK-4\"]"),
        found);
  }

  @Test
  void reqifIsValidAndSurvivesARoundTrip() throws Exception {
    Path copy =
        Path.of("src/test/resources/dev/eventchain/pipeline/evidence/format/reqif/copy.reqif");
    for (Path file : List.of(folder.resolve("new.reqif"), copy.toAbsolutePath())) {
      String said = passes(folder, "reqif", "validate", "--use-reqif-schema", file);
      assertTrue(said.contains("0 errors, 0 schema issues found, 0 semantic issues"), said);
    }
    passes(folder, "reqif", "passthrough", "new.reqif", "passed.reqif");
    assertEquals(
        Files.readString(folder.resolve("new.reqif")),
        Files.readString(folder.resolve("passed.reqif")).replace("<warn>", "&lt;warn&gt;"),
        "apart from titles, which it does not escape");
  }

  @InTurn
  @Test
  void strictDocConvertsReqif() throws Exception {
    passes(folder, "strictdoc", "convert", "--output-format", "sdoc", "new.reqif", "converted");
    String sdoc;
    try (var files = Files.walk(folder.resolve("converted"))) {
      sdoc =
          Files.readString(
              files.filter(each -> each.toString().endsWith(".sdoc")).findFirst().orElseThrow());
    }
    assertTrue(sdoc.contains("UID: BRK-4"), sdoc);
    assertTrue(sdoc.contains("not tested"), sdoc);
  }
}
