package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.host.NodeSession.Notice;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.wire.DdsDomain;
import dev.eventchain.simulation.wire.NodeLoss;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests the findings on DDS communication. */
class WireFindingsTest {

  private static final Scenario SCENARIO = AebProject.scenario("slow-approach");

  private static List<String> said(Map<String, Long> lost, Notice... notices) {
    return WireFindings.of(SCENARIO, lost, List.of(notices)).stream()
        .map(each -> each.id() + ": " + each.message())
        .toList();
  }

  @Test
  void whatGotLostIsCounted() {
    assertEquals(
        List.of(
            "simulation.message.lost: Scenario slow-approach: 3 messages on /gap were lost on the way, or arrived too late."),
        said(Map.of("/gap", 3L)));
  }

  @Test
  void deadlinesAndSignsOfLifeThatDdsMissedAreFindings() {
    assertEquals(
        List.of(
            "qos.deadline.missed: Scenario slow-approach: node Brake got no message within the"
                + " deadline on /gap, 2 times.",
            "qos.liveliness.lost: Scenario slow-approach: node Brake got no sign of life from a"
                + " publisher on /gap, 1 times."),
        said(
            Map.of(),
            new Notice("deadline", "Brake", "/gap", 2),
            new Notice("liveliness", "Brake", "/gap", 1)));
  }

  @Test
  void nothingIsSaidWhereNothingHappened() {
    assertEquals(List.of(), said(Map.of()));
  }

  @Test
  void endsThatDidNotMeetAreNamed() {
    DiagnosticException refused =
        NodeLoss.unmatched(
            List.of("node Brake with its reader on /gap"), new UserFiles(Path.of("out/ros2/aeb")));
    Diagnostic found = refused.diagnostics().get(0);
    assertEquals("simulation.wire.unmatched", found.id());
    assertEquals("Not connected in time: node Brake with its reader on /gap.", found.message());
  }

  @Test
  void withoutAFreeDomainNothingIsStarted() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class, () -> DdsDomain.find(number -> "Address already in use"));
    assertEquals("dds.domain.none", refused.diagnostics().get(0).id());
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, refused.reason());
  }
}
