package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Tests the JUnit report of a run: a case for each scenario, criterion, requirement and component
 * test, with links to requirements.
 */
class RunTestCasesTest {

  @TempDir Path folder;

  @Test
  void eachScenarioCriterionAndRequirementIsATestWithItsTime() throws Exception {
    ProjectCopy copy = withComponentTests();
    Path file = folder.resolve("TEST-run.xml");
    new Program().run("run", copy.path(), "--report", "junit=" + file).expect(0);
    Document report = read(file);
    Element scenario = testCase(report, "scenarios", "stopped-vehicle-50");
    assertEquals("11.700", scenario.getAttribute("time"), "until nothing more is judged");
    assertTrue(scenario.getTextContent().contains("7 criteria hold"), scenario.getTextContent());
    Element warned = testCase(report, "criteria", "stopped-vehicle-50: the driver is warned");
    assertEquals("11.700", warned.getAttribute("time"));
    assertEquals("25.700", testCase(report, "requirements", "RAD-1").getAttribute("time"));
    assertEquals("RAD-1, RAD-2, RAD-3, RAD-4", property(scenario, "PartiallyVerifies"));
    assertEquals("requirements-based", property(scenario, "TestType"));
    assertTrue(scenario.getAttribute("file").endsWith("scenarios/stopped-vehicle-50.yaml"));
    assertEquals("1", scenario.getAttribute("line"));
    Element test = testCase(report, "component tests", "Brake_Request: not near enough");
    assertEquals("RAD-4", property(test, "lobster-tracing"));
    assertEquals("29", test.getAttribute("line"));
    assertEquals(
        "RAD-2",
        property(testCase(report, "requirements", "RAD-2"), "PartiallyVerifies"),
        "it does not notice all faults");
    assertEquals("", property(warned, "PartiallyVerifies"));
    assertEquals(0, report.getElementsByTagName("failure").getLength());
    byte[] before = Files.readAllBytes(file);
    Path needs = folder.resolve("needs.json");
    Path matrix = folder.resolve("matrix.csv");
    new Program()
        .run("run", copy.path(), "--report", "junit=" + file, "--report", "needs=" + needs)
        .expect(0);
    assertArrayEquals(before, Files.readAllBytes(file), "of results that are not made again, too");
    JsonNode scenarioNeed =
        new ObjectMapper().readTree(needs.toFile()).at("/versions/1/needs/SCENARIO_SHORT_SIGHT");
    assertEquals("passed", scenarioNeed.get("status").asText());
    assertEquals("[\"RAD-1\",\"RAD-3\"]", scenarioNeed.get("links").toString());
    copy.write("scenarios/short-sight.yaml", "broken");
    new Program()
        .run(
            "run",
            copy.path(),
            "--report",
            "matrix=" + matrix,
            "--report",
            "needs=" + needs,
            "--report",
            "lobster=" + file)
        .expect(2)
        .says("report.unwritable");
    assertFalse(Files.readString(matrix).contains("proved"), "a broken project proves nothing");
    assertFalse(Files.readString(needs).contains("passed"), Files.readString(needs));
    assertTrue(Files.readString(needs).contains("not tested: nothing was simulated"), "says why");
  }

  @InTurn
  @Test
  void failuresAreWhereTheyBelong() throws Exception {
    ProjectCopy copy = withComponentTests();
    copy.replace("scenarios/short-sight.yaml", "ego.speed <= 12 km/h", "ego.speed >= 200 km/h");
    copy.replace(
        "scenarios/stopped-vehicle-50.yaml",
        "RAD-4: \"brake while the time to collision is 3 s or more\"",
        "RAD-3: \"brake with 9 m/s²\"");
    copy.replace("scenarios/stopped-vehicle-50.yaml", "ttc < 5 s and", "ttc < 0.01 s and");
    Path file = folder.resolve("TEST-run.xml");
    Path needs = folder.resolve("needs.json");
    new Program()
        .run("run", copy.path(), "--report", "junit=" + file, "--report", "needs=" + needs)
        .expect(1);
    JsonNode all = new ObjectMapper().readTree(needs.toFile()).at("/versions/1/needs");
    assertTrue(
        all.at("/RAD-4/content")
            .asText()
            .contains("not tested: No scenario tests the requirement RAD-4"),
        all.get("RAD-4").toString());
    assertFalse(all.at("/RAD-3/content").asText().contains("not tested"), "it is violated");
    Document report = read(file);
    Element failed =
        testCase(
            report, "criteria", "short-sight: it is not faster than the vehicle ahead for long");
    assertEquals("simulation.criterion.failed", failure(failed).getAttribute("type"));
    assertTrue(failed.getTextContent().contains("scenarios/short-sight.yaml:19"));
    Element untested =
        testCase(
            report,
            "criteria",
            "stopped-vehicle-50: the radar's time to collision is the true one");
    assertEquals("simulation.criterion.untested", failure(untested).getAttribute("type"));
    Element shortSight = testCase(report, "scenarios", "short-sight");
    failure(shortSight);
    assertEquals("RAD-1, RAD-3", property(shortSight, "PartiallyVerifies"));
    Element notTested = testCase(report, "scenarios", "stopped-vehicle-50");
    assertEquals(1, notTested.getElementsByTagName("skipped").getLength());
    assertEquals("notrun", notTested.getAttribute("status"));
    assertEquals("RAD-1", property(notTested, "PartiallyVerifies"), "what it could not judge");
    assertEquals(
        "",
        property(testCase(report, "component tests", "Radar_Tracking: no vehicle"), "TestType"),
        "passed, but its requirement is not proved");
    assertEquals(
        "violated", failure(testCase(report, "requirements", "RAD-3")).getAttribute("message"));
    assertEquals(
        "project.requirement.untested",
        failure(testCase(report, "requirements", "RAD-4")).getAttribute("type"));
    assertFalse(Files.readString(file).contains("other findings"), Files.readString(file));
  }

  private ProjectCopy withComponentTests() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    Projects.copy(Program.ROOT.resolve("examples/radar-aeb/tests"), copy.path().resolve("tests"));
    return copy;
  }

  private static Element failure(Element testCase) {
    NodeList failures = testCase.getElementsByTagName("failure");
    assertEquals(1, failures.getLength(), testCase.getAttribute("name"));
    return (Element) failures.item(0);
  }

  private static String property(Element testCase, String name) {
    NodeList all = testCase.getElementsByTagName("property");
    for (int i = 0; i < all.getLength(); i++) {
      Element each = (Element) all.item(i);
      if (each.getAttribute("name").equals(name)) {
        return each.getAttribute("value");
      }
    }
    return "";
  }

  private static Element testCase(Document report, String suite, String name) {
    NodeList all = report.getElementsByTagName("testcase");
    for (int i = 0; i < all.getLength(); i++) {
      Element each = (Element) all.item(i);
      Element parent = (Element) each.getParentNode();
      if (parent.getAttribute("name").equals(suite) && each.getAttribute("name").startsWith(name)) {
        return each;
      }
    }
    throw new AssertionError("no case " + suite + " " + name);
  }

  private static Document read(Path file) throws Exception {
    return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile());
  }
}
