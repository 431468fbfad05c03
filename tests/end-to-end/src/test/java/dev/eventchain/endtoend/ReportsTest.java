package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the output for build servers: reports of every outcome, suppressions, and pages about
 * findings.
 */
class ReportsTest {

  private static final String FAST = "context SoftwareNode inv Fast: self.frequency >= 30.0\n";
  private static final String SUPPRESSED =
      """
      - id: ocl.violated
        rule: SoftwareNode::Fast
        reason: The new sensors come in spring.
        expires: 2027-03-31
      """;

  @TempDir static Path once;
  @TempDir Path folder;

  private static Path project;

  @BeforeAll
  static void makeTheModel() throws IOException {
    project = Program.exampleIn(once);
    new Program().run("run", project, "--to", "constrain").expect(0);
  }

  @Test
  void theExampleGivesBothReportsOfAPass() throws IOException {
    Path sarif = folder.resolve("deep/er/a.sarif");
    Path junit = folder.resolve("b.xml");
    new Program()
        .run("validate", project, "--report", "sarif=" + sarif, "--report", "junit=" + junit)
        .expect(0)
        .says("0 errors, 0 warnings in 2 files: 75 elements")
        .says(" message contracts, ")
        .says(" metamodel checks; ");
    JsonNode run = json(Files.readString(sarif)).at("/runs/0");
    assertEquals(0, run.get("results").size());
    assertEquals(true, run.at("/invocations/0/executionSuccessful").asBoolean());
    JsonNode rules = run.at("/tool/driver/rules");
    assertTrue(rules.size() >= 16, rules.toString());
    assertTrue(rules.at("/0/help/markdown").asText().contains("# ocl.violated"), "the rule's page");
    String xml = Files.readString(junit);
    assertTrue(xml.contains("name=\"SoftwareNode::NodeNameIsIdentifier\" time=\"0\"/>"), xml);
    assertTrue(xml.contains("failures=\"0\""), xml);
  }

  @Test
  void equalInputsGiveEqualReports() throws IOException {
    for (String format : List.of("text", "json", "sarif", "junit")) {
      Path one = folder.resolve("one." + format);
      Path two = folder.resolve("two." + format);
      for (Path file : List.of(one, two)) {
        new Program().run("validate", project, "--report", format + "=" + file).expect(0);
      }
      assertEquals(Files.readString(one), Files.readString(two));
    }
  }

  @Test
  void aCommandThatFailsEarlyReportsItsFailure() throws IOException {
    Path report = folder.resolve("a.json");
    Path fresh = Program.exampleIn(folder);
    Path broken = Files.writeString(folder.resolve("broken.xmi"), "<a");
    Object[][] failures = {
      {"validate", folder.resolve("nowhere"), "project.missing"},
      {"generate", fresh, "project.stage.missing"},
      {"validate", broken, "xmi.syntax"},
    };
    for (Object[] failure : failures) {
      Files.deleteIfExists(report);
      Program.Ended ended =
          new Program()
              .run(failure[0], failure[1], "--format", "json", "--report", "json=" + report);
      ended.expect(2);
      assertEquals(ended.out(), Files.readString(report));
      JsonNode json = json(ended.out());
      assertEquals(2, json.get("exitCode").asInt());
      assertEquals(failure[2], json.at("/findings/0/id").asText());
    }
  }

  @Test
  void aProjectWithoutAModelGetsOneBeforeItIsValidated() throws IOException {
    Path fresh = Program.exampleIn(folder.resolve("new"));
    new Program().run("validate", fresh).expect(0).says("constraints");
    assertTrue(Files.isRegularFile(fresh.resolve("out/chain.xmi")));
  }

  @Test
  void aModelThatPeopleEditIsHeldToTheDesignRulesInAFreshCheckoutToo() throws IOException {
    Path fresh = Program.exampleIn(folder.resolve("edited"));
    Files.createDirectories(fresh.resolve("model"));
    Files.copy(project.resolve("out/chain.xmi"), fresh.resolve("model/chain.xmi"));
    new Program()
        .run("validate", fresh)
        .expect(1)
        .says("No constraint implements the design rule DR-3.")
        .says("eventchain run " + fresh + " --to constrain'");
    assertFalse(Files.exists(fresh.resolve("out")));
    new Program().run("run", fresh, "--to", "constrain").expect(0);
    new Program().run("validate", fresh).expect(0);
    Path rules = fresh.resolve("design-rules.md");
    Files.writeString(rules, Files.readString(rules) + "Changed.\n");
    new Program()
        .run("validate", fresh)
        .expect(1)
        .says("design-rules.md has changed since the stage 'constrain' ran");
  }

  @Test
  void aModelOfAProjectMustBeWhatItsMetamodelDemands() throws IOException {
    Path fresh = Program.exampleIn(folder.resolve("demanded"));
    Files.delete(fresh.resolve("design-rules.md"));
    Path model = Files.createDirectories(fresh.resolve("model")).resolve("chain.xmi");
    String good = Files.readString(project.resolve("out/chain.xmi"));
    Files.writeString(
        model, good.replace("input=\"//@data.24\"", "input=\"//@data.24 //@data.24\""));
    new Program()
        .run("validate", fresh)
        .expect(1)
        .says("model/chain.xmi:5:")
        .says("holds EventChain[aeb]/data[")
        .says("[ecore.unique]");
    Files.writeString(
        fresh.resolve("eventchain-suppressions.yaml"),
        "- id: ecore.unique\n  reason: It is written twice.\n  expires: 2999-01-01\n");
    new Program()
        .run("validate", fresh)
        .expect(0)
        .says("0 errors, 0 warnings, 1 suppressed")
        .says(" metamodel checks; ");
  }

  @Test
  void aReportThatCannotBeWrittenFails() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "in the way");
    Program.Ended ended =
        new Program()
            .run("validate", project, "--format", "json", "--report", "sarif=" + file + "/a");
    ended.expect(2).says("report.unwritable");
    assertEquals("report.unwritable", json(ended.out()).at("/findings/0/id").asText());
    new Program()
        .run("validate", project, "--report", "sarif=" + folder)
        .expect(2)
        .says("this is a folder");
    assertEquals("in the way", Files.readString(file));
  }

  @Test
  void twoReportsDoNotShareAFile() {
    Path file = folder.resolve("a");
    new Program()
        .run("validate", project, "--report", "sarif=" + file, "--report", "sarif=" + file)
        .expect(2)
        .says("same file");
    assertFalse(Files.exists(file));
  }

  @Test
  void wrongUsageIsRefused() {
    new Program().run("run", project, "-o", "").expect(2).says("-o FOLDER");
    new Program().run("validate", project, "--report", "pdf=a").expect(2).says("FORMAT=FILE");
    new Program().run("validate", project, "--report", "sarif=").expect(2).says("FORMAT=FILE");
    new Program()
        .run("run", project, "--report", "matrix=a.pdf")
        .expect(2)
        .says("a report matrix needs a file whose name ends with .csv or .html");
    new Program()
        .run("validate", project, "--report", "needs=" + folder.resolve("a.json"))
        .expect(2)
        .says("--report needs is for 'run DIR' and 'simulate DIR'");
    Path inside = folder.resolve("lobster/tests.lobster");
    new Program()
        .run(
            "run",
            project,
            "--report",
            "lobster=" + inside.getParent(),
            "--report",
            "needs=" + inside)
        .expect(2)
        .says("two reports would go to the same file: " + inside);
    new Program().run("validate", project, "--date", "soon").expect(2).says("--date");
  }

  @Test
  void ofManyFindingsTheTextShowsTheFirstAndTheReportAll() throws IOException {
    Path model = Files.writeString(folder.resolve("many.xmi"), chainOf(120));
    Path report = folder.resolve("all.json");
    String rule = "[ocl.violated SoftwareNode::HasInputAndOutputData]";
    Program.Ended ended = new Program().run("validate", model, "--report", "json=" + report);
    ended.expect(1).says("... and 20 more " + rule);
    assertEquals(101, ended.out().split(java.util.regex.Pattern.quote(rule), -1).length - 1);
    long written =
        json(Files.readString(report)).findValuesAsText("rule").stream()
            .filter("SoftwareNode::HasInputAndOutputData"::equals)
            .count();
    assertEquals(1 + 120, written, "the check and its findings");
    Program.Ended all = new Program().run("validate", model, "--all").expect(1);
    assertFalse(all.out().contains("more [ocl"), all.out());
  }

  private static String chainOf(int nodes) {
    StringBuilder xmi = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    xmi.append("<eventchain:EventChain xmi:version=\"2.0\" xmlns:xmi=\"http://www.omg.org/XMI\"");
    xmi.append(" xmlns:eventchain=\"http://eventchain.dev/eventchain/1.0\" name=\"many\">\n");
    for (int i = 0; i < nodes; i++) {
      xmi.append("  <software name=\"N").append(i).append("\" frequency=\"20.0\"/>\n");
    }
    return xmi.append("</eventchain:EventChain>\n").toString();
  }

  @InTurn
  @Test
  void suppressedFindingsDoNotFailARunAndStayVisible() throws IOException {
    Path suppressing = copyOfProject();
    Files.writeString(suppressing.resolve("constraints.ocl"), FAST);
    Files.writeString(suppressing.resolve("eventchain-suppressions.yaml"), SUPPRESSED);
    Path sarif = folder.resolve("a.sarif");
    String[] toTheEnd = {"--date", "2027-03-31", "--report", "sarif=" + sarif};
    new Program()
        .run("run", suppressing, toTheEnd[0], toTheEnd[1], toTheEnd[2], toTheEnd[3])
        .expect(0)
        .says("PASSED: 2 of 2 scenarios passed, 6 requirements proved, 8 findings suppressed");
    JsonNode results = json(Files.readString(sarif)).at("/runs/0/results");
    assertEquals(8, results.size());
    for (JsonNode result : results) {
      assertEquals("ocl.violated/SoftwareNode::Fast", result.get("ruleId").asText());
      String reason = result.at("/suppressions/0/justification").asText();
      assertTrue(reason.contains("The new sensors come in spring."), reason);
    }
    new Program()
        .run("validate", suppressing, "--date", "2027-04-01")
        .expect(1)
        .says("suppression.expired")
        .says("4 errors, 1 warning in");
    Files.delete(suppressing.resolve("constraints.ocl"));
    new Program()
        .run("run", suppressing, "--date", "2027-03-31", "--to", "validate")
        .expect(0)
        .says("eventchain-suppressions.yaml:1:3: warning")
        .says("suppression.stale");
  }

  private Path copyOfProject() throws IOException {
    Path copy = Program.exampleIn(folder);
    new Program().run("run", copy, "--to", "constrain").expect(0);
    return copy;
  }

  @Test
  void theDayMayComeFromTheEnvironment() throws IOException {
    Path suppressions = Files.writeString(folder.resolve("s.yaml"), SUPPRESSED);
    Object[] command = {"validate", project, "--suppressions", suppressions};
    new Program().with("SOURCE_DATE_EPOCH", "1900000000").run(command).expect(0).says("expired");
    new Program().with("SOURCE_DATE_EPOCH", "now").run(command).expect(2).says("SOURCE_DATE_EPOCH");
  }

  @Test
  void explainPrintsAPage() {
    new Program().run("explain", "ocl.violated").expect(0).says("# ocl.violated\n");
    new Program()
        .run("explain", "SoftwareNode::NodeNameIsIdentifier")
        .expect(0)
        .says("inv NodeNameIsIdentifier");
    new Program().run("explain", "ocl.violatd").expect(2).says("Did you mean `ocl.violated`?");
    Program.Ended all = new Program().run("explain").expect(0);
    for (String part : List.of("\nocl\n", "\nm2t\n", "  output.locked ", "  xmi.syntax ")) {
      assertTrue(all.out().contains(part), all.out());
    }
  }

  private static JsonNode json(String text) throws IOException {
    return new ObjectMapper().readTree(text);
  }
}
