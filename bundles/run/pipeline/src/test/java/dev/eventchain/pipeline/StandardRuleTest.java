package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class StandardRuleTest {

  @Test
  void thePageShowsTheConstraintWithItsComments() {
    String page = StandardRule.page("SoftwareNode::NodeNameIsIdentifier").orElseThrow();
    assertTrue(page.startsWith("# SoftwareNode::NodeNameIsIdentifier\n"), page);
    assertTrue(page.contains("    context SoftwareNode\n      -- @message"), page);
    assertTrue(page.contains("inv NodeNameIsIdentifier:\n"), page);
    assertEquals(1, page.split("\\binv\\b", -1).length - 1, page);
  }

  @Test
  void everyStandardConstraintHasAPage() {
    for (String name : StandardRule.names()) {
      String page = StandardRule.page(name).orElseThrow();
      assertTrue(page.contains(name.replaceFirst(".*::", "inv ")), page);
    }
    assertEquals(Optional.empty(), StandardRule.page("SoftwareNode::Nothing"));
  }
}
