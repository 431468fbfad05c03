package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;
import org.eclipse.emf.common.util.Diagnostic;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.util.Diagnostician;
import org.junit.jupiter.api.Test;

/** Tests EMF's own Validate as EMF editors call it: with EMF's resource sets and registries. */
class ChainValidatorTest {

  private static EventChain load(TestProject project) {
    ResourceSet resources = new ResourceSetImpl();
    String path = project.file("model/chain.xmi").getFullPath().toString();
    Resource resource = resources.getResource(URI.createPlatformResourceURI(path, true), true);
    return (EventChain) resource.getContents().get(0);
  }

  private static List<String> messages(Diagnostic diagnostic) {
    return diagnostic.getChildren().stream().map(Diagnostic::getMessage).toList();
  }

  @Test
  void namespaceIsRegisteredSoThatEditorsOfEmfReadModels() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("registered")) {
      assertTrue(load(project).getSoftware().size() > 1);
    }
  }

  @Test
  void goodModelHasNothing() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("validgood")) {
      Diagnostic found = Diagnostician.INSTANCE.validate(load(project));
      assertEquals(List.of(), messages(found));
    }
  }

  @Test
  void violatedConstraintOfTheProjectIsAboutItsElement() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("validbad")) {
      project.write(
          "constraints.ocl",
          "context SoftwareNode\ninv Slow: self.name <> 'Radar_Tracking' or self.frequency < 2\n");
      EventChain chain = load(project);
      Diagnostic found = Diagnostician.INSTANCE.validate(chain);
      assertEquals(1, found.getChildren().size(), messages(found).toString());
      SoftwareNode tracking = chain.getSoftware().get(0);
      assertSame(tracking, found.getChildren().get(0).getData().get(0));
      assertEquals(Diagnostic.ERROR, found.getSeverity());
      Diagnostic ofOther = Diagnostician.INSTANCE.validate(chain.getSoftware().get(1));
      assertEquals(List.of(), messages(ofOther), "it is not about this one");
      Diagnostic ofNode = Diagnostician.INSTANCE.validate(tracking);
      assertEquals(1, ofNode.getChildren().size());
    }
  }

  @Test
  void projectWhoseRulesCannotBeReadIsNotValid() throws Exception {
    try (TestProject project = TestProject.ofRadarExample("validbroken")) {
      project.write("software-base/signals.json", "[");
      Diagnostic found = Diagnostician.INSTANCE.validate(load(project));
      assertEquals(Diagnostic.ERROR, found.getSeverity());
    }
  }
}
