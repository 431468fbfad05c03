package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests of sources that are larger than usual, or lead elsewhere. */
class RequirementLimitsTest {

  @TempDir Path folder;

  @Test
  void longTextsAreRead() throws IOException {
    write("types.rsl", "package A\ntype Requirement {\n  text String\n}\n");
    String text = "said \\\"once\\\", ".repeat(20_000);
    write("a.trlc", "package A\nRequirement R {\n  text = \"" + text + "\"\n}\n");
    Requirements read = read("a.trlc");
    assertEquals("A.R", read.items().get(0).id());
    assertTrue(read.items().get(0).text().startsWith("said \"once\", said"));
    assertEquals(260_000 - 1, read.items().get(0).text().length());
  }

  @Test
  void filesThatAreTooLargeAreRefused() throws IOException {
    write("a.sdoc", "\n".repeat((32 << 20) + 1));
    assertTrue(refusal("a.sdoc").contains("longer than 33554432 characters"), refusal("a.sdoc"));
  }

  @Test
  void linksToNothingAreNotOverlooked() throws IOException {
    Path reqs = Files.createDirectories(folder.resolve("reqs"));
    write("reqs/a.sdoc", "[REQUIREMENT]\nUID: A-1\nSTATEMENT: It shall be.\n");
    assertEquals(1, read("reqs").items().size());
    Files.createSymbolicLink(reqs.resolve("b.sdoc"), Path.of("none.sdoc"));
    assertTrue(refusal("reqs").contains("b.sdoc: error: There is no such file."));
    Files.delete(reqs.resolve("b.sdoc"));
    Files.createSymbolicLink(reqs.resolve("circle"), reqs);
    assertTrue(refusal("reqs").contains("[file.unreadable]"), refusal("reqs"));
  }

  /** Lines in which an id, a table or emphasis might begin at each character. */
  @ParameterizedTest
  @ValueSource(strings = {"a-", "a1.", "|-", "*", "[(", "<", "+-", "= ", "1.", ":a:`"})
  void repeatedTextsAreReadInTime(String part) throws IOException {
    String line = part.repeat(9_000 / part.length());
    String text = "- REQ-1: It shall be.\n\n%1$s\n%1$s\n\n| ID | Text |\n|---|---|\n| %1$s | a |\n";
    for (String name : List.of("a.md", "a.rst")) {
      write(name, text.formatted(line) + "\n## " + line + "\n\n- " + line + "\n");
      try {
        read(name);
      } catch (DiagnosticException e) {
        assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      }
    }
  }

  /** Lines as long as they may be, of which each character could end what a pattern looks for. */
  @ParameterizedTest
  @ValueSource(strings = {"## # x", "Type * x", "## < x", "| [ x", "## {# x"})
  void timeGrowsWithTheLengthOfATextOnly(String form) throws IOException {
    String[] parts = form.split(" ", -1);
    String line = parts[0] + " " + (parts[1] + " ").repeat(9_900 / (parts[1].length() + 1)) + "x\n";
    String text = "- REQ-1: It shall be.\n\n" + (line + "\n").repeat((1 << 20) / line.length());
    ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    write("a.md", text);
    long start = clock.getCurrentThreadCpuTime();
    assertEquals("REQ-1", read("a.md").items().get(0).id());
    long seconds = (clock.getCurrentThreadCpuTime() - start) / 1_000_000_000;
    assertTrue(seconds < 5, seconds + " s");
  }

  @Test
  void linesAndDirectivesOfTextsHaveLimits() throws IOException {
    write("a.md", "- REQ-1: " + "a".repeat(10_000) + "\n");
    assertTrue(refusal("a.md").contains("a.md:1:1: error: This line has more than 10000"));
    StringBuilder deep = new StringBuilder();
    for (int i = 0; i < 30; i++) {
      deep.append(" ".repeat(i)).append(".. note::\n\n");
    }
    write("a.rst", deep.toString());
    assertTrue(refusal("a.rst").contains("More than 20 directives are in each other."));
  }

  @Test
  void filesInEachOtherHaveLimits() throws IOException {
    for (int i = 0; i < 30; i++) {
      write(i + ".rst", ".. include:: " + (i + 1) + ".rst\n");
    }
    write("30.rst", "REQ-1: It shall be.\n");
    assertTrue(refusal("0.rst").contains("More than 20 files are in each other"));
    assertEquals("REQ-1", read("12.rst").items().get(0).id());
    for (int i = 18; i < 30; i++) {
      write(i + ".rst", (".. include:: " + (i + 1) + ".rst\n").repeat(2));
    }
    assertTrue(refusal("18.rst").contains("in each other, 1000 in all"), refusal("18.rst"));
  }

  @Test
  void filesThatOthersTakeInBelongToTheSource() throws IOException {
    Path outside = Files.createDirectories(folder.resolve("outside"));
    Path project = Files.createDirectories(folder.resolve("project"));
    Files.writeString(outside.resolve("secret.rst"), "REQ-2: It shall be secret.\n");
    Files.createSymbolicLink(project.resolve("link.rst"), outside.resolve("secret.rst"));
    Files.writeString(project.resolve("part.inc"), "REQ-1: It shall be.\n");
    Files.writeString(project.resolve("a.rst"), ".. include:: part.inc\n.. include:: link.rst\n");
    Files.writeString(project.resolve("eventchain.yaml"), "name: a\nrequirements: a.rst\n");
    ProjectFolder read = new ProjectFolder(project);
    assertTrue(read.requirementFiles().contains(project.resolve("part.inc")));
    assertFalse(read.requirementFiles().contains(project.resolve("link.rst")));
    assertEquals(1, read.readRequirements().items().size());
    String said = DiagnosticFormat.TEXT.render(read.readRequirements().diagnostics());
    assertTrue(said.contains("a.rst:2:1: warning: 'link.rst' is outside of the folders"), said);
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private Requirements read(String source) throws IOException {
    write("eventchain.yaml", "name: radar\nrequirements: " + source + "\n");
    return new ProjectFolder(folder).readRequirements();
  }

  private String refusal(String source) {
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> read(source));
    return DiagnosticFormat.TEXT.render(refused.diagnostics());
  }
}
