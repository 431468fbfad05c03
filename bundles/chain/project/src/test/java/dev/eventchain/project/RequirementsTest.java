package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.WrittenRequirement;
import java.util.List;
import org.junit.jupiter.api.Test;

class RequirementsTest {

  @Test
  void itemsHaveIdTextAndPlaceAndGoOnInIndentedLines() {
    Requirements read =
        read(
            "# Title\n\nProse: not one.\n\n- AEB-1: The system\n  shall brake.\n* **R2:** Bold.\n");
    assertEquals(
        List.of("AEB-1", "R2"), read.items().stream().map(WrittenRequirement::id).toList());
    assertEquals("The system shall brake.", read.items().get(0).text());
    assertEquals("Bold.", read.items().get(1).text());
    assertEquals(5, read.items().get(0).location().line());
    assertTrue(read.diagnostics().isEmpty(), read.diagnostics().toString());
  }

  @Test
  void entriesOfATaskListAreItems() {
    Requirements read = read("- [ ] CW-1: The wiper shall rest.\n* [x] **CW-2**: It shall run.\n");
    assertEquals(
        List.of("CW-1 The wiper shall rest.", "CW-2 It shall run."),
        read.items().stream().map(item -> item.id() + " " + item.text()).toList());
    assertEquals(List.of(), read.diagnostics());
  }

  @Test
  void theExampleHoldsThePapersSixRequirements() {
    Requirements read =
        Requirements.read(
            SourceText.read(java.nio.file.Path.of("../../../examples/aeb/requirements.md")));
    assertEquals(6, read.items().size());
    assertEquals("AEB-4", read.items().get(3).id());
    assertTrue(read.items().get(3).text().contains("Partial brake"));
  }

  @Test
  void duplicatesEmptyItemsAndEmptyFilesAreFindings() {
    assertEquals(List.of("modeler.requirements.duplicate"), ids(read("- A-1: x\n- A-1: y\n")));
    assertEquals(List.of("modeler.requirements.empty"), ids(read("- A-1:\n")));
    assertEquals(List.of("modeler.requirements.none"), ids(read("Nothing here.\n")));
  }

  private static List<String> ids(Requirements read) {
    return read.diagnostics().stream().map(Diagnostic::id).toList();
  }

  private static Requirements read(String text) {
    return Requirements.read(SourceText.of("requirements.md", text));
  }
}
