package dev.eventchain.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.description.EventChainWriter;
import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Findings about the chain of a project and their files. */
class ProjectValidationTest {

  private static final Duration LIMIT = Duration.ofMinutes(1);

  @TempDir Path folder;

  private ProjectCopy project;
  private ProjectValidation kept;

  @BeforeEach
  void copy() throws IOException {
    project = ProjectCopy.in(folder);
    kept = new ProjectValidation(project.opened(), project.output(), LIMIT);
    kept.validate();
  }

  /**
   * Validates with a new instance and with one that read the files before a change; both must
   * agree.
   */
  private Validation validate() {
    Validation once = ProjectValidation.validate(project.opened(), project.output(), LIMIT);
    assertEquals(once, kept.validate());
    return once;
  }

  @Test
  void whatIsKeptIsReadAgainWhenOneOfItsFilesChanges() throws IOException {
    Files.delete(project.file("software-base/components/Brake_Request.py"));
    assertTrue(found().toString().contains("modeler.component.file"), found()::toString);
    project.write("constraints.ocl", "context SoftwareNode inv Slow: self.frequency < 2");
    assertTrue(found().toString().contains("modeler.component.file"), found()::toString);
    project.write("software-base/components/Brake_Request.py", "class Brake_Request: pass");
    assertTrue(found().toString().contains("ocl.violated"), found()::toString);
    Files.delete(project.file("constraints.ocl"));
    assertEquals(List.of(), found());
  }

  private List<String> found() {
    return validate().diagnostics().stream().map(this::text).toList();
  }

  private String text(Diagnostic found) {
    Path file = Path.of(found.location().file());
    String name = file.equals(folder) ? "." : folder.relativize(file).toString();
    return name.replace('\\', '/') + ":" + found.location().line() + " " + found.id();
  }

  /** A warning lamp on CAN is the software's to send only where it is the node that sends it. */
  @Test
  void softwareSendsWhatItsNodeOfANetworkSends() throws IOException {
    for (String file : List.of("model/chain.xmi", "software-base/components.json")) {
      project.replace(file, "/cluster/collision_warning", "/can/Lamps/Collision");
    }
    project.write(
        "lamps.dbc",
        "BU_: Warning\nBO_ 1 Lamps: 1 Warning\n SG_ Collision : 0|1@1+ (1,0) [0|1] \"\" Warning\n");
    String settings = Files.readString(project.file("eventchain.yaml"));
    project.write("eventchain.yaml", settings + "catalogue: {file: lamps.dbc, node: Warning}\n");
    assertEquals(List.of(), foundOnce());
    project.write("eventchain.yaml", settings + "catalogue: lamps.dbc\n");
    assertTrue(
        foundOnce().contains("model/chain.xmi:36 contract.signal.direction"),
        foundOnce()::toString);
    project.write("eventchain.yaml", settings + "catalogue: {file: lamps.dbc, node: Radar}\n");
    assertTrue(foundOnce().contains("lamps.dbc:1 catalogue.node"), foundOnce()::toString);
  }

  /** The network may be a description of AUTOSAR, in which ports say who sends. */
  @Test
  void softwareSendsWhatItsEcuSends() throws IOException {
    for (String file : List.of("model/chain.xmi", "software-base/components.json")) {
      project.replace(file, "/cluster/collision_warning", "/can/Lamps/Collision");
    }
    Path lamps = Path.of("src/test/resources/lamps.arxml");
    project.write("lamps.arxml", Files.readString(lamps));
    String settings = Files.readString(project.file("eventchain.yaml"));
    project.write("eventchain.yaml", settings + "catalogue: {file: lamps.arxml, node: Warning}\n");
    assertEquals(List.of(), foundOnce());
    project.write("eventchain.yaml", settings + "catalogue: {file: lamps.arxml, node: Radar}\n");
    assertTrue(
        foundOnce().contains("model/chain.xmi:36 contract.signal.direction"),
        foundOnce()::toString);
  }

  private List<String> foundOnce() {
    return ProjectValidation.validate(project.opened(), project.output(), LIMIT)
        .diagnostics()
        .stream()
        .map(this::text)
        .toList();
  }

  @Test
  void aGoodProjectIsCheckedInEveryRespect() {
    Validation fine = validate();
    assertEquals(List.of(), fine.diagnostics());
    assertEquals(
        List.of(folder.resolve("model/chain.xmi").toString().replace('\\', '/')),
        fine.coverage().files());
    for (Coverage.Kind kind :
        List.of(Coverage.Kind.CONSTRAINT, Coverage.Kind.CONTRACT, Coverage.Kind.METAMODEL)) {
      assertTrue(fine.coverage().evaluations(kind) > 0, kind.toString());
    }
    assertFalse(Files.exists(project.output()), "nothing is written");
  }

  @Test
  void aNodeWithoutAFlowToItsNextOneIsFoundInTheModel() throws IOException {
    project.replace("model/chain.xmi", "nextstep=\"//@software.1\"", "nextstep=\"//@software.0\"");
    Validation broken = validate();
    assertTrue(Diagnostic.anyError(broken.diagnostics()), broken.toString());
    assertTrue(
        broken.diagnostics().stream()
            .allMatch(each -> each.location().file().endsWith("model/chain.xmi")),
        broken.diagnostics().toString());
    assertTrue(
        broken.diagnostics().stream().anyMatch(each -> each.location().line() == 3),
        broken.diagnostics().toString());
    assertTrue(broken.coverage().elements() > 0);
  }

  @Test
  void aReferenceThatLeadsNowhereIsFoundAndNothingIsChecked() throws IOException {
    project.replace("model/chain.xmi", "nextstep=\"//@software.1\"", "nextstep=\"//@software.9\"");
    assertEquals(List.of("model/chain.xmi:3 xmi.reference.unresolved"), found());
    assertEquals(Coverage.NONE, validate().coverage());
  }

  @Test
  void aProjectWithoutAModelIsNotWrongAndNotChecked() throws IOException {
    Files.delete(folder.resolve("model/chain.xmi"));
    Validation none = validate();
    assertEquals(List.of("eventchain.yaml:0 project.model.missing"), found());
    assertEquals(Severity.INFO, none.diagnostics().get(0).severity());
    assertEquals(Coverage.NONE, none.coverage());
    assertTrue(none.diagnostics().get(0).kind().has(CommonTrait.UNSUPPRESSIBLE));
  }

  /** Every file is read even if another one is unreadable. */
  @Test
  void allFilesThatCannotBeReadAreSaidAtOnce() throws IOException {
    Files.delete(folder.resolve("requirements.md"));
    Files.createDirectory(folder.resolve("requirements.md"));
    project.write("software-base/signals.json", "[");
    project.write("eventchain.yaml", "name: Radar\n");
    project.write("model/chain.xmi", "<");
    assertEquals(
        List.of(
            "eventchain.yaml:1 project.configuration",
            "model/chain.xmi:1 xmi.syntax",
            "software-base/signals.json:1 modeler.json.syntax",
            "requirements.md:0 file.unreadable"),
        found());
    assertEquals(Coverage.NONE, validate().coverage());
  }

  @ParameterizedTest(name = "{index}: {0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "requirements.md|# Requirements|- RAD-1: Again.|requirements.md:2 modeler.requirements.duplicate",
        "model/chain.xmi|\"RAD-4\"|\"RAD-5\"|model/chain.xmi:42 project.requirement.unknown",
        "model/chain.xmi|the vehicle stands.|it stands.|model/chain.xmi:41 project.requirement.changed",
        "eventchain.yaml|frequency: 50|frequency: 0|eventchain.yaml:4 project.configuration",
      })
  void whatOneFileSaysIsFoundThere(String file, String text, String by, String expected)
      throws IOException {
    project.replace(file, text, by);
    assertEquals(List.of(expected), found());
  }

  @Test
  void otherSettingsAreLeftToTheRun() throws IOException {
    project.write("eventchain.yaml", "name: radar_aeb\nfrequency: 50\nrepairs: many\n");
    assertEquals(List.of(), found());
  }

  @Test
  void aFolderThatIsNoProjectIsSaid() throws IOException {
    Files.move(folder.resolve("eventchain.yaml"), folder.resolve("Eventchain.yaml"));
    assertEquals(List.of(".:0 project.missing"), found());
    assertTrue(validate().diagnostics().get(0).hint().startsWith("Rename 'Eventchain.yaml'"));
    Files.delete(folder.resolve("Eventchain.yaml"));
    assertEquals(List.of(".:0 project.missing"), found());
  }

  @Test
  void designRulesNeedConstraintsAndGeneratedOnesCount() throws IOException {
    project.write("design-rules.md", "- DR-1: Each node has an input.\n");
    assertEquals(List.of("design-rules.md:1 project.rule.uncovered"), found());
    String hint = validate().diagnostics().get(0).hint();
    assertTrue(hint.contains("eventchain run " + folder + " --to constrain"), hint);
    project.write("out/generated.ocl", "context SoftwareNode inv Named: self.name <> null\n");
    hint = validate().diagnostics().get(0).hint();
    assertTrue(hint.contains("eventchain run " + folder + " --from constrain --over"), hint);
    project.write(
        "out/generated.ocl",
        """
        -- DR-1: Each node has an input.
        context SoftwareNode inv HasInput: self.input->size() > 2
        """);
    assertEquals(
        List.of("model/chain.xmi:4 ocl.violated", "model/chain.xmi:5 ocl.violated"), found());
    assertEquals(2, validate().coverage().files().size());
  }

  @Test
  void ownConstraintsThatAreWrongAreFoundInTheirFile() throws IOException {
    project.write(
        "constraints.ocl", "context SoftwareNode inv HasInput: self.inputs->notEmpty()\n");
    assertEquals(List.of("constraints.ocl:1 ocl.type"), found());
  }

  @Test
  void filesThatAreNotReadAreNamed() throws IOException {
    String constraints = "context SoftwareNode inv Slow: self.frequency < 100";
    project.write("timing.ocl", constraints);
    assertEquals(List.of("timing.ocl:0 project.constraints.unread"), found());
    Files.createSymbolicLink(project.file("constraints.ocl"), Path.of("timing.ocl"));
    assertEquals(List.of(), found());
    Files.delete(project.file("constraints.ocl"));
    project.write("constraints.ocl", "import 'timing.ocl'\n");
    assertEquals(List.of(), found());
    Files.delete(project.file("timing.ocl"));
    Files.delete(project.file("constraints.ocl"));
    project.write("Constraints.ocl", constraints);
    Files.move(project.file("tests"), project.file("Tests"));
    project.write("Recordings/README", "a folder for something else");
    Files.move(project.file("model/chain.xmi"), project.file("model/Chain.xmi"));
    assertEquals(
        List.of(
            "Constraints.ocl:0 project.file.misnamed",
            "model/Chain.xmi:0 project.file.misnamed",
            "Tests:0 project.file.misnamed"),
        found().stream().filter(each -> each.contains("misnamed")).toList());
  }

  @Test
  void aModelThatWasMadeFromADescriptionIsFoundWrongInThat() throws IOException {
    derive();
    assertEquals(List.of(), found());
    for (Path file : List.of(folder.resolve("out/chain.xmi"), folder.resolve("out/chain.json"))) {
      Files.writeString(file, Files.readString(file).replace("\"closing_speed", "\"opening_speed"));
    }
    Validation same = validate();
    assertTrue(Diagnostic.anyError(same.diagnostics()), same.toString());
    assertTrue(
        same.diagnostics().get(0).location().file().endsWith("out/chain.json"), same.toString());
  }

  /** Turns the example into a project with a generated model. */
  private void derive() throws IOException {
    ProjectFolder opened = project.opened();
    Path edited = project.file("model/chain.xmi");
    ChainModel model = ChainModel.read(opened, project.output(), edited, LIMIT);
    project.write("out/chain.json", EventChainWriter.write(model.chain()));
    byte[] made =
        XmiStore.toBytes(
            ChainModel.ofDescription(
                    project.file("out/chain.json"),
                    ProjectSettings.read(opened),
                    ProjectFolder.readRules(opened.requirements()),
                    opened.readSoftwareBase())
                .root());
    Files.write(project.file("out/chain.xmi"), made);
    Files.delete(edited);
  }
}
