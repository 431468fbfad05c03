package dev.eventchain.pipeline.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.project.Project;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which files an export writes, keeps and removes. */
class ProjectExportTest {

  private static final String SCENARIO = "stopped-vehicle-50";

  @TempDir private Path temp;

  private Path project;
  private Path target;

  @BeforeEach
  void copy() throws IOException {
    project = Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), temp.resolve("project"));
    target = temp.resolve("target");
  }

  private WrittenFiles export(String... names) {
    return ProjectExport.write(Project.open(project), List.of(names), target, OnEdit.KEEP);
  }

  private List<String> files() throws IOException {
    try (Stream<Path> files = Files.list(target)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> !name.startsWith("."))
          .sorted()
          .toList();
    }
  }

  private static List<String> rules(WrittenFiles written) {
    return written.diagnostics().stream().map(Diagnostic::id).toList();
  }

  /** Lets a scenario wait for what cannot be said. */
  private void wait(String scenario) throws IOException {
    Path file = project.resolve("scenarios/" + scenario + ".yaml");
    Files.writeString(file, Files.readString(file) + "end_when: ttc < 1 s\n");
  }

  @Test
  void eachScenarioHasTwoFilesAndOthersStay() throws IOException {
    Files.createDirectories(target);
    Files.writeString(target.resolve("notes.txt"), "mine");
    WrittenFiles written = export();
    assertEquals(List.of("export.input"), rules(written));
    assertEquals(
        List.of(
            "notes.txt",
            "short-sight.xodr",
            "short-sight.xosc",
            SCENARIO + ".xodr",
            SCENARIO + ".xosc"),
        files());
    assertEquals("4 files in " + target + ": 4 written", written.summary());
    assertEquals("4 files in " + target + ": 4 unchanged", export().summary());
  }

  @Test
  void oneScenarioMayBeChosen() throws IOException {
    assertEquals(List.of(), rules(export(SCENARIO)));
    assertEquals(List.of(SCENARIO + ".xodr", SCENARIO + ".xosc"), files());
  }

  @Test
  void anUnknownScenarioWritesNothing() {
    DiagnosticException unknown =
        assertThrows(DiagnosticException.class, () -> export(SCENARIO, "no-such"));
    assertEquals("project.scenario.unknown", unknown.diagnostics().get(0).id());
    assertTrue(Files.notExists(target));
  }

  @Test
  void whatCannotBeSaidAnyMoreIsRemoved() throws IOException {
    export();
    wait(SCENARIO);
    WrittenFiles written = export(SCENARIO);
    assertEquals(List.of("export.condition"), rules(written));
    assertEquals(List.of("short-sight.xodr", "short-sight.xosc"), files());
    assertEquals("", written.summary());
  }

  @Test
  void theFilesOfAFormerScenarioAreRemoved() throws IOException {
    export();
    Files.delete(project.resolve("scenarios/short-sight.yaml"));
    assertEquals(List.of(), rules(export()));
    assertEquals(List.of(SCENARIO + ".xodr", SCENARIO + ".xosc"), files());
  }

  @Test
  void anEditedFileIsKept() throws IOException {
    export(SCENARIO);
    Path edited = target.resolve(SCENARIO + ".xosc");
    Files.writeString(edited, "mine");
    assertEquals(List.of("eventchain.file.edited"), rules(export(SCENARIO)));
    assertEquals("mine", Files.readString(edited));
  }

  @Test
  void nothingIsWrittenThroughALink() throws IOException {
    Path outside = Files.writeString(temp.resolve("outside"), "theirs");
    Files.createDirectories(target);
    Files.createSymbolicLink(target.resolve(SCENARIO + ".xodr"), outside);
    export(SCENARIO);
    assertEquals("theirs", Files.readString(outside));
  }

  @Test
  void aFolderThatIsAFileIsAFinding() throws IOException {
    Files.writeString(target, "a file");
    DiagnosticException unwritable =
        assertThrows(DiagnosticException.class, () -> export(SCENARIO));
    assertEquals("output.unwritable", unwritable.diagnostics().get(0).id());
    assertEquals("a file", Files.readString(target));
  }
}
