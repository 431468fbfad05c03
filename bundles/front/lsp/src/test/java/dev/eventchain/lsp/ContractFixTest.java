package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.check.ChainModel;
import dev.eventchain.description.EventChainWriter;
import dev.eventchain.editing.TextLines;
import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
    return await(client, model, id);
  }

  private static Diagnostic await(EditorClient client, Path file, String id) {
    return client.await(file, each -> each.stream().anyMatch(it -> is(it, id))).stream()
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

  /** Makes the project one whose chain was described, and returns the description. */
  private Path derive() throws IOException {
    ProjectFolder opened = new ProjectFolder(project);
    Path description = project.resolve("out/chain.json");
    ChainModel edited =
        ChainModel.read(opened, opened.defaultOutput(), model, Duration.ofSeconds(30));
    Files.createDirectories(description.getParent());
    Files.writeString(description, EventChainWriter.write(edited.chain()));
    EventChain made =
        ChainModel.ofDescription(
                description,
                ProjectSettings.read(opened),
                opened.readRequirements(),
                opened.readSoftwareBase())
            .root();
    Files.write(project.resolve("out/chain.xmi"), XmiStore.toBytes(made));
    Files.delete(model);
    return description;
  }

  private static String applied(CodeAction action, Path file) throws IOException {
    TextEdit edit = action.getEdit().getChanges().get(EditorClient.uri(file)).get(0);
    TextLines lines = new TextLines(Files.readString(file));
    int start = lines.offset(Positions.of(edit.getRange().getStart()));
    int end = lines.offset(Positions.of(edit.getRange().getEnd()));
    String text = Files.readString(file);
    return text.substring(0, start) + edit.getNewText() + text.substring(end);
  }

  /** Returns the fixes of a finding by their titles, each with the text that it leads to. */
  private Map<String, String> texts(Path file, String id) throws IOException {
    Map<String, String> texts = new LinkedHashMap<>();
    try (TestSession session = new TestSession(project)) {
      Diagnostic found = await(session.client, file, id);
      for (CodeAction each : fixes(session.client, file, found)) {
        texts.put(each.getTitle(), applied(each, file));
      }
    }
    return texts;
  }

  @Test
  void aUnitInADescriptionIsChangedThere() throws Exception {
    change(text -> text.replace("unit=\"km/h\"", "unit=\"kmph\""));
    Path description = derive();
    String text = Files.readString(description);
    assertEquals(
        Map.of("Change the unit to 'km/h'", text.replace("\"kmph\"", "\"km/h\"")),
        texts(description, UNIT));
  }

  @Test
  void aProfileInADescriptionGetsThePolicy() throws Exception {
    change(text -> text.replaceFirst("<qos name=\"sensor_data\"/>", "<qos name=\"default\" />"));
    Path description = derive();
    String text = Files.readString(description);
    Map<String, String> fixes = texts(description, QOS);
    String title = "Request reliability BEST_EFFORT in 'Radar_Tracking'";
    assertEquals(Set.of(title), fixes.keySet());
    assertEquals(
        text.replaceFirst(
            "\"default\"", "{\"profile\": \"default\", \"reliability\": \"BEST_EFFORT\"}"),
        fixes.get(title));
  }

  @Test
  void aDepthInADescriptionGetsThePolicy() throws Exception {
    change(text -> text.replaceFirst("<qos name=\"sensor_data\"/>", "<qos depth=\"7\"/>"));
    Path description = derive();
    String written = Files.readString(description);
    String text = written.replaceFirst("\\{\\s*\"depth\": 7\\s*\\}", "7");
    Files.writeString(description, text);
    String title = "Request reliability BEST_EFFORT in 'Radar_Tracking'";
    assertEquals(
        Map.of(
            title,
            text.replaceFirst(
                "\"qos_profile\": 7",
                "\"qos_profile\": {\"depth\": 7, \"reliability\": \"BEST_EFFORT\"}")),
        texts(description, QOS));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"sensor_data\" | \"sensor_dta\"                    | sensor_data",
        "\"sensor_data\" | {\"profile\": \"sensor_dta\"}     | sensor_data",
        "\"sensor_data\" | {\"reliability\": \"BEST_EFORT\"} | BEST_EFFORT",
      })
  void aMisspeltProfileIsReplacedByTheNearestOne(String old, String wrong, String right)
      throws Exception {
    String misspelt = wrong.replaceFirst(".*\"([a-zA-Z_]+)\"}?", "$1");
    for (String name : List.of("signals.json", "components.json")) {
      Path file = project.resolve("software-base").resolve(name);
      String text = Files.readString(file);
      Files.writeString(file, text.replaceFirst(old, wrong));
      assertEquals(
          Map.of("Change to '" + right + "'", Files.readString(file).replace(misspelt, right)),
          texts(file, "modeler.qos.unknown"));
      Files.writeString(file, text);
    }
  }

  @Test
  void unitsOfTheBenchAreWrittenAsTheyAreKnown() throws Exception {
    Path bench = project.resolve("bench.yaml");
    String text = Files.readString(bench);
    String field = "range: min(gap, radar.reach)";
    Files.writeString(bench, text.replace("{unit: m, value: 150}", "{unit: kmph, value: 150}"));
    Map<String, String> fixes = texts(bench, "bench.unit");
    assertEquals(Set.of("Change to 'km/h'"), fixes.keySet());
    assertTrue(fixes.get("Change to 'km/h'").contains("{unit: km/h, value: 150}"));
    Files.writeString(
        bench, text.replace(field, "range: {value: 'min(gap, radar.reach)', unit: \"km\"} # far"));
    String title = "Change the unit to 'm', as in signals.json";
    fixes = texts(bench, "bench.unit");
    assertEquals(Set.of(title), fixes.keySet());
    assertTrue(fixes.get(title).contains("unit: \"m\"} # far"), fixes.get(title));
  }
}
