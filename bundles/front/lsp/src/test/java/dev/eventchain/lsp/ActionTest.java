package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.ExecuteCommandParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.ShowDocumentCapabilities;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.WindowClientCapabilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What an editor offers at a finding. */
class ActionTest {

  @TempDir private Path folder;

  private static List<CodeAction> actions(EditorClient client, Path file, Diagnostic at) {
    CodeActionParams params =
        new CodeActionParams(
            new TextDocumentIdentifier(EditorClient.uri(file)),
            at.getRange(),
            new CodeActionContext(List.of(at)));
    return EditorClient.get(client.server().getTextDocumentService().codeAction(params)).stream()
        .map(each -> each.getRight())
        .toList();
  }

  @Test
  void aHintBecomesAChangeAndARuleAPage() throws Exception {
    Path file =
        Files.writeString(
            folder.resolve("rules.ocl"),
            "package eventchain\ncontext SoftwareNode inv A: self.nmae <> ''\nendpackage\n");
    WindowClientCapabilities window = new WindowClientCapabilities();
    window.setShowDocument(new ShowDocumentCapabilities(true));
    ClientCapabilities capabilities = new ClientCapabilities();
    capabilities.setWindow(window);
    InitializeParams params = new InitializeParams();
    params.setCapabilities(capabilities);
    try (TestSession session = new TestSession(params, folder)) {
      Diagnostic found = session.client.await(file, each -> !each.isEmpty()).get(0);
      List<CodeAction> actions = actions(session.client, file, found);
      assertEquals(
          List.of("Change to 'name'", "Explain " + found.getCode().getLeft()),
          actions.stream().map(CodeAction::getTitle).toList());
      TextEdit edit = actions.get(0).getEdit().getChanges().get(EditorClient.uri(file)).get(0);
      session.client.open(file);
      session.client.change(file, edit.getRange(), edit.getNewText());
      session.client.await(file, List::isEmpty);
      ExecuteCommandParams explain =
          new ExecuteCommandParams(
              actions.get(1).getCommand().getCommand(), actions.get(1).getCommand().getArguments());
      Object page =
          EditorClient.get(session.client.server().getWorkspaceService().executeCommand(explain));
      assertTrue(page.toString().contains(found.getCode().getLeft()), page.toString());
      assertEquals(1, session.client.opened().size());
    }
  }

  /** Suppressions are read by the check of the project, and a template has one of its own. */
  @Test
  void nothingIsSuppressedThatTheProjectDoesNotCheck() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    Path project = Projects.copy(example, folder.resolve("radar-aeb"));
    Path template =
        Files.writeString(
            project.resolve("own.mtl"), "[module own('http://nowhere.example/none')/]\n");
    try (TestSession session = new TestSession(project)) {
      Diagnostic found = session.client.await(template, each -> !each.isEmpty()).get(0);
      assertEquals(
          List.of("Explain " + found.getCode().getLeft()),
          actions(session.client, template, found).stream().map(CodeAction::getTitle).toList());
    }
  }

  /** The commands about campaigns read no suppressions for what is wrong with their files. */
  @Test
  void nothingIsSuppressedOfACampaignFile() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    Path project = Projects.copy(example, folder.resolve("radar-aeb"));
    Path campaign = project.resolve("campaigns/c.yaml");
    Files.createDirectories(campaign.getParent());
    Files.writeString(campaign, "scenario: stopped-vehicle-50\n");
    try (TestSession session = new TestSession(project)) {
      Diagnostic found = session.client.await(campaign, each -> !each.isEmpty()).get(0);
      assertEquals(
          List.of("Explain " + found.getCode().getLeft()),
          actions(session.client, campaign, found).stream().map(CodeAction::getTitle).toList());
    }
  }

  @Test
  void aFindingOfAProjectCanBeSuppressedWithAReason() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    Path project = Projects.copy(example, folder.resolve("radar-aeb"));
    Path suppressions = project.resolve("eventchain-suppressions.yaml");
    Path model = project.resolve("model/chain.xmi");
    Files.writeString(model, Files.readString(model).replace("id=\"RAD-4\"", "id=\"RAD-5\""));
    try (TestSession session = new TestSession(project)) {
      EditorClient client = session.client;
      Diagnostic found = client.await(model, each -> !each.isEmpty()).get(0);
      CodeAction suppress =
          actions(client, model, found).stream()
              .filter(each -> each.getTitle().startsWith("Suppress"))
              .findFirst()
              .orElseThrow();
      TextEdit edit = suppress.getEdit().getChanges().get(EditorClient.uri(suppressions)).get(0);
      Files.writeString(suppressions, edit.getNewText());
      client.await(suppressions, each -> !each.isEmpty());
      Files.writeString(
          suppressions, edit.getNewText().replace("reason: ", "reason: It is planned."));
      client.await(model, each -> !each.contains(found));
    }
  }
}
