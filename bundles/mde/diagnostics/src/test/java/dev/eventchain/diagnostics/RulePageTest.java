package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class RulePageTest {

  @Test
  void thePagesOfThisBundleAreFoundWithTheirBundle() {
    RulePage page = RulePage.of("file.missing").orElseThrow();
    assertEquals("diagnostics", page.bundle());
    assertEquals("A required file does not exist.", page.firstSentence());
    assertTrue(RulePage.all().contains(page));
  }

  @Test
  void whatIsNoIdHasNoPage() {
    for (String id : List.of("", "file", "file.nothing", "../file.missing", "file.missing.md")) {
      assertEquals(Optional.empty(), RulePage.of(id), id);
    }
  }

  @Test
  void theFirstSentenceEndsWhereTheNextBegins() {
    assertEquals(
        "One, v. 2 of it.", page("# a.b\n\nOne,\nv. 2 of it. Two.\n\nThree.").firstSentence());
    assertEquals("What it is.", page("# a.b\n**What.** What it is. More.\n").firstSentence());
  }

  private static RulePage page(String text) {
    return new RulePage("a.b", "a", text);
  }
}
