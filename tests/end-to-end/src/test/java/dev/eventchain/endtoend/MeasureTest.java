package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the command that measures a chain in a recorded trace. */
class MeasureTest {

  private static final Path TRACE =
      Program.ROOT.resolve("bundles/robot/simulation/src/test/resources/tracing/radar-aeb.txt");

  @TempDir Path folder;

  @Test
  void aTraceIsComparedWithTheModel() throws IOException {
    Path project = Program.copyOf("radar-aeb", folder);
    Program.Ended ended = new Program().run("measure", project, TRACE).expect(0);
    assertTrue(ended.out().contains("/aeb/threat to Brake_Request      6 "), ended.out());
    assertTrue(ended.err().contains("2 files in "), ended.err());
    Path model = project.resolve("out/traced/chain.measured.xmi");
    new Program().run("validate", "--metamodel", metamodel(), model).expect(0);
    Files.writeString(
        project.resolve("eventchain-suppressions.yaml"),
        "- id: trace.lost\n  reason: the buffers of this recorder cannot be larger\n  expires: 2999-01-01\n");
    Path lost = folder.resolve("lost.txt");
    Files.writeString(lost, Files.readString(TRACE) + "\nDiscarded events (3 events)\n");
    new Program().run("measure", project, lost).expect(0).says("radar_to_brake");
  }

  private static Path metamodel() {
    return Program.ROOT.resolve("metamodel/eventchain.ecore");
  }

  @Test
  void whatIsNoTraceIsRefused() throws IOException {
    Path project = Program.copyOf("radar-aeb", folder);
    new Program()
        .run("measure", project, project.resolve("eventchain.yaml"))
        .expect(2)
        .says("trace.unreadable");
    new Program()
        .run("measure", project, folder.resolve("nowhere"))
        .expect(2)
        .says("trace.unreadable");
    new Program().run("measure", project).expect(2);
  }
}
