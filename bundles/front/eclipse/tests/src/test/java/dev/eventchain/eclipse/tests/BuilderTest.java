package dev.eventchain.eclipse.tests;

import static dev.eventchain.eclipse.tests.TestProject.CHAIN;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.FindingMarker;
import dev.eventchain.eclipse.ProjectChecks;
import dev.eventchain.eclipse.RulePages;
import java.util.List;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IncrementalProjectBuilder;
import org.eclipse.core.runtime.NullProgressMonitor;
import org.eclipse.core.runtime.OperationCanceledException;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** Tests the builder's findings and markers for saved projects. */
class BuilderTest {

  @Test
  void exampleThatPeopleEditHasNoProblem() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("good")) {
      project.buildsTo();
    }
  }

  @Test
  void brokenNextstepIsMarkedAtItsLineAndGoesWhenMended() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("nextstep")) {
      project.build();
      String good = project.text(CHAIN);
      String broken = good.replaceFirst("nextstep=\"[^\"]*\"", "nextstep=\"//@software.99\"");
      project.write(CHAIN, broken);
      project.build();
      IMarker marker = project.marker("xmi.reference.unresolved");
      long line = broken.substring(0, broken.indexOf("//@software.99")).lines().count();
      assertEquals(line, marker.getAttribute(IMarker.LINE_NUMBER, 0));
      assertEquals(IMarker.SEVERITY_ERROR, marker.getAttribute(IMarker.SEVERITY, -1));
      int start = marker.getAttribute(IMarker.CHAR_START, -1);
      int end = marker.getAttribute(IMarker.CHAR_END, -1);
      assertTrue(start >= 0 && end > start && end <= broken.length(), start + " to " + end);
      project.write(CHAIN, good);
      project.buildsTo();
    }
  }

  @Test
  void violatedConstraintNamesItsElementAndHowToMendIt() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("violated")) {
      project.replace(CHAIN, "software name=\"Radar_Tracking\"", "software name=\"class\"");
      project.build();
      IMarker marker = project.marker("ocl.violated");
      assertEquals(
          "SoftwareNode::NodeNameIsIdentifier", marker.getAttribute(FindingMarker.RULE, ""));
      assertTrue(marker.getAttribute(FindingMarker.ELEMENT, "").endsWith("software[class]"));
      assertTrue(marker.getAttribute(IMarker.MESSAGE, "").contains("no keyword of Python"));
      assertTrue(marker.getAttribute(FindingMarker.RELATED, "").contains("eventchain.ocl"));
    }
  }

  @Test
  void ownConstraintThatIsNotUnderstoodIsMarkedInItsFile() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("constraint")) {
      project.write("constraints.ocl", "context SoftwareNode\ninv Fast: self.frequenzy > 1\n");
      project.build();
      List<String> markers = project.markers();
      assertEquals(1, markers.size(), markers.toString());
      assertTrue(markers.get(0).startsWith("error constraints.ocl:2 ocl."), markers.get(0));
      project.write("constraints.ocl", "context SoftwareNode\ninv Fast: self.frequency > 1\n");
      project.buildsTo();
    }
  }

  @Test
  void suppressedFindingHasNoMarker() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("suppressed")) {
      project.replace(CHAIN, "software name=\"Radar_Tracking\"", "software name=\"class\"");
      project.build();
      assertEquals(
          "SoftwareNode::NodeNameIsIdentifier",
          project.marker("ocl.violated").getAttribute(FindingMarker.RULE, ""));
      project.write(
          "eventchain-suppressions.yaml",
          """
          - id: ocl.violated
            rule: SoftwareNode::NodeNameIsIdentifier
            reason: It is renamed in release 2.
            expires: 2999-12-31
          """);
      project.build();
      for (IMarker marker : project.found()) {
        assertEquals("", marker.getAttribute(FindingMarker.RULE, ""), project.markers()::toString);
      }
    }
  }

  @Test
  void projectWithoutAModelSaysThatNothingWasChecked() throws Exception {
    try (TestProject project = TestProject.create("unmodelled")) {
      project.write("eventchain.yaml", "name: unmodelled\n");
      project.write("requirements.md", "- R-1: The system shall brake.\n");
      project.write("software-base/components.json", "[]");
      project.write("software-base/signals.json", "[]");
      project.buildsTo("info eventchain.yaml project.model.missing");
    }
  }

  @Test
  void whyNothingWasCheckedCannotBeSuppressed() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("unsuppressed")) {
      project.write(
          "eventchain-suppressions.yaml",
          """
          - id: xmi.reference.unresolved
            reason: It is fixed in release 2.
            expires: 2999-12-31
          """);
      String good = project.text(CHAIN);
      project.write(CHAIN, good.replaceFirst("nextstep=\"[^\"]*\"", "nextstep=\"//@software.99\""));
      project.build();
      assertEquals(
          IMarker.SEVERITY_ERROR,
          project.marker("xmi.reference.unresolved").getAttribute(IMarker.SEVERITY, -1));
    }
  }

  @Test
  void thePagesOfAllBundlesAreFound() {
    for (String id : List.of("contract.unit.mismatch", "ocl.violated", "xmi.package.unknown")) {
      assertTrue(RulePages.of(id).isPresent(), id);
    }
  }

  @Test
  void entryForASyntaxErrorIsRefused() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("refused")) {
      project.write(
          "eventchain-suppressions.yaml",
          """
          - id: xmi.syntax
            reason: It is fixed in release 2.
            expires: 2999-12-31
          """);
      project.build();
      assertEquals(
          IMarker.SEVERITY_ERROR,
          project.marker("suppression.invalid").getAttribute(IMarker.SEVERITY, -1));
    }
  }

  @Test
  void validatingOneFileLeavesTheMarkersOfOthersAfterAProjectWasOpened() throws Exception {
    try (TestProject project = TestProject.create("others")) {
      project.write("c.ocl", "context (((");
      project.write("d.ocl", "context (((");
      project.build();
      project.project().close(null);
      project.project().open(null);
      ProjectChecks.of(project.project()).check(List.of(project.file("d.ocl")), null);
      assertEquals(2, project.markers().size(), project.markers().toString());
    }
  }

  @Test
  void equalMarkersStayAndDeletedFilesLeaveNone() throws Exception {
    try (TestProject project = TestProject.create("same")) {
      project.write("c.ocl", "context (((");
      project.build();
      long id = project.found()[0].getId();
      project.write("c.ocl", "context (((\n");
      project.build();
      assertEquals(id, project.found()[0].getId());
      project.file("c.ocl").delete(true, null);
      project.buildsTo();
    }
  }

  @Test
  void cancelledBuildIsDoneAgainInFull() throws Exception {
    try (TestProject project = TestProject.create("cancelled")) {
      project.write("c.ocl", "context (((");
      NullProgressMonitor cancelled = new NullProgressMonitor();
      cancelled.setCanceled(true);
      Assertions.assertThrows(
          OperationCanceledException.class,
          () -> project.project().build(IncrementalProjectBuilder.INCREMENTAL_BUILD, cancelled));
      project.build();
      assertEquals(1, project.markers().size(), project.markers().toString());
    }
  }

  @Test
  void cleanRemovesTheMarkersAndTakingTheNatureAwayDoesToo() throws Exception {
    try (TestProject project = TestProject.create("clean")) {
      project.write("c.ocl", "context (((");
      project.build();
      project.project().build(IncrementalProjectBuilder.CLEAN_BUILD, null);
      assertEquals(List.of(), project.markers());
      project.build();
      assertEquals(1, project.markers().size());
      EventchainCore.setNature(project.project(), false, new NullProgressMonitor());
      assertEquals(List.of(), project.markers());
      project.buildsTo();
    }
  }

  @Test
  void reopenedProjectIsCheckedInFull() throws Exception {
    try (TestProject project = TestProject.create("reopened")) {
      project.write("c.ocl", "context (((");
      project.write("d.ocl", "context (((");
      project.build();
      project.project().close(null);
      project.project().open(null);
      project.write("d.ocl", "context SoftwareNode inv Named: name <> ''");
      project.build();
      assertEquals(1, project.markers().size(), project.markers().toString());
      assertTrue(project.markers().get(0).contains("c.ocl"));
    }
  }

  @Test
  void manyFindingsAreCountedRatherThanMarked() throws Exception {
    try (TestProject project = TestProject.create("many")) {
      StringBuilder chain = new StringBuilder();
      chain.append(
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<eventchain:EventChain xmi:version=\"2.0\"");
      chain.append(" xmlns:xmi=\"http://www.omg.org/XMI\"");
      chain.append(" xmlns:eventchain=\"http://eventchain.dev/eventchain/1.0\" name=\"many\">\n");
      for (int i = 0; i < 1500; i++) {
        chain.append("  <software name=\"no name ").append(i).append("\"/>\n");
      }
      project.write("many.xmi", chain + "</eventchain:EventChain>\n");
      project.build();
      IMarker more = project.marker("editor.findings.more");
      assertEquals(1001, project.found().length);
      assertTrue(more.getAttribute(IMarker.MESSAGE, "").matches("Not shown: \\d+ findings more.*"));
      assertEquals(IResource.FILE, more.getResource().getType());
    }
  }
}
