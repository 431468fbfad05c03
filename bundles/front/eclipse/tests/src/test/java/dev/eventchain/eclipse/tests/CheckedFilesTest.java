package dev.eventchain.eclipse.tests;

import static dev.eventchain.eclipse.tests.TestProject.CHAIN;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.CheckSummary;
import dev.eventchain.eclipse.ProjectChecks;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the selection of checked files, their checks, and the findings about unchecked files. */
class CheckedFilesTest {

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
      project.buildsTo();
    }
  }

  /** What is checked at first is checked again, also if its ending is in capital letters. */
  @Test
  void filesAreCheckedOnSaveHoweverTheirEndingIsWritten() throws Exception {
    try (TestProject project = TestProject.create("capitals")) {
      project.write("shop.ecore", ECORE);
      project.write("shop.OCL", "context Shop\ninv Named: nam <> ''\n");
      project.build();
      assertEquals(1, project.markers().size(), project.markers().toString());
      project.write("shop.OCL", "context Shop\ninv Named: name <> ''\n");
      project.buildsTo();
    }
  }

  @Test
  void modelOfAnotherMetamodelIsCheckedWithTheRulesBesideIt() throws Exception {
    try (TestProject project = TestProject.create("shop")) {
      project.write("shop.xmi", SHOP.formatted(""));
      project.buildsTo("info shop.xmi editor.model.unchecked");
      project.write("shop.ecore", ECORE);
      project.write("shop.ocl", "context Shop\ninv Named: name <> ''\n");
      project.buildsTo("error shop.xmi:2 ocl.violated");
      project.write("shop.xmi", SHOP.formatted("Corner"));
      project.buildsTo();
    }
  }

  @Test
  void templateOfAProjectMayImportThoseThatShip() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("imports")) {
      String good =
          """
          [module own('http://eventchain.dev/eventchain/1.0')/]
          [import ros2_python::node/]
          [template public main(chain : EventChain)]
          [comment @main/]
          [file (chain.name + '.txt', false, 'UTF-8')][chain.name/][/file]
          [/template]
          """;
      project.write("own.mtl", good);
      project.build();
      List<String> errors =
          project.markers().stream().filter(each -> each.startsWith("error")).toList();
      assertEquals(List.of(), errors);
      project.write("own.mtl", good.replace("ros2_python::node", "ros2_python::nod"));
      project.build();
      assertTrue(
          project.markers().stream().anyMatch(each -> each.startsWith("error own.mtl:2 ")),
          project.markers().toString());
    }
  }

  @Test
  void modelIsKnownByTheNameOfItsMetamodelToo() throws Exception {
    try (TestProject project = TestProject.create("extension")) {
      project.write("shop.ecore", ECORE);
      project.write("shop.ocl", "context Shop\ninv Named: name <> ''\n");
      project.write("corner.shop", SHOP.formatted("Corner"));
      project.buildsTo();
      project.write("corner.shop", SHOP.formatted(""));
      project.buildsTo("error corner.shop:2 ocl.violated");
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
  void chainInAFolderOfOursIsCheckedByTheRulesOfThatFolder() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("variant")) {
      project.write("model/variant.xmi", project.text(CHAIN));
      project.buildsTo();
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
      project.buildsTo("warning rules.ocl editor.rules.none");
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
      assertTrue(markers.stream().noneMatch(each -> each.contains("editor.check.failed")));
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
      assertTrue(markers.contains("error one.xmi editor.unchecked"), markers.toString());
      assertTrue(markers.stream().anyMatch(each -> each.startsWith("error two.xmi:")));
    }
  }

  @Test
  void whatWasNotCheckedIsCountedAndSaidFirst() throws Exception {
    try (TestProject project = TestProject.create("counted")) {
      project.write("shop.xmi", SHOP.formatted(""));
      CheckSummary none = ProjectChecks.of(project.project()).checkAll(null);
      assertEquals(new CheckSummary(1, 1, 0, 0, 0), none);
      assertTrue(none.isEmpty());
      project.write("rules.ocl", "context EventChain\ninv Named: self.name <> ''\n");
      CheckSummary some = ProjectChecks.of(project.project()).checkAll(null);
      assertFalse(some.isEmpty());
      assertEquals(
          "1 of 2 parts not checked: 0 errors, 0 warnings in 2 parts, 0 evaluations", some.words());
    }
  }
}
