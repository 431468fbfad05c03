package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that a verdict is about the texts of requirements that somebody has looked at. */
class AcceptTest {

  private static final String STALE = "project.requirement.stale";

  @TempDir Path folder;
  private ProjectCopy copy;

  @BeforeEach
  void copyTheExample() throws IOException {
    copy = ProjectCopy.of("radar-aeb", folder);
    Files.deleteIfExists(accepted());
  }

  @InTurn
  @Test
  void aReversedRequirementIsNotProvedByOldEvidence() throws IOException {
    copy.run().expect(0).says("4 requirements proved");
    accept("--by", "A. Person").expect(0).says("RAD-1, RAD-2, RAD-3, RAD-4");
    copy.run().expect(0).says("PASSED");
    // Its meaning is reversed in both files, which no comparison of the two can find.
    copy.replace("requirements.md", "RAD-4: The system shall not", "RAD-4: The system shall");
    copy.replace("model/chain.xmi", "The system shall not", "The system shall");
    Program.Ended ended = copy.run().expect(1);
    ended.says("requirements.md:5:1").says(STALE).says("since A. Person looked at");
    ended.says("INCOMPLETE: 2 of 2 scenarios passed").says("3 requirements proved, 1 not tested");
    assertTrue(verdict().contains("\"passed\" : false"), verdict());
    copy.run().expect(1).says(STALE);
    new Program().run("accept", copy.path(), "RAD-4").expect(0);
    copy.run().expect(0).says("PASSED").says("4 requirements proved");
  }

  /** Changes the threshold of RAD-2, also where a criterion quotes it. */
  private void threshold(String from, String to) throws IOException {
    for (String file : List.of("requirements.md", "scenarios/stopped-vehicle-50.yaml")) {
      copy.replace(file, "below " + from + " s", "below " + to + " s");
    }
  }

  @Test
  void onlyWordsCountAndOnlyInAProjectThatKeepsThem() throws IOException {
    threshold("2.6", "12.6");
    copy.run().expect(0).says("project.requirement.changed").says("PASSED");
    threshold("12.6", "2.6");
    accept().expect(0);
    copy.replace("requirements.md", "below 2.6 s.", "\n  below  2.6 s.");
    copy.run().expect(0).says("PASSED");
  }

  @InTurn
  @Test
  void aNewRequirementIsNotAcceptedByTheOthers() throws IOException {
    accept("RAD-1", "RAD-2", "RAD-3").expect(0);
    copy.run().expect(1).says("Nobody has looked at the evidence for RAD-4 yet.");
    accept("RAD-4").expect(0);
    copy.run().expect(0);
  }

  @InTurn
  @Test
  void theVerdictNamesTheTextsThatItIsAbout() throws IOException {
    copy.run().expect(0);
    String first = verdict();
    threshold("2.6", "12.6");
    copy.run().expect(0);
    assertFalse(first.equals(verdict()));
  }

  @Test
  void whatIsAcceptedIsWrittenPlainly() throws IOException {
    accept("RAD-2", "--by", "O'Neill").expect(0);
    String file = Files.readString(accepted());
    assertTrue(file.contains("- requirement: 'RAD-2'\n  text: "), file);
    assertTrue(file.contains("  by: 'O''Neill'\n  on: 20"), file);
    accept("RAD-2", "--by", "Another").expect(0);
    assertEquals(file, Files.readString(accepted()), "the same text is accepted once");
    accept("RAD-9").expect(2).says("'RAD-9' is not a requirement");
    copy.write("accepted.yaml", "- requirement: RAD-1\n  text: a\n  by: me\n  on: May\n");
    new Program().run("validate", copy.path()).expect(1).says("accepted.yaml:4").says("not a date");
    copy.run().expect(2).says("project.accepted");
  }

  private Program.Ended accept(String... more) {
    Object[] arguments = new Object[more.length + 2];
    arguments[0] = "accept";
    arguments[1] = copy.path();
    System.arraycopy(more, 0, arguments, 2, more.length);
    return new Program().run(arguments);
  }

  private Path accepted() {
    return copy.path().resolve("accepted.yaml");
  }

  private String verdict() throws IOException {
    return Files.readString(copy.path().resolve("out/verdict.json"));
  }
}
