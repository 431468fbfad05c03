package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.model.WrittenRequirement;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that requirements are the same ones, whatever format they are kept in. */
class RequirementFormatsTest {

  private static final Path CASES = Path.of("src/test/resources/cases/sources");

  private static final List<String> SAME =
      List.of(
          "RAD-1 = The system shall brake with 9 m/s² below 1.6 s: always. approved"
              + " [braking, radar] []",
          "RAD-1.1 = The radar shall report the distance. draft [] [RAD-1]",
          "a/b = The system shall warn. approved [] [RAD-1]");

  @ParameterizedTest
  @ValueSource(strings = {"reqif", "sdoc", "strictdoc-json", "needs", "trlc", "markdown-table"})
  void allFormatsSayTheSame(String format) {
    assertEquals(SAME, read(format).stream().map(RequirementFormatsTest::described).toList());
  }

  /** The ids of Doorstop are names of files, with the prefix of their document. */
  @ParameterizedTest
  @ValueSource(strings = {"doorstop", "doorstop-markdown"})
  void doorstopSaysTheSameUnderItsOwnIds(String format) {
    List<String> same =
        SAME.stream()
            .map(each -> each.replace("RAD-1.1", "REQ-2").replace("a/b", "REQ-4"))
            .map(each -> each.replace("RAD-1", "REQ-1"))
            .toList();
    assertEquals(
        same,
        read(format).stream()
            .sorted((a, b) -> a.id().compareTo(b.id()))
            .map(RequirementFormatsTest::described)
            .toList());
  }

  private static List<WrittenRequirement> read(String format) {
    return new ProjectFolder(CASES.resolve(format)).readRequirements().items();
  }

  private static String described(WrittenRequirement item) {
    return "%s = %s %s %s %s"
        .formatted(
            item.id(),
            item.text(),
            item.details().status().orElse("-"),
            item.details().tags(),
            item.parentIds());
  }
}
