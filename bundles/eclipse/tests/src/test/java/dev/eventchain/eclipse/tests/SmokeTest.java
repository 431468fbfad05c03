package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.ocl.OclRules;
import java.util.List;
import org.eclipse.ui.PlatformUI;
import org.junit.jupiter.api.Test;

class SmokeTest {

  @Test
  void parsesTheStandardConstraintsInsideEquinox() {
    OclRules rules =
        OclRules.parse(
            List.of(XmiStore.standardConstraints()), List.of(EventchainPackage.eINSTANCE));
    assertTrue(rules.constraints().size() > 10);
  }

  @Test
  void hasAWorkbenchWhereThereIsADisplay() {
    Workbench.require();
    assertTrue(Workbench.run(() -> PlatformUI.getWorkbench().getWorkbenchWindowCount()) > 0);
    Workbench.screenshot("workbench");
  }
}
