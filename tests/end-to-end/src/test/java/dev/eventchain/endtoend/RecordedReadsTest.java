package dev.eventchain.endtoend;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that files count as sources of a stage because it has read them, whoever named them. */
class RecordedReadsTest {

  private static final String DEMANDS =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <eventchain:EventChain xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
          xmlns:eventchain="http://eventchain.dev/eventchain/1.0" name="demands">
        <requirements id="RAD-2" text="The system shall warn below 2.6 s."/>
      </eventchain:EventChain>
      """;

  @TempDir Path folder;

  @Test
  void aModelThatTheChainRefersToIsASourceToo() throws IOException {
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.replace(
        "model/chain.xmi",
        " satisfies=\"//@requirements.1\" worstCaseExecutionTime=\"2.0\"/>",
        """
         worstCaseExecutionTime="2.0">
            <satisfies href="demands.xmi#//@requirements.0"/>
          </software>\
        """);
    copy.write("model/demands.xmi", DEMANDS);
    validate(copy).says("✓ Design");
    validate(copy).says("= Design");
    copy.write("model/demands.xmi", DEMANDS.replace("2.6", "2.8"));
    validate(copy).says("✓ Design");
  }

  private static Program.Ended validate(ProjectCopy copy) {
    return new Program().run("run", copy.path(), "--to", "validate").expect(0);
  }
}
