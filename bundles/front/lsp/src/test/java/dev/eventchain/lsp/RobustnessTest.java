package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.check.RulePageFiles;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.text.OpenTexts;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files and messages that a session must survive. */
class RobustnessTest {

  @TempDir private Path folder;

  @Test
  void constraintsThatCannotBeReadAreAFindingAndTheTextInTheEditorCounts() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    Path project = Projects.copy(example, folder.resolve("radar-aeb"));
    Path constraints = project.resolve("constraints.ocl");
    String text =
        "package eventchain\n-- f\u00fcr alle\ncontext SoftwareNode inv A: name <> ''\nendpackage\n";
    Files.writeString(constraints, text, StandardCharsets.ISO_8859_1);
    Path other = Files.writeString(folder.resolve("other.ocl"), "context Nothing inv A: true");
    try (TestSession session = new TestSession(folder)) {
      session.client.await(constraints, each -> !each.isEmpty());
      session.client.await(other, each -> !each.isEmpty());
      session.client.open(constraints, text);
      session.client.await(constraints, List::isEmpty);
      assertTrue(session.client.isListening());
    }
  }

  @Test
  void aDefectKeepsNothingElseFromBeingChecked() throws Exception {
    Path first = Files.writeString(folder.resolve("a.ocl"), "context Nothing inv A: true");
    Path second = Files.writeString(folder.resolve("b.ocl"), "context Nothing inv B: true");
    List<String> shown = new CopyOnWriteArrayList<>();
    List<String> logged = new CopyOnWriteArrayList<>();
    OpenTexts texts = new OpenTexts();
    try (RulePageFiles pages = new RulePageFiles()) {
      Findings findings =
          new Findings(
              texts,
              pages,
              found -> {
                if (found.getUri().equals(EditorClient.uri(first))) {
                  throw new IllegalStateException("a defect");
                }
                shown.add(found.getUri());
              });
      try (Checks checks = new Checks(texts, findings, logged::add)) {
        checks.open(List.of(folder), Settings.USUAL);
        checks.await();
      }
    }
    assertEquals(List.of(EditorClient.uri(second)), shown);
    assertEquals(1, logged.size(), logged.toString());
    assertTrue(logged.get(0).contains("a defect"), logged.toString());
  }
}
