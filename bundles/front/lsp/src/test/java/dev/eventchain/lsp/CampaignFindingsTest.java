package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.pipeline.campaign.CampaignOptions;
import dev.eventchain.pipeline.campaign.Campaigns;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.lsp4j.Diagnostic;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Findings about the campaign files of a project, as they are typed. */
class CampaignFindingsTest {

  private static final String GOOD =
      """
      scenario: stopped-vehicle-50
      factors:
        gap: {path: "actors[0].gap_m", values: [50, 80]}
      """;

  @TempDir private Path folder;

  private Path project;

  @BeforeEach
  void copy() throws Exception {
    project = Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("p"));
    Files.createDirectories(project.resolve("campaigns"));
  }

  private Path write(String name, String text) throws IOException {
    return Files.writeString(project.resolve("campaigns").resolve(name), text);
  }

  @Test
  void areThoseOfTheCommandLine() throws IOException {
    String bad = GOOD.replace("values", "valus") + "repetitions: 0\nsede: 1\n";
    Path file = write("c.yaml", bad);
    List<dev.eventchain.diagnostics.Diagnostic> said =
        assertThrows(
                DiagnosticException.class,
                () ->
                    Campaigns.run(
                        Project.open(project),
                        RunOptions.of(folder.resolve("out")),
                        CampaignOptions.of(file),
                        Progress.NONE))
            .diagnostics();
    assertFalse(said.size() < 3, said.toString());
    try (TestSession session = new TestSession(project)) {
      List<Diagnostic> shown = session.client.await(file, each -> !each.isEmpty());
      assertEquals(
          said.stream().map(each -> each.id()).sorted().toList(),
          shown.stream().map(each -> each.getCode().getLeft()).sorted().toList());
      EditorClient client = session.client;
      client.open(file, GOOD);
      client.await(file, List::isEmpty);
      client.close(file);
      client.await(file, each -> each.size() == said.size());
    }
  }

  /** A search goes between bounds, and a file of another kind is nobody's campaign. */
  @Test
  void areNoneForSearchesAndOtherFiles() throws IOException {
    Path other = write("a.yaml", "cases: 3\n");
    Path search = write("b.yaml", GOOD.replace("values", "uniform"));
    Path bad = write("c.yaml", GOOD.replace("values", "valus"));
    try (TestSession session = new TestSession(project)) {
      session.client.await(bad, each -> !each.isEmpty());
      session.client.await(search, List::isEmpty);
      session.client.await(other, List::isEmpty);
    }
  }

  /** The file by itself is fine: what it names is not there. The command generates the nodes. */
  @Test
  void areThoseOfTheCommandLineAboutPaths() throws IOException {
    Path file =
        write(
            "c.yaml",
            """
            scenario: stopped-vehicle-50
            factors:
              gap: {path: "actors[7].gap_m", values: [50, 80]}
              late: {path: "bench:provided[7].delay", values: [1]}
              phase: {path: "phases_ms.Radar_Trackin", values: [1]}
            """);
    Path out = folder.resolve("out");
    List<String> said =
        assertThrows(
                DiagnosticException.class,
                () ->
                    Campaigns.run(
                        Project.open(project),
                        RunOptions.of(out).in(out, Stage.DESIGN, Stage.GENERATE),
                        CampaignOptions.of(file),
                        Progress.NONE))
            .diagnostics()
            .stream()
            .map(each -> each.id() + " " + each.message())
            .sorted()
            .toList();
    assertEquals(3, said.size(), said.toString());
    try (TestSession session = new TestSession(project)) {
      List<Diagnostic> shown = session.client.await(file, each -> !each.isEmpty());
      assertEquals(said, shown.stream().map(CampaignFindingsTest::text).sorted().toList());
    }
  }

  /** Each is the only fault of its file, and gone with it. */
  @Test
  void areAboutValuesAndScenariosThatDoNotFit() throws IOException {
    Path value =
        write("a.yaml", GOOD.replace("actors[0].gap_m", "duration_s").replace("80]", "-80]"));
    Path key = write("b.yaml", GOOD.replace("gap_m", "gap_meters"));
    Path scenario = write("c.yaml", GOOD.replace("vehicle-50", "vehicle-5"));
    try (TestSession session = new TestSession(project)) {
      for (Path file : List.of(value, key, scenario)) {
        List<Diagnostic> shown = session.client.await(file, each -> !each.isEmpty());
        assertEquals(
            List.of("campaign.factor"),
            shown.stream().map(each -> each.getCode().getLeft()).toList());
        session.client.open(file, GOOD);
        session.client.await(file, List::isEmpty);
      }
    }
  }

  /** Without a chain, nobody knows what formulas of the bench and of scenarios may read. */
  @Test
  void areNoneAboutFactorsWithoutAChain() throws IOException {
    Files.delete(project.resolve("model/chain.xmi"));
    Path file = write("a.yaml", GOOD.replace("[0]", "[7]"));
    Path bad = write("c.yaml", GOOD.replace("values", "valus"));
    try (TestSession session = new TestSession(project)) {
      session.client.await(bad, each -> !each.isEmpty());
      session.client.await(file, List::isEmpty);
    }
  }

  private static String text(Diagnostic finding) {
    String message = finding.getMessage().getLeft();
    int hint = message.indexOf('\n');
    return finding.getCode().getLeft() + " " + (hint < 0 ? message : message.substring(0, hint));
  }
}
