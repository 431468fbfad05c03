package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.Preferences;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.preferences.IEclipsePreferences;
import org.eclipse.core.runtime.preferences.InstanceScope;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.ui.PlatformUI;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** New > Eventchain > Eventchain Project, with a script in place of the program. */
class ProjectWizardTest {

  private static final String INIT =
      """
      mkdir -p "$2/model" || exit 2
      echo '# Which model does what.' > "$2/eventchain.yaml"
      echo 'name: radar_aeb' >> "$2/eventchain.yaml"
      cat > "$2/model/chain.xmi" <<END
      <?xml version="1.0" encoding="UTF-8"?>
      <eventchain:EventChain xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" \
      xmlns:eventchain="http://eventchain.dev/eventchain/1.0" name="radar_aeb"/>
      END
      """;

  @TempDir Path folder;

  private final IEclipsePreferences preferences = InstanceScope.INSTANCE.getNode(EventchainCore.ID);
  private final IProject project =
      ResourcesPlugin.getWorkspace().getRoot().getProject("Radar Brake");
  private WizardBench wizard;

  @BeforeEach
  void open() throws Exception {
    Workbench.require();
    program(INIT);
    wizard = wizard();
  }

  private static WizardBench wizard() {
    return new WizardBench(
        PlatformUI.getWorkbench()
            .getNewWizardRegistry()
            .findWizard("dev.eventchain.eclipse.ui.wizards.project"));
  }

  private void program(String text) throws Exception {
    Path file = folder.resolve("eventchain");
    Files.writeString(file, "#!/bin/sh\n" + text);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwx------"));
    preferences.put(Preferences.PROGRAM, file.toString());
  }

  @AfterEach
  void close() throws Exception {
    preferences.remove(Preferences.PROGRAM);
    if (wizard != null) {
      wizard.close();
      Workbench.run(() -> Workbench.page().closeAllEditors(false));
      project.delete(true, true, null);
    }
  }

  @Test
  void startsAProjectWithTheNameOfItsChain() throws Exception {
    assertFalse(wizard.canFinish());
    wizard.type("Project name:", "Radar Brake");
    assertEquals("radar_brake", wizard.typed("Name of the chain:"));
    assertTrue(wizard.canFinish(), wizard.error());
    Workbench.screenshot("wizard-project");
    assertTrue(wizard.finish(), wizard.error());
    assertTrue(EventchainCore.hasNature(project));
    Path place = project.getLocation().toPath();
    assertTrue(
        Files.readString(place.resolve("eventchain.yaml")).endsWith("\nname: radar_brake\n"));
    assertTrue(
        Files.readString(place.resolve("model/chain.xmi")).contains(" name=\"radar_brake\"/>"));
    assertEquals(
        "dev.eventchain.eclipse.ui.editor",
        Workbench.run(() -> Workbench.page().getActiveEditor().getSite().getId()));
  }

  @Test
  void nameOfAChainIsChecked() {
    wizard.type("Project name:", "Radar Brake");
    wizard.type("Name of the chain:", "Radar-Brake");
    assertTrue(wizard.error().startsWith("The name of a chain"), wizard.error());
    assertFalse(wizard.canFinish());
    wizard.type("Name of the chain:", "brake_2");
    assertTrue(wizard.canFinish(), wizard.error());
  }

  @Test
  void failureOfTheProgramLeavesNothing() throws Exception {
    program(INIT + "echo 'the disk is full'; exit 2\n");
    wizard.type("Project name:", "Radar Brake");
    assertFalse(wizard.finish());
    assertTrue(wizard.error().contains("the disk is full"), wizard.error());
    Workbench.screenshot("wizard-project-failed");
    assertFalse(project.exists());
    Path place = ResourcesPlugin.getWorkspace().getRoot().getLocation().toPath();
    assertFalse(Files.exists(place.resolve("Radar Brake")));
  }

  @Test
  void cancelledStartLeavesNothing() throws Exception {
    program(
        INIT
            + "trap 'exit 143' TERM\necho ready > \"${0%/*}/ready\"\n"
            + "while :; do sleep 0.1; done\n");
    wizard.type("Project name:", "Radar Brake");
    wizard.begin();
    Workbench.waitFor(() -> Files.exists(folder.resolve("ready")), () -> "the program runs");
    wizard.stop();
    assertFalse(project.exists());
    Path place = ResourcesPlugin.getWorkspace().getRoot().getLocation().toPath();
    assertFalse(Files.exists(place.resolve("Radar Brake")));
  }

  @Test
  void missingProgramIsSaidBeforeAnythingIsMade() {
    preferences.put(Preferences.PROGRAM, folder.resolve("nothing").toString());
    wizard.type("Project name:", "Radar Brake");
    assertFalse(wizard.canFinish());
    assertTrue(wizard.error().contains("Window > Preferences > Eventchain"), wizard.error());
  }

  @Test
  void folderThatIsNotEmptyIsRefused() throws Exception {
    Path taken = folder.resolve("taken");
    Files.createDirectories(taken);
    Files.writeString(taken.resolve("thesis.txt"), "a year of work");
    wizard.type("Project name:", "Radar Brake");
    wizard.press("Use default location");
    wizard.type("Location:", taken.toString());
    assertTrue(wizard.error().contains("is not empty"), wizard.error());
    assertFalse(wizard.canFinish());
    wizard.type("Location:", folder.resolve("free").toString());
    assertTrue(wizard.finish(), wizard.error());
    assertEquals(folder.resolve("free"), project.getLocation().toPath());
    project.delete(true, true, null);
  }

  @Test
  void examplesAreCopiedWithoutTheirResults() throws Exception {
    Path example = folder.resolve("examples/acc");
    Files.createDirectories(example.resolve("out"));
    Files.writeString(example.resolve("out/verdict.json"), "{}");
    Files.writeString(example.resolve("eventchain.yaml"), "name: acc\n");
    wizard.type("Project name:", "Radar Brake");
    choose("Example: aeb");
    assertTrue(wizard.error().contains("examples/aeb"), wizard.error());
    choose("Example: acc");
    assertTrue(wizard.finish(), wizard.error());
    Path place = project.getLocation().toPath();
    assertEquals("name: acc\n", Files.readString(place.resolve("eventchain.yaml")));
    assertFalse(Files.exists(place.resolve("out")));
    assertEquals(
        "eventchain.yaml", Workbench.run(() -> Workbench.page().getActiveEditor().getTitle()));
  }

  private void choose(String start) {
    Workbench.run(
        () -> {
          Combo combo = (Combo) wizard.behind("Start with:");
          combo.setText(start);
          return combo;
        });
  }
}
