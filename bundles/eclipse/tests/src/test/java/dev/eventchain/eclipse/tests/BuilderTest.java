package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.FindingMarker;
import dev.eventchain.eclipse.ProjectChecks;
import java.util.List;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IncrementalProjectBuilder;
import org.eclipse.core.runtime.NullProgressMonitor;
import org.eclipse.core.runtime.OperationCanceledException;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** What the builder finds in projects as they are saved, and the markers that it sets. */
class BuilderTest {

  private static final String CHAIN = "model/chain.xmi";

  private static final String ECORE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
          xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shop" nsURI="http://example.org/shop" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Shop">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="name" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  private static final String SHOP =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <shop:Shop xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:shop="http://example.org/shop" name="%s"/>
      """;

  @Test
  void exampleThatPeopleEditHasNoProblem() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("good")) {
      project.build();
      assertEquals(List.of(), project.markers());
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
      project.build();
      assertEquals(List.of(), project.markers());
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
      project.build();
      assertEquals(List.of(), project.markers());
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
      project.build();
      assertEquals(List.of("info eventchain.yaml project.model.missing"), project.markers());
    }
  }

  @Test
  void templateIsCompiledOnSave() throws Exception {
    try (TestProject project = TestProject.create("template")) {
      String good =
          """
          [module main('http://eventchain.dev/eventchain/1.0')/]
          [template public main(chain : EventChain)]
          [comment @main/]
          [file (chain.name + '.txt', false, 'UTF-8')][chain.name/][/file]
          [/template]
          """;
      project.write("main.mtl", good.replace("[chain.name/]", "[chain.nam/]"));
      project.build();
      List<String> markers = project.markers();
      assertEquals(1, markers.size(), markers.toString());
      assertTrue(markers.get(0).startsWith("error main.mtl:4 "), markers.get(0));
      project.write("main.mtl", good);
      project.build();
      assertEquals(List.of(), project.markers());
    }
  }

  @Test
  void modelOfAnotherMetamodelIsCheckedWithTheRulesBesideIt() throws Exception {
    try (TestProject project = TestProject.create("shop")) {
      project.write("shop.xmi", SHOP.formatted(""));
      project.build();
      assertEquals(List.of("info shop.xmi eclipse.model.unchecked"), project.markers());
      project.write("shop.ecore", ECORE);
      project.write("shop.ocl", "context Shop\ninv Named: name <> ''\n");
      project.build();
      assertEquals(List.of("error shop.xmi:2 ocl.violated"), project.markers());
      project.write("shop.xmi", SHOP.formatted("Corner"));
      project.build();
      assertEquals(List.of(), project.markers());
    }
  }

  @Test
  void templateOfAProjectMayImportThoseThatShip() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("imports")) {
      project.write(
          "own.mtl",
          """
          [module own('http://eventchain.dev/eventchain/1.0')/]
          [import ros2_python::node/]
          [template public main(chain : EventChain)]
          [comment @main/]
          [file (chain.name + '.txt', false, 'UTF-8')][chain.name/][/file]
          [/template]
          """);
      project.build();
      List<String> errors =
          project.markers().stream().filter(each -> each.startsWith("error")).toList();
      assertEquals(List.of(), errors);
    }
  }

  @Test
  void modelIsKnownByTheNameOfItsMetamodelToo() throws Exception {
    try (TestProject project = TestProject.create("extension")) {
      project.write("shop.ecore", ECORE);
      project.write("shop.ocl", "context Shop\ninv Named: name <> ''\n");
      project.write("corner.shop", SHOP.formatted("Corner"));
      project.build();
      assertEquals(List.of(), project.markers());
      project.write("corner.shop", SHOP.formatted(""));
      project.build();
      assertEquals(List.of("error corner.shop:2 ocl.violated"), project.markers());
    }
  }

  @Test
  void modelOfAnotherVersionIsAnError() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("version")) {
      project.replace(
          CHAIN, "http://eventchain.dev/eventchain/1.0", "http://eventchain.dev/eventchain/0.9");
      project.write("other.xmi", project.text(CHAIN));
      project.build();
      List<String> markers = project.markers();
      for (String file : List.of(CHAIN, "other.xmi")) {
        assertTrue(
            markers.contains("error " + file + ":2 xmi.package.unknown"), markers.toString());
      }
    }
  }

  @Test
  void whyNothingWasCheckedCannotBeSuppressed() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("unsuppressed")) {
      project.write(
          "eventchain-suppressions.yaml",
          """
          - id: xmi.reference.unresolved
            reason: It is mended in release 2.
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
  void chainInAFolderOfOursIsCheckedByTheRulesOfThatFolder() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("variant")) {
      project.write("model/variant.xmi", project.text(CHAIN));
      project.build();
      assertEquals(List.of(), project.markers());
      project.write("constraints.ocl", "context SoftwareNode\ninv Slow: self.frequency < 2\n");
      project.build();
      for (String file : List.of(CHAIN, "model/variant.xmi")) {
        assertTrue(
            project.markers().stream()
                .anyMatch(m -> m.contains(file) && m.endsWith("ocl.violated")),
            file + ": " + project.markers());
      }
    }
  }

  @Test
  void chainInAPlainProjectIsCheckedByTheRulesBesideIt() throws Exception {
    try (TestProject project = TestProject.create("plain")) {
      project.write(
          "one.eventchain",
          """
          <?xml version="1.0" encoding="UTF-8"?>
          <eventchain:EventChain xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
              xmlns:eventchain="http://eventchain.dev/eventchain/1.0" name="one"/>
          """);
      project.write("rules.ocl", "context EventChain\ninv Two: self.name = 'two'\n");
      project.build();
      assertTrue(
          project.markers().stream()
              .anyMatch(m -> m.startsWith("error one.eventchain:2 ocl.violated")),
          project.markers().toString());
    }
  }

  @Test
  void metamodelsOfOneNamespaceAreErrorsAtBoth() throws Exception {
    try (TestProject project = TestProject.create("twice")) {
      project.write("shop.ecore", ECORE);
      project.write("old/shop.ecore", ECORE);
      project.build();
      List<String> markers = project.markers();
      for (String file : List.of("shop.ecore", "old/shop.ecore")) {
        assertTrue(
            markers.stream().anyMatch(m -> m.startsWith("error " + file)), file + ": " + markers);
      }
    }
  }

  @Test
  void documentWithoutInvariantChecksNothingAndSaysSo() throws Exception {
    try (TestProject project = TestProject.create("empty")) {
      project.write("rules.ocl", "-- later\n");
      project.build();
      assertEquals(List.of("warning rules.ocl eclipse.rules.none"), project.markers());
    }
  }

  @Test
  void brokenFilesOfEachKindAreMarkedAndNothingElseHappens() throws Exception {
    try (TestProject project = TestProject.create("broken")) {
      project.write("a.xmi", "<not xml");
      project.write("b.ecore", "\u0000\u0001");
      project.write("c.ocl", "context (((");
      project.write("d.mtl", "[template");
      project.write("e/eventchain.yaml", "name: [");
      project.build();
      List<String> markers = project.markers();
      for (String file : List.of("a.xmi", "b.ecore", "c.ocl", "d.mtl", "e/eventchain.yaml")) {
        assertTrue(markers.stream().anyMatch(each -> each.contains(file)), file + ": " + markers);
      }
      assertTrue(markers.stream().noneMatch(each -> each.contains("eclipse.check.failed")));
    }
  }

  @Test
  void modelWhoseNeighbourIsBrokenIsSaidToBeUnchecked() throws Exception {
    try (TestProject project = TestProject.create("neighbour")) {
      String chain =
          """
          <?xml version="1.0" encoding="UTF-8"?>
          <eventchain:EventChain xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
              xmlns:eventchain="http://eventchain.dev/eventchain/1.0" name="one">
            <software name="First" frequency="10.0">
              <nextstep href="two.xmi#//@software.0"/>
            </software>
          </eventchain:EventChain>
          """;
      project.write("one.xmi", chain);
      project.write("two.xmi", chain.replace("</software>", ""));
      project.build();
      List<String> markers = project.markers();
      assertTrue(markers.contains("error one.xmi eclipse.unchecked"), markers.toString());
      assertTrue(markers.stream().anyMatch(each -> each.startsWith("error two.xmi:")));
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
      project.build();
      assertEquals(List.of(), project.markers());
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
      project.build();
      assertEquals(List.of(), project.markers());
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
      IMarker more = project.marker("eclipse.findings.more");
      assertEquals(1001, project.found().length);
      assertTrue(
          more.getAttribute(IMarker.MESSAGE, "")
              .matches("Not shown as markers: \\d+ findings more.*"));
      assertEquals(IResource.FILE, more.getResource().getType());
    }
  }
}
