package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.Workspace;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.project.ProjectLanguageService;
import dev.eventchain.lsp.text.OpenTexts;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is known of the requirements that the files of a project name. */
class ProjectTextTest {

  @TempDir private Path folder;

  private Path project;
  private Path scenario;
  private String text;
  private Analysis analysis;

  @BeforeEach
  void open() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    project = Projects.copy(example, folder.resolve("radar-aeb"));
    scenario = project.resolve("scenarios/stopped-vehicle-50.yaml");
    text = Files.readString(scenario);
    analysis = analysis(scenario);
  }

  /** The files on disk. */
  private static final class Disk implements Workspace {
    @Override
    public List<Path> files() {
      return List.of();
    }

    @Override
    public Optional<SourceText> text(Path file) {
      return Optional.of(SourceText.read(file));
    }

    @Override
    public List<EPackage> metamodels(Path file) {
      return List.of();
    }
  }

  private static Analysis analysis(Path file) {
    return new ProjectLanguageService(new Disk(), new OpenTexts()).analysis(file).orElseThrow();
  }

  private TextPosition at(String word) {
    return new TextLines(text).position(text.indexOf(word) + 1);
  }

  @Test
  void leadsFromAScenarioToItsRequirementAndBack() throws Exception {
    Path requirements = project.resolve("requirements.md");
    assertEquals(requirements, analysis.definitions(at("RAD-1")).get(0).file());
    assertTrue(analysis.hover(at("RAD-1")).orElseThrow().markdown().startsWith("**RAD-1** "));
    TextPosition written = analysis.definitions(at("RAD-1")).get(0).range().start();
    List<Path> uses =
        analysis(requirements).references(written, false).stream().map(it -> it.file()).toList();
    assertTrue(uses.contains(scenario), uses.toString());
    assertTrue(uses.contains(project.resolve("model/chain.xmi")), uses.toString());
    assertEquals("RAD-1", analysis(requirements).symbols().get(0).name());
  }

  @Test
  void renamesARequirementInAllFilesOrSaysWhyNot() {
    Rename rename = analysis.rename(at("RAD-1"), "RAD-77");
    assertTrue(rename.isAllowed());
    assertTrue(rename.edits().size() > 2, rename.toString());
    assertTrue(rename.edits().stream().allMatch(each -> each.newText().equals("RAD-77")));
    assertEquals(
        "The project names 'RAD-2' already.", analysis.rename(at("RAD-1"), "RAD-2").refusal());
    assertTrue(analysis.rename(at("RAD-1"), "no id").refusal().contains("is no id"));
    assertEquals(
        "There is no id of a requirement here.",
        analysis.renameTarget(new TextPosition(0, 0)).refusal());
  }

  @Test
  void renamesNeitherLongerIdsNorWhatOthersHaveWritten() throws Exception {
    int before = analysis.rename(at("RAD-1"), "RAD-77").edits().size();
    Path notes = project.resolve("notes.md");
    Files.writeString(notes, "RAD-1.2 x.RAD-1 RAD-1-b (see ...RAD-1). RAD-1.\n");
    for (String place : List.of(".git", "target", "recordings", "out", "inner")) {
      Files.createDirectories(project.resolve(place).resolve("deep"));
      Files.writeString(project.resolve(place).resolve("deep/a.md"), "RAD-1\n");
    }
    Files.writeString(project.resolve("inner/eventchain.yaml"), "scenarios: [RAD-1]\n");
    Path locked = Files.createDirectory(project.resolve("locked"));
    locked.toFile().setReadable(false);
    Rename rename = analysis.rename(at("RAD-1"), "RAD-77");
    locked.toFile().setReadable(true);
    List<Integer> columns =
        rename.edits().stream()
            .filter(each -> each.file().equals(notes))
            .map(each -> each.range().start().column())
            .toList();
    assertEquals(List.of(32, 40), columns);
    assertEquals(before + 2, rename.edits().size(), rename.toString());
  }

  @Test
  void proposesIdsWhereOneIsExpected() {
    List<String> ids =
        analysis.completions(at("RAD-1")).stream().map(each -> each.label()).toList();
    assertTrue(ids.contains("RAD-2"), ids.toString());
    assertEquals(List.of(), analysis.completions(at("topped vehicle")));
  }
}
