package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextEdit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Changes that make the two sides of a topic agree, in the file that has to change. */
class ContractFixTest {

  private static final String UNIT = "contract.unit.mismatch";
  private static final String QOS = "contract.qos.incompatible";

  @TempDir private Path folder;

  private Path project;
  private Path model;

  @BeforeEach
  void copy() throws IOException {
    project =
        Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("radar-aeb"));
    model = project.resolve("model/chain.xmi");
  }

  private void change(UnaryOperator<String> change) throws IOException {
    Files.writeString(model, change.apply(Files.readString(model)));
  }

  private static List<CodeAction> fixes(EditorClient client, Path file, Diagnostic at) {
    CodeActionParams params =
        new CodeActionParams(
            new TextDocumentIdentifier(EditorClient.uri(file)),
            at.getRange(),
            new CodeActionContext(List.of(at)));
    return EditorClient.get(client.server().getTextDocumentService().codeAction(params)).stream()
        .map(each -> each.getRight())
        .filter(each -> each.getDiagnostics().contains(at))
        .filter(each -> !each.getTitle().matches("(Explain|Suppress) .*"))
        .toList();
  }

  private Diagnostic await(EditorClient client, String id) {
    return client.await(model, each -> each.stream().anyMatch(it -> is(it, id))).stream()
        .filter(it -> is(it, id))
        .findFirst()
        .orElseThrow();
  }

  private static boolean is(Diagnostic finding, String id) {
    return finding.getCode().getLeft().equals(id);
  }

  /** Makes a change, and waits until the finding is gone. */
  private void apply(EditorClient client, CodeAction action, String id) {
    client.open(model);
    for (Map.Entry<String, List<TextEdit>> each : action.getEdit().getChanges().entrySet()) {
      assertEquals(EditorClient.uri(model), each.getKey());
      TextEdit edit = each.getValue().get(0);
      client.change(model, edit.getRange(), edit.getNewText());
    }
    client.await(model, each -> each.stream().noneMatch(it -> is(it, id)));
  }

  @Test
  void aUnitThatIsNotKnownIsWrittenLikeThatOfTheOtherSide() throws Exception {
    change(text -> text.replace("unit=\"km/h\"", "unit=\"kmph\""));
    try (TestSession session = new TestSession(project)) {
      Diagnostic found = await(session.client, UNIT);
      List<CodeAction> fixes = fixes(session.client, model, found);
      assertEquals(
          List.of("Change the unit to 'km/h'"), fixes.stream().map(CodeAction::getTitle).toList());
      assertTrue(fixes.get(0).getIsPreferred());
      apply(session.client, fixes.get(0), UNIT);
    }
  }

  /** Where a value is converted, code has to change with the model: nothing does it unasked. */
  @Test
  void aUnitThatCanBeConvertedIsChangedOnRequest() throws Exception {
    change(text -> text.replace("unit=\"km/h\"", "unit=\"m/s\""));
    try (TestSession session = new TestSession(project)) {
      List<CodeAction> fixes = fixes(session.client, model, await(session.client, UNIT));
      assertEquals(
          List.of("Change the unit to 'km/h', which the component's code must follow"),
          fixes.stream().map(CodeAction::getTitle).toList());
      assertFalse(fixes.get(0).getIsPreferred());
      apply(session.client, fixes.get(0), UNIT);
    }
  }

  /** A letter may be the difference between two units, of which one is not known. */
  @Test
  void aUnitThatIsNotKnownIsReplacedByAnotherOneOnRequest() throws Exception {
    change(text -> text.replace("unit=\"km/h\"", "unit=\"kf/h\""));
    try (TestSession session = new TestSession(project)) {
      List<CodeAction> fixes = fixes(session.client, model, await(session.client, UNIT));
      assertEquals(
          List.of("Change the unit to 'km/h', which the component's code must follow"),
          fixes.stream().map(CodeAction::getTitle).toList());
      assertFalse(fixes.get(0).getIsPreferred());
    }
  }

  @Test
  void aDifferentQuantityIsNoMatterOfWriting() throws Exception {
    change(text -> text.replace("unit=\"km/h\"", "unit=\"kg\""));
    try (TestSession session = new TestSession(project)) {
      assertEquals(List.of(), fixes(session.client, model, await(session.client, UNIT)));
    }
  }

  @Test
  void aComponentRequestsWhatTheVehicleOffers() throws Exception {
    change(text -> text.replaceFirst("<qos name=\"sensor_data\"/>", "<qos name=\"default\" />"));
    try (TestSession session = new TestSession(project)) {
      List<CodeAction> fixes = fixes(session.client, model, await(session.client, QOS));
      assertEquals(
          List.of("Request reliability BEST_EFFORT in 'Radar_Tracking'"),
          fixes.stream().map(CodeAction::getTitle).toList());
      assertTrue(fixes.get(0).getIsPreferred());
      assertEquals(
          " reliability=\"BEST_EFFORT\"",
          fixes.get(0).getEdit().getChanges().get(EditorClient.uri(model)).get(0).getNewText());
      apply(session.client, fixes.get(0), QOS);
    }
  }

  /** The field of the threat that is written first has the profile of the publisher. */
  @Test
  void ofTwoComponentsEitherOneCanChange() throws Exception {
    change(
        text -> {
          int at = text.indexOf("<qos", text.indexOf("name=\"ttc\""));
          return text.substring(0, at)
              + text.substring(at)
                  .replaceFirst("<qos name=\"default\"", "<qos reliability=\"BEST_EFFORT\"");
        });
    for (int which = 0; which < 2; which++) {
      try (TestSession session = new TestSession(project)) {
        List<CodeAction> fixes = fixes(session.client, model, await(session.client, QOS));
        assertEquals(
            List.of(
                "Request reliability BEST_EFFORT in 'Brake_Request'",
                "Offer reliability RELIABLE in 'Radar_Tracking'"),
            fixes.stream().map(CodeAction::getTitle).toList());
        assertFalse(fixes.get(which).getIsPreferred());
        TextEdit edit = fixes.get(which).getEdit().getChanges().get(EditorClient.uri(model)).get(0);
        assertTrue(edit.getNewText().contains(which == 0 ? "BEST_EFFORT" : "RELIABLE"));
      }
    }
  }
}
