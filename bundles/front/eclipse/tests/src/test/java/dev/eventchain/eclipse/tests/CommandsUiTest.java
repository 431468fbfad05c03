package dev.eventchain.eclipse.tests;

import static dev.eventchain.eclipse.tests.TestProject.CHAIN;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.Preferences;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IWorkspace;
import org.eclipse.core.resources.IWorkspaceDescription;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.preferences.InstanceScope;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IMarkerResolution;
import org.eclipse.ui.IPageLayout;
import org.eclipse.ui.console.ConsolePlugin;
import org.eclipse.ui.console.TextConsole;
import org.eclipse.ui.handlers.IHandlerService;
import org.eclipse.ui.ide.IDE;
import org.eclipse.ui.navigator.CommonNavigator;
import org.eclipse.ui.texteditor.ITextEditor;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the commands of the user interface and their visible results. */
class CommandsUiTest {

  private static final String TEXT_EDITOR = "org.eclipse.ui.DefaultTextEditor";
  private static final String COMMANDS = "dev.eventchain.eclipse.ui.";

  @TempDir Path folder;

  @BeforeEach
  void require() {
    Workbench.require();
  }

  @AfterEach
  void tidy() throws Exception {
    InstanceScope.INSTANCE.getNode(EventchainCore.ID).remove(Preferences.PROGRAM);
    setAutoBuilding(false);
    Workbench.run(() -> Workbench.page().closeAllEditors(false));
  }

  private static void setAutoBuilding(boolean on) throws Exception {
    IWorkspace workspace = ResourcesPlugin.getWorkspace();
    IWorkspaceDescription description = workspace.getDescription();
    description.setAutoBuilding(on);
    workspace.setDescription(description);
  }

  private static void save(ITextEditor editor, String text) {
    Workbench.run(
        () -> {
          IDocument document = editor.getDocumentProvider().getDocument(editor.getEditorInput());
          document.set(text);
          editor.doSave(null);
          return document;
        });
  }

  private static ITextEditor open(IFile file) {
    IEditorPart editor = Workbench.run(() -> IDE.openEditor(Workbench.page(), file, TEXT_EDITOR));
    return (ITextEditor) editor;
  }

  /** Selects a resource in the explorer and runs a command of its menu. */
  private static void run(String command, IResource resource) {
    Workbench.run(
        () -> {
          CommonNavigator explorer =
              (CommonNavigator) Workbench.page().showView(IPageLayout.ID_PROJECT_EXPLORER);
          Workbench.page().activate(explorer);
          explorer.selectReveal(new StructuredSelection(resource));
          return explorer;
        });
    Workbench.display()
        .asyncExec( // a dialog would block the waiting thread
            () -> {
              try {
                Workbench.page()
                    .getWorkbenchWindow()
                    .getService(IHandlerService.class)
                    .executeCommand(COMMANDS + command, null);
              } catch (Exception e) { // the test notices, because it then waits in vain
                throw new IllegalStateException(e);
              }
            });
  }

  private static Optional<Shell> shell(String title) {
    return Arrays.stream(Workbench.display().getShells())
        .filter(each -> !each.isDisposed() && each.getText().equals(title))
        .findFirst();
  }

  @Test
  void brokenNextstepHasAMarkerOnSaveThatGoesWhenMended() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("ui-nextstep")) {
      setAutoBuilding(true);
      Workbench.run(() -> Workbench.page().showView(IPageLayout.ID_PROBLEM_VIEW));
      ITextEditor editor = open(project.file(CHAIN));
      String good = project.text(CHAIN);
      save(editor, good.replaceFirst("nextstep=\"[^\"]*\"", "nextstep=\"//@software.99\""));
      Workbench.waitUntil(
          "a marker",
          () -> project.markers().stream().anyMatch(m -> m.endsWith("xmi.reference.unresolved")));
      assertEquals(1, project.found().length, project.markers().toString());
      Workbench.screenshot("problem-of-nextstep");
      save(editor, good);
      Workbench.waitUntil("no marker", () -> project.found().length == 0);
      Workbench.screenshot("no-problem");
    }
  }

  @Test
  void quickFixRemovesAReferenceToNothing() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("ui-fix")) {
      String good = project.text(CHAIN);
      project.write(CHAIN, good.replaceFirst("nextstep=\"[^\"]*\"", "nextstep=\"//@software.99\""));
      project.build();
      IMarker marker = project.marker("xmi.reference.unresolved");
      fix(marker, "Remove the reference");
      Workbench.waitUntil("the change", () -> !project.text(CHAIN).contains("@software.99"));
    }
  }

  @Test
  void quickFixWritesTheNearestName() throws Exception {
    try (TestProject project = TestProject.create("ui-name")) {
      project.write("rules.ocl", "context SoftwareNode\ninv Fast: self.frequenci > 1\n");
      project.build();
      fix(project.found()[0], "Change to 'frequency'");
      Workbench.waitUntil(
          "the change", () -> project.text("rules.ocl").contains("self.frequency > 1"));
      project.build();
      assertEquals(List.of(), project.markers());
    }
  }

  @Test
  void quickFixWritesTheUnitOfTheOtherSide() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("ui-unit")) {
      String good = project.text(CHAIN);
      int last = good.lastIndexOf("unit=\"m/s\"");
      project.write(CHAIN, good.substring(0, last) + "unit=\"km/h\"" + good.substring(last + 10));
      project.build();
      fix(project.marker("contract.unit.mismatch"), "Use the unit of the other side");
      Workbench.waitUntil("the change", () -> project.text(CHAIN).equals(good));
    }
  }

  @Test
  void quickFixTakesOverTheQualityOfServiceOfTheOtherSide() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("ui-qos")) {
      String good = project.text(CHAIN);
      String weak = "<qos name=\"sensor_data\"/>";
      String broken = good.replaceFirst("<qos name=\"default\"/>", weak);
      project.write(CHAIN, broken.replaceFirst("<qos name=\"default\"/>", weak));
      project.build();
      IMarker marker =
          Arrays.stream(project.found())
              .filter(each -> each.getAttribute("id", "").equals("contract.qos.incompatible"))
              .findFirst()
              .orElseThrow();
      long before = count(project.text(CHAIN), weak);
      fix(marker, "Use the quality of service of the other side");
      Workbench.waitUntil("the change", () -> count(project.text(CHAIN), weak) != before);
    }
  }

  private static long count(String text, String part) {
    return text.split(Pattern.quote(part), -1).length - 1L;
  }

  @Test
  void quickFixWritesTheTextOfTheRequirement() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("ui-requirement")) {
      String good = project.text(CHAIN);
      project.write(CHAIN, good.replace("text=\"The system shall warn", "text=\"It might warn"));
      project.build();
      fix(
          project.marker("project.requirement.changed"),
          "Write the text of requirements.md into the model");
      Workbench.waitUntil("the change", () -> project.text(CHAIN).equals(good));
    }
  }

  private static void fix(IMarker marker, String label) {
    Workbench.run(
        () -> {
          IMarkerResolution[] offered = IDE.getMarkerHelpRegistry().getResolutions(marker);
          List<String> labels = Arrays.stream(offered).map(IMarkerResolution::getLabel).toList();
          assertTrue(labels.contains(label), labels.toString());
          assertTrue(labels.get(labels.size() - 1).startsWith("Explain "), labels.toString());
          offered[labels.indexOf(label)].run(marker);
          return labels;
        });
  }

  @Test
  void pageAboutAFindingIsShown() throws Exception {
    try (TestProject project = TestProject.create("ui-explain")) {
      project.write("rules.ocl", "context SoftwareNode\ninv Fast: self.frequenci > 1\n");
      project.build();
      IMarker marker = project.found()[0];
      Workbench.display()
          .asyncExec(
              () -> {
                IMarkerResolution[] all = IDE.getMarkerHelpRegistry().getResolutions(marker);
                all[all.length - 1].run(marker);
              });
      Workbench.waitUntil("the page", () -> shell("ocl.type").isPresent());
      Workbench.screenshot("page-about-a-finding");
      Workbench.run(
          () -> {
            shell("ocl.type").orElseThrow().close();
            return true;
          });
    }
  }

  @Test
  void validateChecksAProjectWithoutTheNature() throws Exception {
    try (TestProject project = TestProject.create("ui-validate")) {
      EventchainCore.setNature(project.project(), false, null);
      project.write("rules.ocl", "context (((");
      run("validate", project.project());
      Workbench.waitUntil("a marker", () -> project.found().length == 1);
    }
  }

  @Test
  void validateSaysWhereThereIsNothingToCheck() throws Exception {
    try (TestProject project = TestProject.create("ui-nothing")) {
      for (String name : List.of("notes.txt", "model-of-what.xmi")) {
        project.write(
            name, "<?xml version=\"1.0\"?>\n<s:Shop xmlns:s=\"http://example.org/shop\"/>\n");
        run("validate", project.file(name));
        Workbench.waitUntil("a dialog", () -> shell("Validate").isPresent());
        Workbench.screenshot("nothing-to-validate");
        Workbench.run(
            () -> {
              shell("Validate").orElseThrow().close();
              return true;
            });
      }
    }
  }

  @Test
  void simulateShowsTheOutputOfTheProgram() throws Exception {
    Path program = folder.resolve("eventchain");
    Files.writeString(program, "#!/bin/sh\necho \"$1 $2/model/chain.xmi:3:3\"\nexit 1\n");
    Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwx------"));
    InstanceScope.INSTANCE.getNode(EventchainCore.ID).put(Preferences.PROGRAM, program.toString());
    try (TestProject project = TestProject.ofRadarExample("ui-simulate")) {
      run("simulate", project.project());
      Workbench.waitUntil("the output", () -> console(project).contains("not PASSED"));
      assertTrue(console(project).contains("simulate " + project.project().getLocation()));
      Workbench.screenshot("console");
    }
  }

  private static String console(TestProject project) {
    String name = "Eventchain: " + project.project().getFullPath();
    return Arrays.stream(ConsolePlugin.getDefault().getConsoleManager().getConsoles())
        .filter(each -> each.getName().equals(name))
        .map(each -> ((TextConsole) each).getDocument().get())
        .findFirst()
        .orElse("");
  }

  @Test
  void withoutTheProgramADialogSaysWhereToSetIt() throws Exception {
    InstanceScope.INSTANCE
        .getNode(EventchainCore.ID)
        .put(Preferences.PROGRAM, folder.resolve("nothing").toString());
    try (TestProject project = TestProject.ofRadarExample("ui-missing")) {
      run("run", project.project());
      Workbench.waitUntil("a dialog", () -> shell("Eventchain").isPresent());
      Workbench.screenshot("no-program");
      Workbench.run(
          () -> {
            shell("Eventchain").orElseThrow().close();
            return true;
          });
    }
  }
}
