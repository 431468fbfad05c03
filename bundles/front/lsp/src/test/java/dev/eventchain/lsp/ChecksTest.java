package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.OclValidator;
import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.check.RulePageFiles;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** When something is checked, and what can be asked meanwhile. */
class ChecksTest {

  private static final String WRONG = "context Nothing inv A: true";
  private static final String ENDLESS =
      """
      context EventChain inv Endless:
        Sequence{1..100000}->forAll(a | Sequence{1..100000}->forAll(b | a + b > -self.name.size()))
      """;
  private static final Range ALL = new Range(new Position(0, 0), new Position(99, 0));

  @TempDir private Path folder;

  private final OpenTexts texts = new OpenTexts();
  private final RulePageFiles pages = new RulePageFiles();
  private final Map<String, Integer> shown = new ConcurrentHashMap<>();
  private final CountDownLatch publishes = new CountDownLatch(1);
  private final CountDownLatch goesOn = new CountDownLatch(1);
  private final Findings findings = new Findings(texts, pages, this::publish);

  private void publish(PublishDiagnosticsParams params) {
    publishes.countDown();
    shown.put(params.getUri(), params.getDiagnostics().size());
    try {
      goesOn.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @AfterEach
  void close() {
    goesOn.countDown();
    pages.close();
  }

  private int shown(Path file) {
    return shown.getOrDefault(EditorClient.uri(file), 0);
  }

  /** An editor that does not read what it is told keeps nobody else waiting. */
  @Test
  void questionsAreAnsweredWhileFindingsArePublished() throws Exception {
    Path file = Files.writeString(folder.resolve("a.ocl"), WRONG);
    try (Checks checks = new Checks(texts, findings, each -> {})) {
      checks.open(List.of(folder), Settings.USUAL);
      publishes.await();
      Future<Integer> answers =
          CompletableFuture.supplyAsync(
              () -> {
                checks.changed(file);
                checks.appearedOrGone(List.of(folder.resolve("b.ocl")));
                int others = checks.metamodels(file).size();
                return checks.files().all().size() + others + findings.in(file, ALL).size();
              });
      try {
        assertEquals(2, answers.get(30, TimeUnit.SECONDS));
      } finally {
        goesOn.countDown();
      }
    }
  }

  /**
   * What comes and goes below a project's results, in hidden folders and in those of build tools
   * makes nothing be checked again: here, a change of which nobody has told stays unseen.
   */
  @Test
  void resultsOfRunsAreNotChecked() throws Exception {
    goesOn.countDown();
    Path project =
        Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("radar-aeb"));
    Path rules = Files.writeString(folder.resolve("a.ocl"), "context EventChain inv A: true");
    Path configuration = project.resolve("eventchain.yaml");
    try (Checks checks = new Checks(texts, findings, each -> {})) {
      checks.open(List.of(folder), Settings.USUAL);
      checks.await();
      Files.writeString(rules, WRONG);
      Files.writeString(configuration, "nothing: known\n");
      for (String below : List.of("out/a.ocl", "out/x/b.xmi", ".git/c.ocl", "target/d.ocl")) {
        checks.appearedOrGone(List.of(project.resolve(below)));
      }
      Path out = Files.createDirectories(project.resolve("out"));
      checks.appearedOrGone(List.of(folder.resolve(".cache/e.ocl"), out));
      checks.await();
      assertEquals(0, shown(rules) + shown(configuration));
      checks.appearedOrGone(List.of(project.resolve("outline/f.ocl")));
      checks.await();
      assertTrue(shown(rules) > 0 && shown(configuration) > 0, shown.toString());
    }
  }

  /** The model that a run makes counts as soon as it is there. */
  @Test
  void aNewModelAmongResultsIsChecked() throws Exception {
    goesOn.countDown();
    Path project =
        Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("radar-aeb"));
    Path edited = project.resolve("model/chain.xmi");
    String model = Files.readString(edited).replace("id=\"RAD-4\"", "id=\"RAD-5\"");
    Files.delete(edited);
    Path made = project.resolve("out/chain.xmi");
    Files.createDirectories(made.getParent());
    try (Checks checks = new Checks(texts, findings, each -> {})) {
      checks.open(List.of(project), Settings.USUAL);
      checks.await();
      Files.writeString(made, model);
      checks.appearedOrGone(List.of(made));
      checks.await();
      assertTrue(shown(made) > 0, shown.toString());
      Files.delete(made);
      Files.delete(made.getParent());
      checks.appearedOrGone(List.of(made.getParent()));
      checks.await();
      assertEquals(0, shown(made));
    }
  }

  /** A project of a build tool's folder is checked while a file of it is open. */
  @Test
  void aProjectInAFolderThatIsPassedOverIsChecked() throws Exception {
    goesOn.countDown();
    Path project =
        Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("target/demo"));
    Path configuration = project.resolve("eventchain.yaml");
    String text = Files.readString(configuration);
    texts.open(new OpenText(EditorClient.uri(configuration), configuration, 1, text));
    try (Checks checks = new Checks(texts, findings, each -> {})) {
      checks.open(List.of(folder), Settings.USUAL);
      checks.await();
      Path campaign = project.resolve("campaigns/c.yaml");
      Files.createDirectories(campaign.getParent());
      Files.writeString(campaign, "scenario: a\n");
      checks.appearedOrGone(List.of(campaign));
      checks.await();
      assertTrue(shown(campaign) > 0, shown.toString());
    }
  }

  /**
   * A check says nothing about texts that have changed since, and would keep those from being
   * checked: this one would go on for days.
   */
  @Test
  void aCheckEndsWhenATextChangesThatItHasRead() throws Exception {
    goesOn.countDown();
    Path project =
        Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("radar-aeb"));
    Path rules = project.resolve("constraints.ocl");
    texts.open(new OpenText(EditorClient.uri(rules), rules, 1, ENDLESS));
    try (Checks checks = new Checks(texts, findings, each -> {})) {
      checks.open(List.of(project), new Settings(List.of(), Duration.ofDays(100)));
      while (!isEvaluating()) {
        Thread.sleep(10); // to look halts all threads
      }
      texts.open(new OpenText(EditorClient.uri(rules), rules, 2, WRONG));
      checks.changed(rules);
      checks.await();
      assertEquals(1, shown(rules), shown.toString());
    }
  }

  private static boolean isEvaluating() {
    return Thread.getAllStackTraces().entrySet().stream()
        .filter(each -> each.getKey().getName().equals("checks"))
        .flatMap(each -> Stream.of(each.getValue()))
        .anyMatch(frame -> frame.getClassName().equals(OclValidator.class.getName()));
  }
}
