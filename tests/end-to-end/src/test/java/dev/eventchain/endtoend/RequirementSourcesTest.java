package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests of requirements in the formats of other tools, and of what the command says about them. */
class RequirementSourcesTest {

  private static final Path FORMATS =
      Path.of("tests/end-to-end/src/test/resources/requirements").toAbsolutePath();

  private static final String RULES =
      """
      -- RAD-1.1: all have a name.
      context SoftwareNode
        inv Named: self.name <> ''
      """;

  /** A project with a verdict, of which tests take copies. */
  @TempDir static Path shared;

  private static Path judged;

  @TempDir Path folder;
  private ProjectCopy copy;

  @BeforeAll
  static void runOnce() throws IOException {
    judged = ProjectCopy.of("radar-aeb", shared).path();
    new Program().run("run", judged).expect(0).says("4 requirements proved");
  }

  @BeforeEach
  void copyTheProject() throws IOException {
    copy = new ProjectCopy(folder.resolve("radar-aeb"));
    Projects.copy(judged, copy.path());
    Projects.copy(judged.resolve("out"), copy.path().resolve("out"));
  }

  @Test
  void theTableShowsWhereAllIsAndTheVerdict() throws IOException {
    requirements().expect(0).says("RAD-2        requirements.md:3  -        Collision_Warning");
    JsonNode first = json().get(0);
    assertEquals("requirements.md:2", first.path("source").asText());
    assertEquals("[\"Radar_Tracking\"]", first.path("components").toString());
    assertEquals("[\"short-sight\",\"stopped-vehicle-50\"]", first.path("scenarios").toString());
    assertEquals(List.of("proved", "proved", "proved", "proved"), verdicts());
  }

  @Test
  void noVerdictThatIsNotAboutTheCurrentFilesCounts() throws IOException {
    String scenario = Files.readString(judged.resolve("scenarios/short-sight.yaml"));
    copy.write("scenarios/short-sight.yaml", "# edited\n" + scenario);
    requirements().expect(0).says("not tested: scenarios/short-sight.yaml has changed since");
    assertEquals(List.of("not tested"), verdicts().stream().distinct().toList());
    copy.write("scenarios/short-sight.yaml", scenario);
    requirements().expect(0).says("  proved\n");
    String verdict = Files.readString(judged.resolve("out/verdict.json"));
    copy.write("out/verdict.json", verdict.replaceFirst("proved", "violated"));
    requirements().expect(0).says("not tested: verdict.json was edited");
    copy.write("out/verdict.json", "{}");
    requirements().expect(0).says("not tested: verdict.json cannot be read");
    copy.delete("out");
    requirements().expect(0).says("not tested: nothing was run");
    assertEquals(List.of("not tested"), verdicts().stream().distinct().toList());
  }

  @ParameterizedTest
  @ValueSource(strings = {"reqif", "sdoc", "needs", "doorstop", "trlc"})
  void anyFormatSaysTheSame(String format) throws IOException {
    use(format);
    Program.Ended ended = requirements("--diff", judged).expect(0);
    assertEquals("unchanged: 4\n", ended.out());
    for (JsonNode each : json()) {
      assertEquals(true, each.path("source").asText().startsWith("specs/"), each.toString());
    }
  }

  /** The texts and all else are the same, so that nothing has to be simulated again. */
  @Test
  void theVerdictStaysInAnotherFormat() throws IOException {
    use("reqif");
    requirements().expect(0).says("not tested: ").says("is gone since the stage 'design' ran");
    new Program().run("validate", copy.path()).expect(0);
    copy.run().expect(0).says("unchanged: 2 of 2 scenarios").says("4 requirements proved");
    assertEquals(List.of("proved", "proved", "proved", "proved"), verdicts());
    String report = Files.readString(copy.path().resolve("out/report.html"));
    assertEquals(true, report.contains("\"source\":\"specs/radar.reqif:"), "the source");
    copy.replace("specs/radar.reqif", "below 2.6 s", "below 2.5 s");
    copy.replace("scenarios/stopped-vehicle-50.yaml", "below 2.6 s", "below 2.5 s");
    copy.run().says("radar.reqif says this about RAD-2").says("project.requirement.changed");
  }

  /** A part of an id is no other requirement. */
  @Test
  void idsOfOtherToolsStayAsTheyAre() throws IOException {
    use("needs");
    for (String file :
        List.of(
            "specs/needs.json",
            "model/chain.xmi",
            "scenarios/short-sight.yaml",
            "scenarios/stopped-vehicle-50.yaml")) {
      String text = Files.readString(copy.path().resolve(file));
      copy.write(file, text.replace("RAD-2", "RAD-1.1").replace("RAD-4", "a/b:c (d) é"));
    }
    copy.write("constraints.ocl", RULES);
    copy.run().expect(0).says("4 requirements proved");
    assertEquals(List.of("proved", "proved", "proved", "proved"), verdicts());
    assertEquals("RAD-1.1", json().get(1).path("id").asText());
    assertEquals("[\"stopped-vehicle-50\"]", json().get(3).path("scenarios").toString());
    Path older = Projects.copy(copy.path().resolve("specs"), folder.resolve("older"));
    copy.replace("specs/needs.json", "below 2.6 s", "below 2.5 s");
    copy.replace("specs/needs.json", "vehicle ahead from", "vehicle in front from");
    String changes = requirements("--diff", older).expect(1).out();
    assertEquals(1, changes.split("constraint Named", -1).length - 1, changes);
  }

  @Test
  void aChangedTextMakesItsEvidenceStaleUntilItIsAccepted() throws IOException {
    use("sdoc");
    copy.replace("specs/radar.sdoc", "below 2.6 s", "below 2.5 s");
    copy.replace("specs/radar.sdoc", "RAD-4", "RAD-5");
    copy.write("tests/Collision_Warning.yaml", "tests:\n- name: near\n  requirement: RAD-2\n");
    for (Path old : List.of(judged, judged.resolve("requirements.md"))) {
      requirements("--diff", old)
          .expect(1)
          .says("changed  RAD-2  specs/radar.sdoc:11\n  - The system shall warn")
          .says(
              "below 2.5 s.\n  stale: component Collision_Warning, scenario stopped-vehicle-50,"
                  + " tests/Collision_Warning.yaml\n")
          .says("new      RAD-5  specs/radar.sdoc:23\n  + The system shall not brake")
          .says("gone     RAD-4\n  - The system shall not brake")
          .says("unchanged: 2\n");
    }
    // Results know fingerprints of texts only.
    requirements("--diff", judged.resolve("out")).expect(1).says("changed  RAD-2  specs");
    requirements("--diff", judged.resolve("out/verdict.json")).expect(1).says("unchanged: 2\n");
    new Program().run("accept", copy.path()).expect(0);
    Program.Ended accepted = requirements("--diff", judged).expect(1);
    assertFalse(accepted.out().contains("stale: component Collision_Warning"), accepted.out());
    copy.replace("specs/radar.sdoc", "RAD-5", "RAD-4");
    requirements("--diff", judged).expect(0).says("changed  RAD-2").says("unchanged: 3\n");
    JsonNode changes = tree("--diff", judged).path("changes");
    assertEquals("changed", changes.path(0).path("kind").asText(), changes.toString());
    assertEquals(1, changes.size(), changes.toString());
  }

  @Test
  void whatCannotBeReadIsAFinding() throws IOException {
    requirements("--diff", copy.path().resolve("older")).expect(2).says("file.missing");
    requirements("--diff", copy.path().resolve("bench.yaml")).expect(2).says("requirements.source");
    requirements("--format", "xml").expect(2).says("expected one of");
    Path tests = copy.path().resolve("tests/Radar_Tracking.yaml");
    Files.createDirectories(tests.getParent());
    Files.writeString(tests, "- name: [broken");
    requirements("--diff", copy.path()).expect(2).says("tests/Radar_Tracking.yaml:1");
    Files.delete(tests);
    use("needs");
    copy.replace("specs/needs.json", "\"id\": \"RAD-1\"", "\"id\": RAD-1");
    requirements().expect(2).says("specs/needs.json:11").says("[requirements.source]");
    copy.run().expect(2).says("[requirements.source]");
    new Program().run("validate", copy.path()).expect(2).says("[requirements.source]");
  }

  @Test
  void whatDoesNotCountIsSaid() throws IOException {
    use("needs");
    copy.replace(
        "eventchain.yaml", "requirements: specs", "requirements: {file: specs, only: {type: r}}");
    requirements().expect(2).says("[requirements.selection]").says("modeler.requirements.none");
    copy.replace("eventchain.yaml", "type: r}", "type: req}");
    copy.replace(
        "specs/needs.json",
        "\"type\": \"req\",\n          \"title\": \"RAD-4\"",
        "\"type\": \"info\"");
    requirements().expect(0).says("3 of 4 items count").says("of type 'info' (1)");
    new Program().run("validate", copy.path()).says("[requirements.filtered]").says("RAD-4");
  }

  /** Replaces the requirements by those in another format. */
  private void use(String format) throws IOException {
    Projects.copy(FORMATS.resolve(format), copy.path().resolve("specs"));
    Files.delete(copy.path().resolve("requirements.md"));
    String fields = format.equals("trlc") ? "{file: specs, fields: {id: identifier}}" : "specs";
    Path settings = copy.path().resolve("eventchain.yaml");
    Files.writeString(settings, Files.readString(settings) + "\nrequirements: " + fields + "\n");
  }

  private Program.Ended requirements(Object... more) {
    List<Object> arguments = new ArrayList<>(List.of("requirements", copy.path()));
    arguments.addAll(List.of(more));
    return new Program().run(arguments.toArray());
  }

  private JsonNode tree(Object... more) throws IOException {
    List<Object> arguments = new ArrayList<>(List.of(more));
    arguments.addAll(List.of("--format", "json"));
    return new ObjectMapper().readTree(requirements(arguments.toArray()).expect(0).out());
  }

  private JsonNode json() throws IOException {
    return tree().path("requirements");
  }

  private List<String> verdicts() throws IOException {
    List<String> verdicts = new ArrayList<>();
    json().forEach(each -> verdicts.add(each.path("verdict").asText()));
    return verdicts;
  }
}
