package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.swt.widgets.Text;
import org.eclipse.ui.PlatformUI;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Import > Eventchain > Event chain from JSON. */
class ImportChainWizardTest {

  @TempDir Path folder;

  private TestProject project;
  private WizardBench wizard;
  private Path source;

  @BeforeEach
  void open() throws Exception {
    Workbench.require();
    project = TestProject.create("imported");
    source = folder.resolve("chain.json");
    Files.writeString(source, ChainImportTest.DESCRIPTION);
    wizard =
        new WizardBench(
            PlatformUI.getWorkbench()
                .getImportWizardRegistry()
                .findWizard("dev.eventchain.eclipse.ui.wizards.chain"),
            project.project());
  }

  @AfterEach
  void close() throws Exception {
    if (wizard != null) {
      wizard.close();
    }
    if (project != null) {
      Workbench.run(() -> Workbench.page().closeAllEditors(false));
      project.close();
    }
  }

  private void fill() {
    wizard.type("Description (JSON):", source.toString());
    wizard.type("Name of the chain:", "tracking");
    wizard.type("Frequency in Hz (may be empty):", "20");
  }

  private String findings() {
    return Workbench.run(() -> ((Text) wizard.behind("Findings:")).getText());
  }

  @Test
  void writesAModelAndOpensIt() throws Exception {
    assertEquals("/imported/chain.xmi", wizard.typed("Model (.xmi):"));
    assertFalse(wizard.canFinish());
    fill();
    assertTrue(wizard.canFinish(), wizard.error());
    Workbench.screenshot("wizard-import");
    assertTrue(wizard.finish(), wizard.error());
    assertTrue(project.text("chain.xmi").contains("frequency=\"20.0\""));
    assertEquals(
        "dev.eventchain.eclipse.ui.editor",
        Workbench.run(() -> Workbench.page().getActiveEditor().getSite().getId()));
  }

  @Test
  void errorsAreShownWithTheirLinesAndNothingIsWritten() throws Exception {
    String wrong = ChainImportTest.DESCRIPTION.replace("\"topic\": \"/scan\"", "\"topic\": 5");
    Files.writeString(source, wrong);
    fill();
    assertTrue(wizard.error().contains("has errors"), wizard.error());
    assertTrue(findings().startsWith("Line 6, error: "), findings());
    assertFalse(wizard.canFinish());
    Workbench.screenshot("wizard-import-errors");
    assertFalse(project.file("chain.xmi").exists());
  }

  @Test
  void replacesAModelOnlyWhereThatIsTicked() throws Exception {
    project.write("chain.xmi", "a year of work");
    fill();
    assertTrue(wizard.error().contains("/imported/chain.xmi exists"), wizard.error());
    assertFalse(wizard.canFinish());
    wizard.press("Replace the model if it exists");
    assertTrue(wizard.canFinish(), wizard.error());
    assertTrue(wizard.finish(), wizard.error());
    assertTrue(project.text("chain.xmi").contains("name=\"tracking\""));
  }

  @Test
  void fieldsAreChecked() {
    fill();
    wizard.type("Frequency in Hz (may be empty):", "often");
    assertEquals("The frequency is a number above 0.", wizard.error());
    wizard.type("Frequency in Hz (may be empty):", "");
    assertTrue(wizard.canFinish(), wizard.error());
    wizard.type("Model (.xmi):", "/nowhere/chain.xmi");
    assertTrue(wizard.error().startsWith("Choose a file of the workspace"), wizard.error());
    wizard.type("Model (.xmi):", "/imported/chain.txt");
    assertEquals("The name of the model ends with .xmi.", wizard.error());
  }
}
