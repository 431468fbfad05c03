package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Tests text changes that fix findings, and cases without a fix. */
class TextFixTest {

  private static final String XML =
      "<a>\n  <data name=\"x\" fieldName=\"rangez\" type=\"y\"/>\n</a>\n";

  private static Optional<String> nearest(String text, String at, String message, String hint) {
    return TextFix.nearestName(text, text.indexOf(at), "xmi", message, hint)
        .map(fix -> fix.apply(text));
  }

  @Test
  void nameThatIsAskedForTakesThePlaceOfTheQuotedOne() {
    assertEquals(
        Optional.of(XML.replace("rangez", "ranges")),
        nearest(XML, "fieldName", "There is no field 'rangez'.", "Did you mean `ranges`?"));
  }

  @Test
  void nothingIsChangedWhereTheTextIsAnotherOne() {
    String changed = XML.replace("rangez", "other");
    assertEquals(
        Optional.empty(),
        nearest(changed, "fieldName", "There is no field 'rangez'.", "Did you mean `ranges`?"));
  }

  @Test
  void nothingIsChangedWhereTheNameStandsTwice() {
    String twice = XML.replace("name=\"x\"", "name=\"rangez\"");
    assertEquals(
        Optional.empty(),
        nearest(twice, "fieldName", "There is no field 'rangez'.", "Did you mean `ranges`?"));
  }

  @Test
  void topicIsFoundWithoutQuotes() {
    String text = "<data name=\"valid\" topicName=\"/radar/targt\"/>";
    assertEquals(
        Optional.of(text.replace("targt", "target")),
        nearest(
            text,
            "topicName",
            "'Radar_Tracking' reads /radar/targt, but no component writes it.",
            "Did you mean `/radar/target`?"));
  }

  @Test
  void hintThatAsksNothingChangesNothing() {
    assertEquals(
        Optional.empty(), nearest(XML, "fieldName", "No 'rangez'.", "Known are `ranges`."));
  }

  @Test
  void nameInAnotherTagIsLeftAlone() {
    String other = XML + "<b fieldName=\"rangez\"/>";
    assertEquals(
        Optional.of(XML.replace("rangez", "ranges") + "<b fieldName=\"rangez\"/>"),
        nearest(other, "<data", "There is no field 'rangez'.", "Did you mean `ranges`?"));
  }

  @Test
  void referenceToNothingGoesWithItsAttribute() {
    String text = "<software name=\"a\" nextstep=\"//@software.99\" origin=\"EXISTING\"/>";
    Optional<TextFix> fix =
        TextFix.withoutReference(text, 5, "`//@software.99` names no element of this file.");
    assertEquals("<software name=\"a\" origin=\"EXISTING\"/>", fix.orElseThrow().apply(text));
  }
}
