package dev.eventchain.m2t;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Tests the parts of texts, which need not be valid templates. */
class TemplatePartsTest {

  private static String parts(String text) {
    return TemplateParts.of(text).stream()
        .map(part -> part.kind() + " " + text.substring(part.start(), part.end()))
        .collect(Collectors.joining("|"));
  }

  @Test
  void validTags() {
    assertEquals(
        "TAG [template public t(c : C)]|TEXT a |TAG [c.name + ']'/]|COMMENT [-- b --]|TAG [/template]",
        parts("[template public t(c : C)]a [c.name + ']'/][-- b --][/template]"));
  }

  @Test
  void commentsThatAreBlocks() {
    assertEquals("COMMENT [comment]a [b] [/comment]|TEXT c", parts("[comment]a [b] [/comment]c"));
  }

  @Test
  void tagsWithoutAnEndAreText() {
    assertEquals("TEXT x [unclosed 'y\n|TAG [for (a)]", parts("x [unclosed 'y\n[for (a)]"));
  }

  @Test
  void closedButWrongTagsAreTags() {
    assertEquals("TEXT x|TAG [0]|TEXT  |TAG [/fro]", parts("x[0] [/fro]"));
  }

  @Test
  void textWithMoreProblemsThanAreReported() {
    String parts = parts("[0]\n".repeat(5000) + "[/for]");
    assertEquals(5001, parts.split("TAG", -1).length - 1);
  }

  @Test
  void words() {
    assertEquals(
        "comment else elseif elselet file for if import let macro module protected query template"
            + " trace",
        String.join(" ", TemplateParts.KEYWORDS));
    assertEquals(
        "after before endTagPrefix extends overrides post private protected public separator"
            + " startTagPrefix super",
        String.join(" ", TemplateParts.MODIFIERS));
  }
}
