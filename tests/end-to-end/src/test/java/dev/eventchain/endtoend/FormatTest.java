package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code format}, which formats constraints, templates and the YAML of projects. */
class FormatTest {

  private static final String RULES = "context EventChain\ninv A:self.name<>''\n";

  @TempDir Path folder;

  @Test
  void aFileIsCheckedAndThenFormatted() throws IOException {
    Path rules = Files.writeString(folder.resolve("rules.ocl"), RULES);
    new Program()
        .run("format", "--check", rules)
        .expect(1)
        .says(
            "rules.ocl:2:1: error: The file is not formatted, from this line on. [format.differs]")
        .says("hint: Run 'eventchain format " + rules + "'.")
        .says("1 error, 0 warnings in 1 file");
    assertEquals(RULES, Files.readString(rules));
    new Program().run("format", rules).expect(0).says("formatted " + rules);
    assertEquals("context EventChain\n  inv A: self.name <> ''\n", Files.readString(rules));
    new Program().run("format", "--check", rules).expect(0).says("0 errors, 0 warnings in 1 file");
    new Program().run("format", "--indent=4", rules).expect(0);
    assertTrue(Files.readString(rules).contains("\n    inv A"));
  }

  @Test
  void reportsSuppressionsAndExitCodesAreThoseOfOtherChecks() throws IOException {
    Files.writeString(folder.resolve("eventchain.yaml"), "name: x\n");
    Files.writeString(folder.resolve("rules.ocl"), RULES);
    Path sarif = folder.resolve("r.sarif");
    new Program()
        .run("format", "--check", folder, "--format=json", "--report=sarif=" + sarif)
        .expect(1)
        .says("\"id\" : \"format.differs\"");
    assertTrue(Files.readString(sarif).contains("\"ruleId\" : \"format.differs\""));
    Files.writeString(
        folder.resolve("eventchain-suppressions.yaml"),
        "- id: format.differs\n  file: rules.ocl\n  expires: 2999-01-01\n  reason: As it was.\n");
    new Program().run("format", "--check", folder).expect(0).says("1 suppressed in 3 files");
    new Program().run("format", folder.resolve("none.ocl")).expect(2).says("file.missing");
    Path none = folder.resolve("none.yaml");
    new Program().run("format", folder, "--suppressions", none).expect(2).says("none.yaml");
    assertEquals(RULES, Files.readString(folder.resolve("rules.ocl")));
    new Program().run("format", folder, "-o", folder).expect(2).says("leave out -o");
    new Program().run("format", folder, "--indent=0").expect(2).says("from 1 to 16 columns");
  }

  @Test
  void withoutANameItIsTheProjectAroundTheCurrentFolder() throws IOException {
    Files.writeString(folder.resolve("eventchain.yaml"), "name: x\n");
    Files.writeString(folder.resolve("rules.ocl"), RULES);
    Path inside = Files.createDirectory(folder.resolve("a"));
    new Program()
        .by("env", "-C", inside.toString())
        .run("format", "--check")
        .expect(1)
        .says("../rules.ocl:2:1: error:")
        .says("1 error, 0 warnings in 2 files");
  }
}
